// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_ProgressLine_h
#define limn_viewer_ProgressLine_h

#include <string> // for the task

class vtkAlgorithm;

namespace limn::viewer
{

/// Shows on one line of the terminal how far a VTK algorithm has come, and wipes the line when it
/// goes out of scope. Does nothing where stderr is not a terminal.
class ProgressLine
{
public:
  /// `algorithm` must outlive this object. `task` is "reading teapot.obj".
  ProgressLine(vtkAlgorithm& algorithm, const std::string& task);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

private:
  void show();

  vtkAlgorithm& algorithm_;
  std::string task_;
  unsigned long observer_ = 0; ///< 0: not shown
};

} // namespace limn::viewer

#endif
