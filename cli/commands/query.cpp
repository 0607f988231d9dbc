#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <span>

#include "cli/asked_maps.hpp"
#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/progress.hpp"
#include "cli/text/query_text.hpp"
#include "cli/text/route_text.hpp"
#include "engine/ask/query.hpp"
#include "engine/ask/query_reader.hpp"
#include "engine/proof/ask_solver.hpp"
#include "io/json/answers_json.hpp"
#include "io/json/trace_file.hpp"
#include "mapping/trace_maps.hpp"

namespace asterism {
namespace {

struct QueryCommand {
  AskedMaps maps;
  std::vector<std::string> queries;
  bool by_solver = false;  ///< instead of listing the maps
};

void print_solved(const AnswersReport& report) {
  for (std::size_t i = 0; i < report.solved.size(); ++i) {
    const SolverAnswer& answer = report.solved[i];
    const std::optional<Modality> modality = answer.modality();
    fmt::print("{}: {}\n", one_line(report.queries[i].text),
               modality ? name_of(*modality)
                        : fmt::format("undecided, stopped by {}", *report.stopped_by));
    if (modality && *modality != Modality::possible) continue;
    if (answer.witness)
      fmt::print("  it holds with visits at places {}\n", visits_text(*answer.witness));
    if (answer.counterexample)
      fmt::print("  it fails with visits at places {}\n", visits_text(*answer.counterexample));
  }
  if (std::ranges::any_of(report.solved, [](const SolverAnswer& answer) {
        return answer.can_hold == Verdict::inconsistent && answer.can_fail == Verdict::inconsistent;
      }))
    fmt::print("no map explains the trace{}\n",
               report.options.theory.assumptions.empty() ? "" : " under these assumptions");
}

void print(const TraceMaps& maps, const AnswersReport& report) {
  for (std::size_t i = 0; i < report.queries.size(); ++i) {
    const std::string text = one_line(report.queries[i].text);
    if (!report.answers) {
      fmt::print("{}: undecided, stopped by {}\n", text, *report.stopped_by);
      continue;
    }
    const Answer& answer = report.answers->at(i);
    fmt::print("{}: {}, in {} of {} {}\n", text, name_of(answer.modality()), answer.holds,
               answer.of, noun(report, answer.of));
    if (answer.modality() != Modality::possible) continue;
    fmt::print("  it holds with visits at places {}\n", visits_text(*answer.witness));
    fmt::print("  it fails with visits at places {}\n", visits_text(*answer.counterexample));
  }
  if (report.answers && maps.consistent() == 0)
    fmt::print("no map explains the trace{}: none is left after visit {}\n",
               report.options.theory.assumptions.empty() ? "" : " under these assumptions",
               maps.explained_visits());
}

/// @return  nothing if it is to stop
std::optional<std::vector<RouteAnswer>> find_routes(const MapList& maps,
                                                    std::span<const RouteQuery> queries,
                                                    const Stop& stop) {
  std::vector<RouteAnswer> answers;
  for (const RouteQuery& query : queries) {
    auto answer = find_route(maps, query, stop);
    if (!answer) return std::nullopt;
    answers.push_back(std::move(*answer));
  }
  return answers;
}

/// Finds the maps and asks them, as far as the limits let it.
void find_answers(TraceMaps& maps, Progress& progress, AnswersReport& report) {
  report.by = maps.are_searched() ? "search" : "enumeration";
  report.stopped_by = maps.find(progress.stop(maps));
  if (report.stopped_by) return;
  report.answers = ask(maps.list(), report.queries, progress.stop());
  if (report.answers) {
    report.routes.answers = find_routes(maps.list(), report.routes.queries, progress.stop());
    if (!report.routes.answers) report.answers.reset();
  }
  if (report.answers)
    report.consistent = maps.consistent();
  else
    report.stopped_by = progress.stop().reason;
}

void ask_solver(const Trace& trace, const Theory& theory, AnswersReport& report) {
  const auto& limit = report.options.time_limit_s;
  report.by = "solver";
  report.solved = ask_solver(trace, theory, report.queries, report.only_minimal,
                             Stop{}.within(limit.value_or(1e6)));
  if (!report.is_complete())
    report.stopped_by = limit ? fmt::format("time limit of {} s", *limit) : "the solver's own";
}

int exit_code(const AnswersReport& report) {
  if (!report.is_complete() || report.routes.is_undecided()) return exit_undecided;
  const auto is_impossible = [](const auto& answer) {
    return answer.modality() == Modality::impossible;
  };
  const bool some_impossible =
      std::ranges::any_of(report.solved, is_impossible) ||
      (report.answers && std::ranges::any_of(*report.answers, is_impossible));
  return some_impossible || report.routes.has_impossible() ? exit_inconsistent : exit_consistent;
}

AnswersReport read_queries(const QueryCommand& command) {
  AnswersReport report;
  for (const std::string& text : command.queries) {
    Question question = read_question(text);
    if (auto* query = std::get_if<Query>(&question))
      report.queries.push_back(std::move(*query));
    else
      report.routes.queries.push_back(std::get<RouteQuery>(std::move(question)));
  }
  if (command.by_solver && !report.routes.queries.empty())
    throw QueryError(report.routes.queries.front().text, 0, "a route, which the solver cannot find",
                     "another query, or no --by solver");
  return report;
}

int run(QueryCommand command) {
  AskedMaps& asked = command.maps;
  AnswersReport report = read_queries(command);
  const auto stated = read_assumptions(asked.assume);
  const Trace trace = read_trace_file(file_of(asked));
  for (const Query& query : report.queries) require_visits(query, trace);
  for (const RouteQuery& query : report.routes.queries)
    require_visits(query.text, query.mentions, trace);
  if (command.by_solver) asked.options.check = "solver";
  const Theory theory = read_theory(asked, assumptions_of(stated, trace));
  require_decidable(theory, asked.options);
  report.trace = trace.name;
  report.options = asked.options;
  report.only_minimal = asked.only_minimal;

  Progress progress(trace.visits.size(), asked.options.time_limit_s);
  TraceMaps maps(trace, theory, asked.options, asked.only_minimal, asked.jobs);
  if (command.by_solver) {
    progress.grown("asking the solver");
    ask_solver(trace, theory, report);
  } else {
    find_answers(maps, progress, report);
  }

  if (!write_answer(asked, answers_json(report))) return exit_code(report);
  fmt::print("{}", assuming_text(report.options.theory.assumptions));
  if (command.by_solver) {
    print_solved(report);
  } else {
    print_routes(report, trace);
    print(maps, report);
  }
  return exit_code(report);
}

void add_options(CLI::App& query, QueryCommand& command) {
  add_maps_of_trace(query, command.maps);
  add_check(query, command.maps.options);
  add_assumptions(query, command.maps.assume);
  query.add_option("queries", command.queries, "Queries, each one argument")->required();
  add_over(query, command.maps,
           "Ask all maps, or the minimal models alone: these are searched for, however many maps "
           "there are, unless --max-hypotheses or --check has them all listed");
  query
      .add_option_function<std::string>(
          "--by",
          [&](const std::string& way) {
            command.by_solver = way == "solver";
            // These are about the listing.
            for (const char* option : {"--check", "--max-hypotheses"})
              if (command.by_solver && query.get_option(option)->count() > 0)
                throw CLI::ExcludesError("--by solver", option);
          },
          "List the maps and ask each, or have the solver say whether there is "
          "one that answers yes, and one that answers no [enumeration]")
      ->check(CLI::IsMember({"enumeration", "solver"}));
  query.add_option("--json", command.maps.json, "Write the answers as JSON; -: alone on stdout")
      ->type_name("FILE");
  add_limits(query, command.maps.options);
}

}  // namespace

void add_query(CLI::App& app, Run& chosen) {
  add_command(app, chosen, "query", "Ask every map that explains a trace", add_options, run,
              R"(Examples:
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
}

}  // namespace asterism
