// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnRenderWindowInteractor.h"

#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <thread>

/// Timers that run, by the numbers that InternalCreateTimer() gave them.
class vtkLimnRenderWindowInteractor::vtkTimers
{
public:
  using Clock = std::chrono::steady_clock;

  int Add(std::chrono::milliseconds period, bool isRepeating)
  {
    this->Running[++this->LastNumber] = { period, Clock::now() + period, isRepeating };
    return this->LastNumber;
  }

  bool Remove(int number) { return this->Running.erase(number) > 0; }
  bool IsEmpty() const { return this->Running.empty(); }

  /// Waits until the next timer is due, and returns its number. Requires: there is one.
  int WaitForNext()
  {
    const auto next = std::min_element(this->Running.begin(), this->Running.end(),
      [](const auto& a, const auto& b) { return a.second.Due < b.second.Due; });
    const int number = next->first;
    Timer& timer = next->second;
    std::this_thread::sleep_until(timer.Due);
    if (timer.IsRepeating)
    {
      timer.Due = Clock::now() + timer.Period;
    }
    else
    {
      this->Running.erase(next);
    }
    return number;
  }

private:
  struct Timer
  {
    std::chrono::milliseconds Period;
    Clock::time_point Due;
    bool IsRepeating;
  };

  std::map<int, Timer> Running;
  int LastNumber = 0;
};

vtkStandardNewMacro(vtkLimnRenderWindowInteractor);

//------------------------------------------------------------------------------
vtkLimnRenderWindowInteractor::vtkLimnRenderWindowInteractor() : Timers(new vtkTimers) {}

//------------------------------------------------------------------------------
vtkLimnRenderWindowInteractor::~vtkLimnRenderWindowInteractor() = default;

//------------------------------------------------------------------------------
void vtkLimnRenderWindowInteractor::Initialize()
{
  if (!this->RenderWindow)
  {
    vtkErrorMacro("No render window: call SetRenderWindow() first.");
    return;
  }
  if (this->Initialized)
  {
    return;
  }
  this->Initialized = 1;
  const int* size = this->RenderWindow->GetSize();
  this->Size[0] = size[0];
  this->Size[1] = size[1];
  this->Enable();
}

//------------------------------------------------------------------------------
void vtkLimnRenderWindowInteractor::StartEventLoop()
{
  // As a window on a screen when it is first shown.
  if (this->RenderWindow->GetNeverRendered())
  {
    this->Render();
  }
  while (!this->Done && !this->Timers->IsEmpty())
  {
    int timerId = this->GetVTKTimerId(this->Timers->WaitForNext());
    this->InvokeEvent(vtkCommand::TimerEvent, &timerId);
  }
}

//------------------------------------------------------------------------------
int vtkLimnRenderWindowInteractor::InternalCreateTimer(
  int vtkNotUsed(timerId), int timerType, unsigned long duration)
{
  return this->Timers->Add(std::chrono::milliseconds(duration), timerType == RepeatingTimer);
}

//------------------------------------------------------------------------------
int vtkLimnRenderWindowInteractor::InternalDestroyTimer(int platformTimerId)
{
  return this->Timers->Remove(platformTimerId) ? 1 : 0;
}

//------------------------------------------------------------------------------
void vtkLimnRenderWindowInteractor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
