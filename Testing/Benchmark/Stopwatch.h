// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Stopwatch_h
#define Stopwatch_h

#include <chrono>

class Stopwatch
{
public:
  double Milliseconds() const
  {
    return std::chrono::duration<double, std::milli>(Clock::now() - this->Start).count();
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point Start = Clock::now();
};

#endif
