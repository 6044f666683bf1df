// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_Arguments_h
#define limn_viewer_Arguments_h

#include "RenderSettings.h" // for the results

#include <string>  // for the arguments
#include <variant> // for the verbs
#include <vector>  // for the arguments

/// The command line as text on one side and plain settings on the other. Knows no VTK, touches no
/// file.
namespace limn::viewer
{

struct RenderRequest
{
  RenderSettings settings;
};

struct ViewRequest
{
  SceneSettings scene;
};

struct InfoRequest
{
  std::vector<std::string> meshes;
};

struct CompareRequest
{
  CompareSettings settings;
};

struct HelpRequest
{
  std::string text; ///< ready to print
};

struct VersionRequest
{
};

using Request = std::variant<RenderRequest, ViewRequest, InfoRequest, CompareRequest, HelpRequest,
  VersionRequest>;

/// Reads the arguments after the program's name.
/// Throws UserError for an unknown verb, option or value, an option that this version does not
/// serve, a number that is not finite or out of range, and a missing mesh or output.
Request parseArguments(const std::vector<std::string>& arguments);

} // namespace limn::viewer

#endif
