#include "cli/reasoning_options.hpp"

#include <CLI/CLI.hpp>

#include "cli/map_options.hpp"
#include "cli/option_checks.hpp"

namespace asterism {
namespace {

void add_over(CLI::App& app, bool& only_minimal, unsigned& jobs, const std::string& what) {
  app.add_option_function<std::string>(
         "--over", [&](const std::string& which) { only_minimal = which == "minimal"; },
         what + " [all]")
      ->check(CLI::IsMember({"all", "minimal"}));
  add_jobs(app, jobs);
  app.parse_complete_callback([&] {
    if (app.get_option("--jobs")->count() > 0 && !only_minimal)
      throw CLI::RequiresError("--jobs", "--over minimal");
  });
}

}  // namespace

void add_query(CLI::App& app, QueryCommand& command, std::function<int()>& chosen) {
  CLI::App& query = *app.add_subcommand("query", "Ask every map that explains a trace");
  query.footer(R"(Examples:
  asterism query examples/aces-stubs.trace.json 'same(0,8)'
  asterism query drive.trace.json 'same(3,9) and not on_path(0,4)' 'places < 9' --planar
  asterism query drive.trace.json 'steps(0,12) <= 2' --over minimal --json - | jq .queries
  asterism query drive.trace.json 'same(2,14)' --assume 'same(0,8)'
  asterism query drive.trace.json 'route(12,0)' --planar
docs/queries.md has the grammar. A query is certain, possible or impossible: it holds in all maps,
in some, or in none. A route is turns and travels that lead there in all.
Exit code: 0 all are certain or possible, 1 one is impossible or no map explains the trace,
2 stopped by a limit or Ctrl-C, 64 usage or a text that is no query, 65 bad input or a visit that the
trace does not have, 70 internal fault or a result that cannot be written.)");
  add_maps_of_trace(query, command.map);
  add_check(query, command.map.options);
  add_assumptions(query, command.map.assume);
  query.add_option("queries", command.queries, "Queries, each one argument")->required();
  add_over(query, command.only_minimal, command.map.jobs,
           "Ask all maps, or the minimal models alone: these are searched for, however many maps "
           "there are, unless --max-hypotheses or --check has them all listed");
  query
      .add_option_function<std::string>(
          "--by", [&](const std::string& way) { command.by_solver = way == "solver"; },
          "List the maps and ask each, or have the solver say whether there is "
          "one that answers yes, and one that answers no [enumeration]")
      ->check(CLI::IsMember({"enumeration", "solver"}));
  query.add_option("--json", command.map.json, "Write the answers as JSON; -: alone on stdout")
      ->type_name("FILE");
  add_limits(query, command.map.options);
  query.callback([&] {
    // These are about the listing.
    for (const char* option : {"--check", "--max-hypotheses"})
      if (command.by_solver && query.get_option(option)->count() > 0)
        throw CLI::ExcludesError("--by solver", option);
    chosen = [&] { return query_command(command); };
  });
}

void add_explain(CLI::App& app, ExplainCommand& command, std::function<int()>& chosen) {
  CLI::App& explain = *app.add_subcommand(
      "explain", "Say why a query is impossible or certain: what clashes, and with what");
  explain.footer(R"(Examples:
  asterism explain examples/aces-stubs.trace.json 'same(8, 10)'
  asterism explain drive.trace.json 'same(3, 9)' --planar --svg clash.svg
  asterism explain drive.trace.json 'places < 7' --over minimal --json - | jq .clash
A clash names visits, axioms and planarity of which none can be spared; a solver that knew nothing of
how it was found has confirmed it. A query that is neither impossible nor certain gets two maps.
docs/queries.md has the grammar.
Exit code: 0 certain or possible, 1 impossible, 2 undecided in the time given, 64 usage or a text that
is no query, 65 bad input or a visit that the trace does not have, 70 internal fault or a result that
cannot be written.)");
  add_maps_of_trace(explain, command.map);
  add_assumptions(explain, command.map.assume);
  explain.add_option("query", command.query, "The query, one argument")->required();
  add_over(explain, command.only_minimal, command.map.jobs,
           "Ask all maps, or the minimal models alone");
  explain
      .add_option("--json", command.map.json, "Write the explanation as JSON; -: alone on stdout")
      ->type_name("FILE");
  explain.add_option("--svg", command.svg, "Draw the clash")->type_name("FILE");
  explain
      .add_option("--time-limit", command.map.options.time_limit_s,
                  "Stop after this many seconds [60]")
      ->type_name("S")
      ->check(seconds);
  explain.callback([&] { chosen = [&] { return explain_command(command); }; });
}

void add_verify(CLI::App& app, VerifyCommand& command, std::function<int()>& chosen) {
  CLI::App& verify = *app.add_subcommand("verify", "Check the axioms, and who decides by them");
  verify.footer(R"(Examples:
  asterism verify
  asterism verify --worlds 200 --seed 1000 --json -
  asterism verify --axioms my-axioms examples/aces-stubs.trace.json
Of each axiom: a small model in which it alone fails, or the proof that the others imply it. Of all
together: a model with a travel. On walks through random worlds, and the traces given: that native
engine and solver keep the same maps, and that maps count what the axioms force. With axioms of your
own: what changes against the shipped ones, there and on the visits of the ACES log.
Exit code: 0 all is well, even if an axiom is implied, 1 the axioms allow no travel, or something
differs, 2 undecided or stopped by the time limit, 64 usage, 65 bad input, 70 internal fault or a
result that cannot be written.)");
  verify.add_option("traces", command.traces, "Trace files to compare on, beside random walks");
  add_axiom_options(verify, command.axioms);
  verify.add_option("--worlds", command.worlds, "Random worlds to walk through")
      ->type_name("N")
      ->check(CLI::Range(0, 100'000))
      ->capture_default_str();
  verify.add_option("--seed", command.seed, "Seed of the first of them; the others count on")
      ->check(whole_number)
      ->capture_default_str();
  verify.add_option("--json", command.json, "Write what was found as JSON; -: alone on stdout")
      ->type_name("FILE");
  verify.add_option("--time-limit", command.time_limit_s, "Stop after this many seconds")
      ->type_name("S")
      ->check(seconds);
  verify.callback([&] { chosen = [&] { return verify_command(command); }; });
}

void add_next(CLI::App& app, NextCommand& command, std::function<int()>& chosen) {
  CLI::App& next = *app.add_subcommand("next", "Say which ways on from a trace are worth trying");
  next.footer(R"(Examples:
  asterism next examples/aces-stubs.trace.json --planar
  asterism next drive.trace.json --max-travels 6 --svg exits.svg
  asterism next long-drive.trace.json --over minimal
  asterism next drive.trace.json --json - | jq '.exits[0]'
An exit is an arm to leave the last visit by, and where more travels follow, for each how many arms
clockwise of the one come in by the robot leaves: 0 leads back. docs/next.md tells what is expected.
Exit code: 0 there is a map, 1 none explains the trace, 2 stopped by a limit or Ctrl-C, 64 usage,
65 bad input, 70 internal fault or a result that cannot be written.)");
  add_maps_of_trace(next, command.map);
  add_check(next, command.map.options);
  add_over(next, command.only_minimal, command.map.jobs,
           "Count all maps at the exits, or the minimal models alone: these are searched for, "
           "however many maps there are, unless --max-hypotheses or --check has them all listed");
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
