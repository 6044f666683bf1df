// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"
#include "CompareCommand.h"
#include "InfoCommand.h"
#include "Messages.h"
#include "RenderCommand.h"
#include "UserError.h"
#include "ViewCommand.h"

#include <filesystem>
#include <iostream>
#include <new>

namespace limn::viewer
{
namespace
{

ExitStatus print(const std::string& text)
{
  std::cout << text << std::flush;
  return ExitSuccess;
}

struct Serve
{
  ExitStatus operator()(const RenderRequest& request) const { return render(request.settings); }
  ExitStatus operator()(const ViewRequest& request) const { return view(request.scene); }
  ExitStatus operator()(const InfoRequest& request) const { return info(request.meshes); }
  ExitStatus operator()(const CompareRequest& request) const { return compare(request.settings); }
  ExitStatus operator()(const HelpRequest& request) const { return print(request.text); }
  ExitStatus operator()(const VersionRequest&) const { return print("limn " LIMN_VERSION "\n"); }
};

ExitStatus run(const std::vector<std::string>& arguments)
{
  try
  {
    collectMessages();
    return std::visit(Serve(), parseArguments(arguments));
  }
  catch (const UserError& error)
  {
    printError(error.what());
  }
  catch (const std::filesystem::filesystem_error& error)
  {
    printError(error.what());
  }
  catch (const std::bad_alloc&)
  {
    printError("not enough memory; choose a smaller --resolution or a smaller mesh");
  }
  return ExitUserError;
}

} // namespace
} // namespace limn::viewer

int main(int argc, char* argv[])
{
  return limn::viewer::run(std::vector<std::string>(argv + 1, argv + argc));
}
