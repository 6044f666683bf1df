// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ProgressLine.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>

#include <unistd.h>

#include <iostream>

namespace limn::viewer
{
namespace
{

constexpr const char* kWipeLine = "\r\x1b[K";

}

ProgressLine::ProgressLine(vtkAlgorithm& algorithm, const std::string& task)
  : algorithm_(algorithm), task_(task)
{
  if (isatty(STDERR_FILENO))
  {
    this->observer_ = algorithm.AddObserver(vtkCommand::ProgressEvent, this, &ProgressLine::show);
  }
}

ProgressLine::~ProgressLine()
{
  if (this->observer_ != 0)
  {
    this->algorithm_.RemoveObserver(this->observer_);
    std::cerr << kWipeLine << std::flush;
  }
}

void ProgressLine::show()
{
  const int percent = static_cast<int>(100 * this->algorithm_.GetProgress());
  std::cerr << kWipeLine << "limn: " << this->task_ << ' ' << percent << '%' << std::flush;
}

} // namespace limn::viewer
