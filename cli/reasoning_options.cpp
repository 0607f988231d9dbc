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
docs/queries.md has the grammar. A query is certain, possible or impossible: it holds in all maps,
in some, or in none.
Exit code: 0 all are certain or possible, 1 one is impossible or no map explains the trace,
2 stopped by a limit or Ctrl-C, 64 usage or a text that is no query, 65 bad input or a visit that the
trace does not have, 70 internal fault or a result that cannot be written.)");
  add_maps_of_trace(query, command.map);
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

void add_next(CLI::App& app, NextCommand& command, std::function<int()>& chosen) {
  CLI::App& next = *app.add_subcommand("next", "Say which ways on from a trace are worth trying");
  next.footer(R"(Examples:
  asterism next examples/aces-stubs.trace.json --planar
  asterism next drive.trace.json --max-travels 6 --svg exits.svg
  asterism next drive.trace.json --json - | jq '.exits[0]'
An exit is an arm to leave the last visit by, and where more travels follow, for each how many arms
clockwise of the one come in by the robot leaves: 0 leads back. docs/next.md tells what is expected.
Exit code: 0 there is a map, 1 none explains the trace, 2 stopped by a limit or Ctrl-C, 64 usage,
65 bad input, 70 internal fault or a result that cannot be written.)");
  add_maps_of_trace(next, command.map);
  next.add_option("--max-travels", command.bounds.travels, "Look for exits so many travels away")
      ->type_name("N")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  next.add_option("--json", command.map.json, "Write what was found as JSON; -: alone on stdout")
      ->type_name("FILE");
  next.add_option("--svg", command.svg, "Draw the exits with the maps left at each")
      ->type_name("FILE");
  add_limits(next, command.map.options);
  next.callback([&] { chosen = [&] { return next_command(command); }; });
}

}  // namespace asterism
