#pragma once

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace asterism {

/// Runs a command: prints its result on stdout, progress on stderr, and returns the exit code.
using Run = std::function<int()>;

/// Adds a command and its options; where it is chosen, `chosen` becomes what runs it.
using AddCommand = void(CLI::App& app, Run& chosen);

AddCommand add_map, add_query, add_explain, add_verify, add_next, add_test, add_perceive, add_run,
    add_simulate, add_evaluate, add_axioms, add_validate;

}  // namespace asterism
