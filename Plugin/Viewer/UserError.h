// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_UserError_h
#define limn_viewer_UserError_h

#include <stdexcept> // for std::runtime_error
#include <string>    // for std::string

namespace limn::viewer
{

/// What the program exits with.
enum ExitStatus
{
  ExitSuccess = 0,
  ExitUserError = 2,
  ExitPicturesDiffer = 3
};

/// Something that the user can mend. what() is one line that names the thing and the mend; main()
/// prints it after "limn: error: " and exits with ExitUserError.
class UserError : public std::runtime_error
{
public:
  explicit UserError(const std::string& message) : std::runtime_error(message) {}
};

} // namespace limn::viewer

#endif
