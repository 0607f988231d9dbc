#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <span>

#include "cli/asked_maps.hpp"
#include "cli/map_parts.hpp"
#include "cli/progress.hpp"
#include "cli/query_parts.hpp"
#include "cli/route_text.hpp"
#include "core/error.hpp"
#include "engine/query.hpp"
#include "engine/query_reader.hpp"
#include "engine/solver_query.hpp"
#include "io/atomic_file.hpp"
#include "io/trace_file.hpp"

namespace asterism {
namespace {

using Json = nlohmann::ordered_json;

/// What was found out; without answers, a limit ended the run.
struct QueryReport {
  std::optional<std::string> stopped_by;
  std::vector<Query> queries;
  std::optional<std::vector<Answer>> answers;
  std::vector<SolverAnswer> solved;  ///< where the solver was asked instead
  RouteReport routes;
};

bool is_complete(const QueryReport& report) {
  return report.solved.empty() ? report.answers.has_value()
                               : std::ranges::all_of(report.solved, [](const auto& answer) {
                                   return answer.modality().has_value();
                                 });
}

void print_solved(const QueryCommand& command, const QueryReport& report) {
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
               command.map.options.assumptions.empty() ? "" : " under these assumptions");
}

void print(const QueryCommand& command, const AskedMaps& maps, const QueryReport& report) {
  const std::vector<Assumption>& assumptions = command.map.options.assumptions;
  for (std::size_t i = 0; i < report.queries.size(); ++i) {
    const std::string text = one_line(report.queries[i].text);
    if (!report.answers) {
      fmt::print("{}: undecided, stopped by {}\n", text, *report.stopped_by);
      continue;
    }
    const Answer& answer = report.answers->at(i);
    fmt::print("{}: {}, in {} of {} {}\n", text, name_of(answer.modality()), answer.holds,
               answer.of, noun(command, answer.of));
    if (answer.modality() != Modality::possible) continue;
    fmt::print("  it holds with visits at places {}\n", visits_text(*answer.witness));
    fmt::print("  it fails with visits at places {}\n", visits_text(*answer.counterexample));
  }
  if (report.answers && maps.consistent() == 0)
    fmt::print("no map explains the trace{}: none is left after visit {}\n",
               assumptions.empty() ? "" : " under these assumptions", maps.explained_visits());
}

Json json_of(const Query& query, const Answer* answer) {
  if (answer == nullptr)
    return {{"query", query.text}, {"verdict", "undecided"}, {"holds", nullptr},
            {"of", nullptr},       {"witness", nullptr},     {"counterexample", nullptr}};
  return {{"query", query.text},
          {"verdict", name_of(answer->modality())},
          {"holds", answer->holds},
          {"of", answer->of},
          {"witness", Json::parse(map_json(answer->witness))},
          {"counterexample", Json::parse(map_json(answer->counterexample))}};
}

Json json_of(const Query& query, const SolverAnswer& answer) {
  const auto modality = answer.modality();
  return {
      {"query", query.text},
      {"verdict", modality ? name_of(*modality) : "undecided"},
      {"holds", nullptr},
      {"of", nullptr},
      {"witness", Json::parse(map_json(modality ? answer.witness : std::nullopt))},
      {"counterexample", Json::parse(map_json(modality ? answer.counterexample : std::nullopt))}};
}

/// A query a line.
void write_json(std::ostream& out, const QueryCommand& command, const Trace& trace,
                const AskedMaps& maps, const QueryReport& report) {
  const MapOptions& options = command.map.options;
  Json head{{"format", "asterism/answers"}, {"version", 1}, {"trace", trace.name}};
  head["options"] = {{"planar", options.planar},
                     {"check", options.check},
                     {"axioms", options.axioms},
                     {"optional_axioms", options.optional_axioms},
                     {"over", command.only_minimal ? "minimal" : "all"},
                     {"by", command.by_solver     ? "solver"
                            : maps.are_searched() ? "search"
                                                  : "enumeration"}};
  for (const Assumption& assumption : options.assumptions)
    head["options"]["assumptions"].push_back(text_of(assumption));
  head["consistent"] = Json();
  if (report.answers && maps.consistent()) head["consistent"] = *maps.consistent();
  head["complete"] = is_complete(report);
  if (report.stopped_by) head["stopped_by"] = *report.stopped_by;
  const std::string text = head.dump();
  out << std::string_view(text).substr(0, text.size() - 1) << ",\n  \"queries\": [";
  for (std::size_t i = 0; i < report.queries.size(); ++i) {
    const Json answer =
        command.by_solver
            ? json_of(report.queries[i], report.solved[i])
            : json_of(report.queries[i], report.answers ? &report.answers->at(i) : nullptr);
    out << (i == 0 ? "\n    " : ",\n    ") << answer.dump();
  }
  out << ']';
  if (!report.routes.queries.empty()) write_routes(out, report.routes);
  out << "}\n";
}

/// Finds the maps and asks them, as far as the limits let it.
void find_answers(const Trace& trace, AskedMaps& maps, Progress& progress, QueryReport& report) {
  report.stopped_by = maps.find();
  if (report.stopped_by) return;
  const auto go_on = [&](std::uint64_t asked) { return progress(trace.visits.size() - 1, asked); };
  report.answers = ask(maps.list(), report.queries, go_on);
  if (report.answers && !find_routes(maps.list(), go_on, report.routes)) report.answers.reset();
  if (!report.answers) report.stopped_by = progress.stopped_by();
}

void ask_solver(const QueryCommand& command, const Trace& trace, const AxiomSet& axioms,
                QueryReport& report) {
  const double seconds = command.map.options.time_limit_s.value_or(1e6);
  std::vector<Claim> given;
  for (const Assumption& assumption : command.map.options.assumptions)
    given.push_back(claim_of(assumption));
  report.solved = ask_solver(trace, axioms, command.map.options.planar, given, report.queries,
                             command.only_minimal, seconds);
  if (is_complete(report)) return;
  const auto& limit = command.map.options.time_limit_s;
  report.stopped_by = limit ? fmt::format("time limit of {} s", *limit) : "the solver's own";
}

int exit_code(const QueryReport& report) {
  if (!is_complete(report) || report.routes.is_undecided()) return exit_undecided;
  const auto is_impossible = [](const auto& answer) {
    return answer.modality() == Modality::impossible;
  };
  const bool some_impossible =
      std::ranges::any_of(report.solved, is_impossible) ||
      (report.answers && std::ranges::any_of(*report.answers, is_impossible));
  return some_impossible || report.routes.has_impossible() ? exit_inconsistent : exit_consistent;
}

}  // namespace

int query_command(const QueryCommand& given) {
  QueryCommand command = given;
  QueryReport report;
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
  const auto stated = read_assumptions(command.map.assume);
  const Trace trace = read_trace_file(command.map.trace == "-" ? "/dev/stdin" : command.map.trace);
  for (const Query& query : report.queries) require_visits(query, trace);
  for (const RouteQuery& query : report.routes.queries)
    require_visits(query.text, query.mentions, trace);
  if (command.by_solver) command.map.options.check = "solver";
  command.map.options.assumptions = assumptions_of(stated, trace);
  const AxiomSet axioms = read_axioms(command.map);

  Progress progress(trace.visits.size(), command.map.options.time_limit_s);
  AskedMaps maps(command.map, axioms, trace, command.only_minimal, progress);
  if (command.by_solver) {
    progress.grown("asking the solver");
    ask_solver(command, trace, axioms, report);
  } else {
    find_answers(trace, maps, progress, report);
  }

  const auto write = [&](std::ostream& out) { write_json(out, command, trace, maps, report); };
  if (command.map.json == "-") {
    write(std::cout);
  } else {
    if (command.map.json) write_atomically(*command.map.json, write);
    fmt::print("{}", assuming_text(command.map.options.assumptions));
    if (command.by_solver) {
      print_solved(command, report);
    } else {
      print_routes(command, trace, report.routes, report.stopped_by);
      print(command, maps, report);
    }
  }
  return exit_code(report);
}

}  // namespace asterism
