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
  asterism query drive.trace.json 'route(12,0)' --planar
docs/queries.md has the grammar. A query is certain, possible or impossible: it holds in all maps,
in some, or in none. A route is turns and travels that lead there in all.
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

}  // namespace asterism
