#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>

#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/text/version_text.hpp"
#include "core/error.hpp"
#include "engine/ask/query_reader.hpp"
#include "engine/tree/map_tree.hpp"
#include "io/json/trace_file.hpp"

namespace {

using namespace asterism;

/// In the order of the help.
constexpr std::array commands{add_map,      add_query,    add_explain,  add_verify,
                              add_next,     add_test,     add_perceive, add_run,
                              add_simulate, add_evaluate, add_axioms,   add_validate};

int fail(int code, const std::string& message) {
  std::fprintf(stderr, "asterism: %s\n", message.c_str());
  return code;
}

int run(int argc, char** argv) {
  CLI::App app("Every topological map that a robot's trace allows, and the simplest");
  app.name("asterism");
  app.require_subcommand(1);
  app.set_version_flag("--version", std::function<std::string()>(version_text),
                       "Versions of asterism and its libraries");
  app.footer("Each command has a --help with examples.");

  Run chosen;
  for (const auto& add : commands) add(app, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    return fail(exit_usage, error.what() + std::string("; see --help"));
  }
  const int code = chosen();
  if (std::cout.flush().fail() || std::fflush(stdout) != 0)
    return fail(exit_internal, "stdout: found a failure to write; expected the result there");
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const QueryError& error) {
    const int code = fail(exit_usage, error.what());
    std::fprintf(stderr, "%s\n", error.excerpt().c_str());
    return code;
  } catch (const InputError& error) {
    return fail(exit_bad_input, error.what());
  } catch (const PluginError& error) {
    return fail(exit_plugin, error.what());
  } catch (const DifferenceError& error) {
    const int code = fail(exit_internal, error.what());
    const auto json = [](const auto& trace) { return trace_json(trace); };
    std::fputs(std::visit(json, error.shortest).c_str(), stderr);
    return code;
  } catch (const std::exception& error) {
    return fail(exit_internal, error.what());
  }
}
