// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Messages_h
#define Messages_h

#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"

#include <string>

/// Collects VTK's messages while it lives.
class Messages
{
public:
  Messages() : Before(vtkOutputWindow::GetInstance()), Collector(vtkSmartPointer<Window>::New())
  {
    vtkOutputWindow::SetInstance(this->Collector);
  }
  ~Messages() { vtkOutputWindow::SetInstance(this->Before); }
  Messages(const Messages&) = delete;
  void operator=(const Messages&) = delete;

  const std::string& GetText() const { return this->Collector->Text; }
  void Forget() { this->Collector->Text.clear(); }

  int Count(const std::string& part) const
  {
    int count = 0;
    for (size_t at = this->GetText().find(part); at != std::string::npos;
         at = this->GetText().find(part, at + 1))
    {
      ++count;
    }
    return count;
  }

private:
  class Window : public vtkOutputWindow
  {
  public:
    static Window* New() { VTK_STANDARD_NEW_BODY(Window); }
    vtkTypeMacro(Window, vtkOutputWindow)
    void DisplayText(const char* text) override { this->Text += text; }
    std::string Text;
  };

  vtkSmartPointer<vtkOutputWindow> Before;
  vtkSmartPointer<Window> Collector;
};

#endif
