#pragma once

#include <functional>

#include "cli/options.hpp"

namespace CLI {
class App;
}

namespace asterism {

// Subcommands that reason over the maps of a trace: their arguments are read into `command`, and
// where one is chosen, so is what runs it.

void add_query(CLI::App& app, QueryCommand& command, std::function<int()>& chosen);
void add_explain(CLI::App& app, ExplainCommand& command, std::function<int()>& chosen);
void add_verify(CLI::App& app, VerifyCommand& command, std::function<int()>& chosen);
void add_next(CLI::App& app, NextCommand& command, std::function<int()>& chosen);
void add_test(CLI::App& app, TestCommand& command, std::function<int()>& chosen);

}  // namespace asterism
