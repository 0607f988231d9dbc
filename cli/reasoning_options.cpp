#include "cli/reasoning_options.hpp"

#include <CLI/CLI.hpp>

#include "cli/map_options.hpp"

namespace asterism {

void add_query(CLI::App& app, QueryCommand& command, std::function<int()>& chosen) {
  CLI::App& query = *app.add_subcommand("query", "Ask every map that explains a trace");
  query.footer(R"(Examples:
  asterism query examples/aces-stubs.trace.json 'same(0,8)'
  asterism query drive.trace.json 'same(3,9) and not on_path(0,4)' 'places < 9' --planar
  asterism query drive.trace.json 'steps(0,12) <= 2' --over minimal --json - | jq .queries
  asterism query drive.trace.json 'same(2,14)' --assume 'same(0,8)'
docs/queries.md has the grammar. A query is certain, possible or impossible: it holds in all maps,
in some, or in none.
Exit code: 0 all are certain or possible, 1 one is impossible or no map explains the trace,
2 stopped by a limit or Ctrl-C, 64 usage or a text that is no query, 65 bad input or a visit that the
trace does not have, 70 internal fault or a result that cannot be written.)");
  add_maps_of_trace(query, command.map);
  add_assumptions(query, command.map.assume);
  query.add_option("queries", command.queries, "Queries, each one argument")->required();
  query
      .add_option_function<std::string>(
          "--over", [&](const std::string& which) { command.only_minimal = which == "minimal"; },
          "Ask all maps, or the minimal models alone [all]")
      ->check(CLI::IsMember({"all", "minimal"}));
  query.add_option("--json", command.map.json, "Write the answers as JSON; -: alone on stdout")
      ->type_name("FILE");
  add_limits(query, command.map.options);
  query.callback([&] { chosen = [&] { return query_command(command); }; });
}

void add_test(CLI::App& app, TestCommand& command, std::function<int()>& chosen) {
  CLI::App& test = *app.add_subcommand("test", "Ask a folder of traces what is expected of them");
  test.footer(R"(Examples:
  asterism test tests/traces
  asterism test my-traces --junit report.xml --time-limit 60
  asterism test my-traces --update
Of each NAME.trace.json, NAME.expect.json says what is asked and what must come out: how many maps
there are, which are minimal, and the answers to queries; docs/formats.md tells how. --update records
what comes out, of all maps and the planar ones where nothing was asked before.
Exit code: 0 all is as expected, 1 something is not, 2 a limit or Ctrl-C left something undecided,
64 usage, 65 bad input, 70 internal fault or a result that cannot be written.)");
  test.add_option("folder", command.folder, "Folder of *.trace.json and *.expect.json")->required();
  test.add_option("--check", command.check,
                  "Who decides: native, the solver alone, or both compared at every candidate")
      ->check(CLI::IsMember({"native", "solver", "both"}))
      ->capture_default_str();
  test.add_flag("--update", command.update, "Record what comes out instead");
  test.add_option("--junit", command.junit, "Write the results as JUnit XML")->type_name("FILE");
  add_limits(test, command.limits);
  test.callback([&] { chosen = [&] { return test_command(command); }; });
}

}  // namespace asterism
