#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "cli/commands.hpp"

namespace asterism {

/// Adds a command that runs by what was asked of it.
/// @param add_options  gives it the options and arguments that fill an `Asked`
template <class Asked, class Argument>
void add_command(CLI::App& app, Run& chosen, const std::string& name, const std::string& purpose,
                 void (*add_options)(CLI::App&, Asked&), int (*run)(Argument),
                 const std::string& examples) {
  const auto asked = std::make_shared<Asked>();
  CLI::App& command = *app.add_subcommand(name, purpose);
  command.footer(examples);
  add_options(command, *asked);
  command.callback([asked, run, &chosen] { chosen = [asked, run] { return run(*asked); }; });
}

}  // namespace asterism
