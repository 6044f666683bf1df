// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_OptionList_h
#define limn_viewer_OptionList_h

#include <CLI/App.hpp>       // for CLI::App
#include <CLI/Config.hpp>    // for what App.hpp declares
#include <CLI/Formatter.hpp> // for what App.hpp declares

#include <functional> // for readers of values
#include <memory>     // for std::unique_ptr
#include <set>        // for the names of switches
#include <string>     // for names and values
#include <vector>     // for arguments

namespace limn::viewer
{

/// The options of one verb: declares them, reads them, explains them.
class OptionList
{
public:
  using Reader = std::function<void(const std::string& option, const std::string& text)>;

  /// `verb` is "render", `summary` the first line of its help.
  OptionList(const std::string& verb, const std::string& summary);

  /// The options added from here on stand under this heading in the help.
  void startGroup(const std::string& heading);

  /// An option `--name=form`, given at most once. `read` gets "--name" and the text.
  void add(
    const std::string& name, const std::string& form, const std::string& help, const Reader& read);
  /// The same for an option that may be given several times.
  void addRepeatable(
    const std::string& name, const std::string& form, const std::string& help, const Reader& read);
  /// An option without a value.
  void addSwitch(const std::string& name, const std::string& help, bool& value);
  /// The arguments that are no options.
  void addFiles(const std::string& form, const std::string& help, std::vector<std::string>& files);

  /// Reads all arguments after the verb. Returns false if they ask for help instead.
  /// Throws UserError for an option that is unknown, not served, repeated, or lacks its value, and
  /// lets the readers' errors pass.
  bool read(const std::vector<std::string>& arguments);

  std::string help() const;

private:
  void refuseSwitchValues(const std::vector<std::string>& arguments) const;
  void refuseUnknown() const;

  std::string verb_;
  std::string group_ = "Options";
  std::set<std::string> switches_;
  std::unique_ptr<CLI::App> app_;
};

} // namespace limn::viewer

#endif
