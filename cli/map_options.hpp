#pragma once

#include <functional>

#include "cli/options.hpp"

namespace CLI {
class App;
}

namespace asterism {

// Subcommands about the maps of a trace: their arguments are read into `command`, and where one is
// chosen, so is what runs it.

void add_axiom_options(CLI::App& app, AxiomOptions& options);
void add_map(CLI::App& app, MapCommand& command, std::function<int()>& chosen);
void add_query(CLI::App& app, QueryCommand& command, std::function<int()>& chosen);

}  // namespace asterism
