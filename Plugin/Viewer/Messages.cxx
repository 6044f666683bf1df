// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include "UserError.h"

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <algorithm>
#include <cctype>
#include <iostream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

namespace limn::viewer
{
namespace
{

/// By the addresses that VTK's messages have.
std::map<std::string, std::string>& filesOfObjects()
{
  static std::map<std::string, std::string> files;
  return files;
}

/// "ERROR: In file, line 1\nvtkFoo (0x1): the message\n\n" as "the message", after the file of the
/// object if nameFileOf() has told it.
std::string messageIn(const char* vtkText)
{
  static const std::regex source("^(ERROR|Warning|Generic Warning): In [^\n]*\n");
  static const std::regex object("^[A-Za-z0-9_]+ \\(((0x)?[0-9a-fA-F]+)\\): ");
  std::string text = vtkText ? vtkText : "";
  text = std::regex_replace(text, source, "", std::regex_constants::format_first_only);
  std::string file;
  if (std::smatch match; std::regex_search(text, match, object))
  {
    const auto named = filesOfObjects().find(match[1].str());
    file = named == filesOfObjects().end() ? "" : named->second;
    text = match.suffix().str();
  }
  text.erase(std::find_if(text.rbegin(), text.rend(),
               [](unsigned char letter) { return !std::isspace(letter); })
               .base(),
    text.end());
  std::replace(text.begin(), text.end(), '\n', ' ');
  return file.empty() || text.find(file) != std::string::npos ? text : file + ": " + text;
}

/// VTK's pipeline reports each failure of a filter a second time, with addresses.
bool isConsequence(const std::string& message)
{
  return message.rfind("Algorithm vtk", 0) == 0;
}

void printOnce(const std::string& line)
{
  static std::set<std::string> printed;
  if (printed.insert(line).second)
  {
    std::cerr << line << std::endl;
  }
}

class MessageWindow : public vtkOutputWindow
{
public:
  static MessageWindow* New() { VTK_STANDARD_NEW_BODY(MessageWindow); }

  void DisplayText(const char* text) override { printWarning(messageIn(text)); }
  void DisplayWarningText(const char* text) override { printWarning(messageIn(text)); }
  void DisplayGenericWarningText(const char* text) override { printWarning(messageIn(text)); }
  void DisplayErrorText(const char* text) override
  {
    const std::string message = messageIn(text);
    if (!isConsequence(message))
    {
      this->Errors.push_back(message);
    }
  }

  std::vector<std::string> Errors;

protected:
  MessageWindow() = default;
  ~MessageWindow() override = default;

private:
  MessageWindow(const MessageWindow&) = delete;
  void operator=(const MessageWindow&) = delete;
};

} // namespace

void collectMessages()
{
  vtkNew<MessageWindow> window;
  vtkOutputWindow::SetInstance(window);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

void throwCollectedErrors(const std::string& subject)
{
  auto* const window = dynamic_cast<MessageWindow*>(vtkOutputWindow::GetInstance());
  if (!window || window->Errors.empty())
  {
    return;
  }
  std::vector<std::string> errors;
  errors.swap(window->Errors);
  for (std::string& error : errors)
  {
    if (error.find(subject) == std::string::npos)
    {
      error = subject + ": " + error;
    }
  }
  for (std::size_t i = 0; i + 1 < errors.size(); ++i)
  {
    if (errors[i] != errors.back())
    {
      printError(errors[i]);
    }
  }
  throw UserError(errors.back());
}

void nameFileOf(vtkObject& object, const std::string& file)
{
  std::ostringstream address;
  address << static_cast<void*>(&object);
  filesOfObjects()[address.str()] = file;
}

void printWarning(const std::string& message)
{
  printOnce("limn: warning: " + message);
}

void printError(const std::string& message)
{
  printOnce("limn: error: " + message);
}

} // namespace limn::viewer
