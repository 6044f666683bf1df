// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Program.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fcntl.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>

namespace limn::testing
{
namespace
{

[[noreturn]] void replaceByLimn(const std::vector<std::string>& arguments)
{
  std::vector<char*> argv = { const_cast<char*>(LIMN_PROGRAM) };
  for (const std::string& argument : arguments)
  {
    argv.push_back(const_cast<char*>(argument.c_str()));
  }
  argv.push_back(nullptr);
  execv(LIMN_PROGRAM, argv.data());
  _exit(127);
}

void redirect(int descriptor, const std::string& file)
{
  const int target = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(target, descriptor);
  close(target);
}

int waitFor(pid_t child)
{
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Runs `limn` after `prepare` in the new process.
Outcome run(const std::vector<std::string>& arguments, const std::function<void()>& prepare)
{
  const Folder folder;
  const std::string out = folder.file("out");
  const std::string err = folder.file("err");
  const pid_t child = fork();
  if (child == 0)
  {
    redirect(STDOUT_FILENO, out);
    redirect(STDERR_FILENO, err);
    prepare();
    replaceByLimn(arguments);
  }
  Outcome outcome;
  outcome.status = waitFor(child);
  outcome.out = bytesOf(out);
  outcome.err = bytesOf(err);
  return outcome;
}

int bigEndian(const std::string& bytes, std::size_t offset)
{
  int number = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    number = number * 256 + static_cast<unsigned char>(bytes[offset + i]);
  }
  return number;
}

} // namespace

Outcome runLimn(const std::vector<std::string>& arguments, const Environment& environment)
{
  return run(arguments,
    [&]
    {
      unsetenv("DISPLAY");
      for (const auto& [name, value] : environment)
        setenv(name.c_str(), value.c_str(), 1);
    });
}

Outcome runLimnWithFileLimit(const std::vector<std::string>& arguments, unsigned long bytes)
{
  return run(arguments,
    [&]
    {
      const rlimit limit = { bytes, bytes };
      setrlimit(RLIMIT_FSIZE, &limit);
      // Without this the kernel ends the program; with it, write() fails as it does on a full disk.
      signal(SIGXFSZ, SIG_IGN);
    });
}

pid_t startLimn(const std::vector<std::string>& arguments, const std::string& err)
{
  const pid_t child = fork();
  if (child == 0)
  {
    redirect(STDERR_FILENO, err);
    replaceByLimn(arguments);
  }
  return child;
}

std::string meshFile(const std::string& name)
{
  return std::string(LIMN_MESHES) + "/" + name;
}

Folder::Folder()
{
  std::string name = (std::filesystem::temp_directory_path() / "limn-test-XXXXXX").string();
  if (!mkdtemp(name.data()))
    throw std::runtime_error("no temporary folder");
  path_ = name;
}

Folder::~Folder()
{
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string Folder::write(const std::string& name, const std::string& content) const
{
  std::ofstream(file(name), std::ios::binary) << content;
  return file(name);
}

std::vector<std::string> Folder::names() const
{
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_))
  {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string bytesOf(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), {} };
}

PngHeader pngHeader(const std::string& file)
{
  const std::string bytes = bytesOf(file);
  constexpr std::size_t kHeaderSize = 26;
  if (bytes.size() < kHeaderSize || bytes.compare(1, 3, "PNG") != 0 || bytes[24] != 8)
    return {};
  const std::map<int, int> channelsOfColorType = { { 0, 1 }, { 2, 3 }, { 4, 2 }, { 6, 4 } };
  return { bigEndian(bytes, 16), bigEndian(bytes, 20), channelsOfColorType.at(bytes[25]) };
}

} // namespace limn::testing
