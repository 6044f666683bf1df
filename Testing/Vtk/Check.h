// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Check_h
#define Check_h

#include <cstdlib>
#include <iostream>

/// Tells and counts what is not as a test wants it, and goes on.
inline int& failures()
{
  static int count = 0;
  return count;
}

#define CHECK(condition)                                                                           \
  do                                                                                               \
  {                                                                                                \
    if (!(condition))                                                                              \
    {                                                                                              \
      std::cerr << __FILE__ << ":" << __LINE__ << ": not true: " << #condition << std::endl;       \
      ++failures();                                                                                \
    }                                                                                              \
  } while (false)

#define CHECK_EQUAL(actual, expected)                                                              \
  do                                                                                               \
  {                                                                                                \
    const auto actualValue = (actual);                                                             \
    const auto expectedValue = (expected);                                                         \
    if (!(actualValue == expectedValue))                                                           \
    {                                                                                              \
      std::cerr << __FILE__ << ":" << __LINE__ << ": " << #actual << " is " << actualValue         \
                << ", not " << expectedValue << std::endl;                                         \
      ++failures();                                                                                \
    }                                                                                              \
  } while (false)

inline int result()
{
  return failures() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

#endif
