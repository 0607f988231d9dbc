#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <span>

#include "cli/grow.hpp"
#include "cli/map_parts.hpp"
#include "cli/progress.hpp"
#include "core/error.hpp"
#include "engine/query.hpp"
#include "engine/query_reader.hpp"
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
};

const char* name_of(Modality modality) {
  switch (modality) {
    case Modality::certain:
      return "certain";
    case Modality::possible:
      return "possible";
    case Modality::impossible:
      return "impossible";
  }
  return "";
}

/// "planar map", or "planar maps" if it is not one.
std::string noun(const QueryCommand& command, std::uint64_t count) {
  return fmt::format("{}{}{}", command.map.options.planar ? "planar " : "",
                     command.only_minimal ? "minimal model" : "map", count == 1 ? "" : "s");
}

/// As it may be shown in one line: what is read has no control characters but white space.
std::string one_line(std::string query) {
  std::ranges::replace_if(
      query, [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
  return query;
}

std::string visits_text(const std::vector<Arrival>& arrivals) {
  std::vector<std::size_t> places;
  for (const Arrival& arrival : arrivals) places.push_back(arrival.place.index());
  return fmt::format("{}", fmt::join(places, " "));
}

void print(const QueryCommand& command, const MapTree& tree, const QueryReport& report) {
  const std::vector<Assumption>& assumptions = command.map.options.assumptions;
  fmt::print("{}", assuming_text(assumptions));
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
  if (report.answers && tree.size() == 0)
    fmt::print("no map explains the trace{}: none is left after visit {}\n",
               assumptions.empty() ? "" : " under these assumptions",
               std::ranges::find(tree.per_visit(), 0U) - tree.per_visit().begin());
}

Json json_of(const std::optional<std::vector<Arrival>>& map) {
  if (!map) return nullptr;
  Json visits = Json::array();
  Json entered = Json::array();
  for (const Arrival& arrival : *map) {
    visits.push_back(arrival.place.index());
    entered.push_back(arrival.entered ? Json(*arrival.entered) : Json());
  }
  return {{"visits", visits}, {"entered", entered}};
}

Json json_of(const Query& query, const Answer* answer) {
  if (answer == nullptr)
    return {{"query", query.text}, {"verdict", "undecided"}, {"holds", nullptr},
            {"of", nullptr},       {"witness", nullptr},     {"counterexample", nullptr}};
  return {{"query", query.text},
          {"verdict", name_of(answer->modality())},
          {"holds", answer->holds},
          {"of", answer->of},
          {"witness", json_of(answer->witness)},
          {"counterexample", json_of(answer->counterexample)}};
}

/// A query a line.
void write_json(std::ostream& out, const QueryCommand& command, const Trace& trace,
                const MapTree& tree, const QueryReport& report) {
  const MapOptions& options = command.map.options;
  Json head{{"format", "asterism/answers"}, {"version", 1}, {"trace", trace.name}};
  head["options"] = {{"planar", options.planar},
                     {"check", options.check},
                     {"axioms", options.axioms},
                     {"optional_axioms", options.optional_axioms},
                     {"over", command.only_minimal ? "minimal" : "all"}};
  for (const Assumption& assumption : options.assumptions)
    head["options"]["assumptions"].push_back(text_of(assumption));
  head["consistent"] = report.answers ? Json(tree.size()) : Json();
  head["complete"] = report.answers.has_value();
  if (report.stopped_by) head["stopped_by"] = *report.stopped_by;
  const std::string text = head.dump();
  out << std::string_view(text).substr(0, text.size() - 1) << ",\n  \"queries\": [";
  for (std::size_t i = 0; i < report.queries.size(); ++i)
    out << (i == 0 ? "\n    " : ",\n    ")
        << json_of(report.queries[i], report.answers ? &report.answers->at(i) : nullptr).dump();
  out << "]}\n";
}

/// Grows the tree and asks it, as far as the limits let it.
void find_answers(const QueryCommand& command, const Trace& trace, MapTree& tree,
                  Progress& progress, QueryReport& report) {
  report.stopped_by = grow(tree, trace, command.map, progress);
  if (!report.stopped_by && tree.undecided() > 0)
    report.stopped_by = fmt::format("{} candidates undecided by the solver", tree.undecided());
  if (report.stopped_by) return;
  report.answers = ask(tree, report.queries, command.only_minimal,
                       [&](std::uint64_t maps) { return progress(trace.visits.size() - 1, maps); });
  if (!report.answers) report.stopped_by = progress.stopped_by();
}

}  // namespace

int query_command(const QueryCommand& given) {
  QueryCommand command = given;
  QueryReport report;
  for (const std::string& text : command.queries) report.queries.push_back(read_query(text));
  const auto stated = read_assumptions(command.map.assume);
  const Trace trace = read_trace_file(command.map.trace == "-" ? "/dev/stdin" : command.map.trace);
  for (const Query& query : report.queries) require_visits(query, trace);
  command.map.options.assumptions = assumptions_of(stated, trace);
  const AxiomSet axioms = read_axioms(command.map);

  Progress progress(trace.visits.size(), command.map.options.time_limit_s);
  MapTree::Options options = tree_options(command.map, axioms);
  options.go_on = std::ref(progress);
  MapTree tree(std::move(options));
  find_answers(command, trace, tree, progress, report);

  const auto write = [&](std::ostream& out) { write_json(out, command, trace, tree, report); };
  if (command.map.json == "-") {
    write(std::cout);
  } else {
    if (command.map.json) write_atomically(*command.map.json, write);
    print(command, tree, report);
  }
  if (!report.answers) return exit_undecided;
  const bool some_impossible = std::ranges::any_of(*report.answers, [](const Answer& answer) {
    return answer.modality() == Modality::impossible;
  });
  return some_impossible ? exit_inconsistent : exit_consistent;
}

}  // namespace asterism
