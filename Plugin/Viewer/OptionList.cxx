// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionList.h"

#include "ParseValue.h" // for inSmallLetters
#include "UserError.h"

#include <algorithm>
#include <map>

namespace limn::viewer
{
namespace
{

/// Options of the full command line that this version does not serve, and what to do instead.
const std::map<std::string, std::string>& unservedOptions()
{
  static const std::map<std::string, std::string> options = {
    { "--edges", "leave it out" },
    { "--line-width", "leave it out" },
    { "--point-size", "leave it out" },
  };
  return options;
}

std::string nameOf(const std::string& argument)
{
  return argument.substr(0, argument.find('='));
}

/// The parser would take the next argument for the value.
void refuseEmptyValues(const std::vector<std::string>& arguments)
{
  for (const std::string& argument : arguments)
  {
    if (argument.rfind("--", 0) == 0 && argument.find('=') == argument.size() - 1)
    {
      throw UserError(argument + " has no value; see --help");
    }
  }
}

} // namespace

OptionList::OptionList(const std::string& verb, const std::string& summary)
  : verb_(verb), app_(std::make_unique<CLI::App>(summary, "limn " + verb))
{
  this->app_->allow_extras();
  this->app_->set_help_flag("--help", "print this text");
  this->app_->get_formatter()->column_width(46);
}

void OptionList::startGroup(const std::string& heading)
{
  this->group_ = heading;
}

void OptionList::add(
  const std::string& name, const std::string& form, const std::string& help, const Reader& read)
{
  this->addRepeatable(name, form, help,
    [read, seen = false](const std::string& option, const std::string& text) mutable
    {
      if (seen)
      {
        throw UserError(option + " is given twice; give it once");
      }
      seen = true;
      read(option, text);
    });
}

void OptionList::addRepeatable(
  const std::string& name, const std::string& form, const std::string& help, const Reader& read)
{
  CLI::Option* const option = this->app_->add_option(
    name,
    [name, read](const CLI::results_t& texts)
    {
      for (const std::string& text : texts)
      {
        read(name, text);
      }
      return true;
    },
    help);
  option->type_name(form)->group(this->group_);
  option->expected(1)->allow_extra_args(false);
  option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void OptionList::addSwitch(const std::string& name, const std::string& help, bool& value)
{
  this->app_->add_flag(name, value, help)->group(this->group_)->disable_flag_override();
  this->switches_.insert(name);
}

void OptionList::addFiles(
  const std::string& form, const std::string& help, std::vector<std::string>& files)
{
  this->app_->add_option(form, files, help)->type_name(" ")->group(this->group_);
}

bool OptionList::read(const std::vector<std::string>& arguments)
{
  refuseEmptyValues(arguments);
  this->refuseSwitchValues(arguments);
  try
  {
    // CLI11 reads a vector from its end.
    this->app_->parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  }
  catch (const CLI::CallForHelp&)
  {
    return false;
  }
  catch (const CLI::ParseError& error)
  {
    throw UserError(std::string(error.what()) + "; see \"limn help " + this->verb_ + "\"");
  }
  this->refuseUnknown();
  return true;
}

void OptionList::refuseSwitchValues(const std::vector<std::string>& arguments) const
{
  for (const std::string& argument : arguments)
  {
    const std::string name = nameOf(argument);
    if (name != argument && this->switches_.count(name) != 0)
    {
      throw UserError(argument + ": " + name + " takes no value");
    }
  }
}

void OptionList::refuseUnknown() const
{
  for (const std::string& argument : this->app_->remaining())
  {
    const std::string name = nameOf(argument);
    // What follows this mark is files, whatever they look like; the parser leaves the mark itself.
    if (name == "--")
    {
      continue;
    }
    const auto unserved = unservedOptions().find(name);
    if (unserved != unservedOptions().end())
    {
      throw UserError(name + " is not served by this version; " + unserved->second);
    }
    const std::string small = inSmallLetters(name);
    if (small != name && this->app_->get_option_no_throw(small))
    {
      throw UserError("unknown option " + name + "; write it in small letters: " + small);
    }
    const std::string kind = name.rfind("-", 0) == 0 ? "option " : "argument ";
    throw UserError("unknown " + kind + name + "; see \"limn help " + this->verb_ + "\"");
  }
}

std::string OptionList::help() const
{
  return this->app_->help();
}

} // namespace limn::viewer
