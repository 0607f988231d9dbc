#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/options.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace asterism {

void add_axiom_options(CLI::App& app, AxiomOptions& options);
/// The trace, and which maps of it there are.
void add_maps_of_trace(CLI::App& app, MapCommand& command);
/// Who decides; to be given beside add_maps_of_trace.
void add_check(CLI::App& app, MapOptions& options);
/// What is known beside the trace.
void add_assumptions(CLI::App& app, std::vector<std::string>& texts);
/// Threads of the search for minimal models.
CLI::Option& add_jobs(CLI::App& app, unsigned& jobs);
/// When to stop.
void add_limits(CLI::App& app, MapOptions& options);

/// `asterism map`: its arguments are read into `command`, and where it is chosen, so is what runs
/// it.
void add_map(CLI::App& app, MapCommand& command, std::function<int()>& chosen);

}  // namespace asterism
