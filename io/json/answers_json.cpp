#include "io/json/answers_json.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "io/json/assumption_json.hpp"
#include "io/json/json_writer.hpp"
#include "io/json/map_json.hpp"

namespace asterism {
namespace {

constexpr std::size_t most_routes = 1000;  // spelt out of those of one query

void write_query(JsonWriter& json, const Query& query, std::optional<Modality> modality,
                 const Answer& answer, bool are_counted) {
  json.object([&] {
    json.member("query", query.text, "verdict", modality ? name_of(*modality) : "undecided",
                "holds", are_counted ? std::optional(answer.holds) : std::nullopt, "of",
                are_counted ? std::optional(answer.of) : std::nullopt);
    write_arrivals(json.key("witness"), answer.witness);
    write_arrivals(json.key("counterexample"), answer.counterexample);
  });
}

void write_query(JsonWriter& json, const AnswersReport& report, std::size_t i) {
  const Query& query = report.queries[i];
  if (report.answers) {
    const Answer& answer = report.answers->at(i);
    return write_query(json, query, answer.modality(), answer, true);
  }
  if (report.solved.empty()) return write_query(json, query, std::nullopt, {}, false);
  const SolverAnswer& solved = report.solved[i];
  const std::optional<Modality> modality = solved.modality();
  Answer shown;
  if (modality) shown = {0, 0, solved.witness, solved.counterexample};
  write_query(json, query, modality, shown, false);
}

void write_route(JsonWriter& json, const RouteQuery& query, const RouteAnswer& answer) {
  json.object([&] {
    json.member("query", query.text, "verdict", verdict_of(answer), "of", answer.of, "turns",
                answer.certain, "is_shortest",
                answer.certain ? std::optional(answer.is_shortest) : std::nullopt);
    const std::span listed(answer.shorter.data(), std::min(most_routes, answer.shorter.size()));
    std::uint64_t unlisted = maps_with_shorter(answer);
    for (const RouteAnswer::InSome& some : listed) unlisted -= some.maps;
    json.key("shorter").list(listed, [](JsonWriter& to, const RouteAnswer::InSome& some) {
      to.object([&] {
        to.member("turns", some.route, "maps", some.maps);
        write_arrivals(to.key("witness"), std::optional(some.witness));
      });
    });
    json.member("unlisted", unlisted);
  });
}

void write_unanswered(JsonWriter& json, const RouteQuery& query) {
  json.object([&] {
    json.member("query", query.text, "verdict", "undecided");
    for (const char* key : {"of", "turns", "is_shortest", "shorter", "unlisted"})
      json.key(key).null();
  });
}

void write_routes(JsonWriter& json, const AnswersReport::Routes& routes) {
  json.array([&] {
    for (std::size_t i = 0; i < routes.queries.size(); ++i)
      if (routes.answers)
        write_route(json.line(), routes.queries[i], routes.answers->at(i));
      else
        write_unanswered(json.line(), routes.queries[i]);
  });
}

}  // namespace

std::uint64_t maps_with_shorter(const RouteAnswer& answer) {
  return std::accumulate(
      answer.shorter.begin(), answer.shorter.end(), answer.unlisted,
      [](std::uint64_t sum, const RouteAnswer::InSome& some) { return sum + some.maps; });
}

const char* verdict_of(const RouteAnswer& answer) {
  return answer.certain || answer.is_shortest ? name_of(answer.modality()) : "undecided";
}

bool AnswersReport::Routes::is_undecided() const {
  return answers && std::ranges::any_of(*answers, [](const auto& one) { return !one.is_shortest; });
}

bool AnswersReport::Routes::has_impossible() const {
  return answers && std::ranges::any_of(*answers, [](const auto& one) {
           return one.modality() == Modality::impossible;
         });
}

bool AnswersReport::is_complete() const {
  if (solved.empty()) return answers.has_value();
  return std::ranges::all_of(solved,
                             [](const auto& answer) { return answer.modality().has_value(); });
}

std::string answers_json(const AnswersReport& report) {
  const TheoryRecord& theory = report.options.theory;
  const auto write = [&](JsonWriter& json) {
    json.member("trace", report.trace);
    json.key("options").object([&] {
      json.member("planar", theory.planar, "check", report.options.check, "axioms", theory.axioms,
                  "optional_axioms", theory.optional_axioms, "over",
                  report.only_minimal ? "minimal" : "all", "by", report.by);
      write_assumptions(json, theory.assumptions);
    });
    json.member("consistent", report.consistent, "complete", report.is_complete());
    json.member_if("stopped_by", report.stopped_by);
    json.line().key("queries").array([&] {
      for (std::size_t i = 0; i < report.queries.size(); ++i) write_query(json.line(), report, i);
    });
    if (!report.routes.queries.empty()) write_routes(json.line().key("routes"), report.routes);
  };
  return json_file("asterism/answers", write, JsonWriter::Style::compact);
}

}  // namespace asterism
