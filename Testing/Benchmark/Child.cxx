// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Child.h"

#include <cstdio>
#include <exception>
#include <stdexcept>

#include <sys/wait.h>
#include <unistd.h>

namespace
{
/// Returns the child's exit status.
int Answer(const std::function<std::vector<double>()>& work, int pipe)
{
  try
  {
    const std::vector<double> numbers = work();
    const ssize_t size = static_cast<ssize_t>(numbers.size() * sizeof(double));
    return write(pipe, numbers.data(), size) == size ? 0 : 1;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
}

std::vector<double> InChild(const std::function<std::vector<double>()>& work)
{
  int ends[2];
  std::fflush(nullptr); // or both would print what is buffered
  if (pipe(ends) != 0)
  {
    throw std::runtime_error("No pipe to a child process.");
  }
  const pid_t child = fork();
  if (child < 0)
  {
    throw std::runtime_error("No child process.");
  }
  if (child == 0)
  {
    close(ends[0]);
    _exit(Answer(work, ends[1]));
  }
  close(ends[1]);
  std::vector<double> numbers;
  double number = 0;
  while (read(ends[0], &number, sizeof number) == static_cast<ssize_t>(sizeof number))
  {
    numbers.push_back(number);
  }
  close(ends[0]);
  int status = 0;
  if (waitpid(child, &status, 0) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
  {
    throw std::runtime_error("A child process failed.");
  }
  return numbers;
}
