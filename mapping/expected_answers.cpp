#include "mapping/expected_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "engine/ask/query.hpp"
#include "engine/ask/query_reader.hpp"
#include "mapping/axiom_source.hpp"

namespace asterism {
namespace {

/// Calls f; what it refuses is at this place of a file.
template <class F>
auto at(const std::string& where, F&& f) {
  try {
    return f();
  } catch (const InputError& error) {
    throw InputError(where + ": " + error.what());
  }
}

std::string number(const std::string& pointer, std::size_t i) {
  return pointer + '/' + std::to_string(i);
}

/// Calls f(question, where it is in the file) for all questions of a case.
template <class Questions, class F>
void for_each_question(Questions& questions, const std::string& where, F&& f) {
  for (std::size_t i = 0; i < questions.size(); ++i)
    f(questions[i], number(where + "/queries", i) + "/query");
}

/// @throws InputError if visits are assumed that the trace does not have
void require_assumptions(const Trace& trace, const TheoryRecord& asked, const std::string& where) {
  for (std::size_t i = 0; i < asked.assumptions.size(); ++i)
    at(number(where + "/options/assumptions", i),
       [&] { require_visits(read_assumption(text_of(asked.assumptions[i])), trace); });
}

Theory theory_of(const TheoryRecord& asked, const std::string& where) {
  return {.axioms = at(where + "/options/optional_axioms",
                       [&] { return read_axioms({.optional = asked.optional_axioms}); }),
          .planar = asked.planar,
          .assumptions = asked.assumptions};
}

Expectation::Counts counts_of(const MapReport& report) {
  Expectation::Counts counts{report.per_visit.value()};
  if (!report.minimal) return counts;
  const auto& [paths, places, count, certified] = *report.minimal;
  counts.minimal = {paths, places, count};
  for (std::size_t i = 0; i < std::min(report.maps.size(), max_expected_models); ++i)
    counts.minimal->visits.push_back(report.maps[i].visits);
  return counts;
}

/// @return  why it stopped, if it did; then it is not answered
std::optional<std::string> answer(const Trace& trace, Expectation::Case& asked,
                                  const MapOptions& options, const std::string& where,
                                  const MapWatch& watch) {
  require_assumptions(trace, asked.theory, where);
  std::vector<Query> queries;
  for_each_question(asked.queries, where,
                    [&](const Expectation::Question& question, const std::string& place) {
                      queries.push_back(read_query(question.query));
                      at(place, [&] { require_visits(queries.back(), trace); });
                    });
  TraceMaps maps(trace, theory_of(asked.theory, where),
                 {.check = options.check, .max_hypotheses = options.max_hypotheses});
  const Stop stop = watch.stop(maps);
  maps.find(stop);
  const MapReport report = maps.report(stop);
  if (!report.complete) return report.stopped_by;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    Expectation::Question& question = asked.queries[i];
    const auto answers =
        ask(question.only_minimal ? maps.minimal() : maps.list(), {&queries[i], 1}, stop);
    if (!answers) return stop.reason.value_or("a limit");
    question.answer = {answers->front().holds, answers->front().of};
  }
  asked.counts = counts_of(report);
  return std::nullopt;
}

}  // namespace

Expectation read_expected_answers(const std::string& file) {
  Expectation expectation = read_expect_file(file);
  for (std::size_t i = 0; i < expectation.cases.size(); ++i)
    for_each_question(expectation.cases[i].queries, number(file + ":/cases", i),
                      [](const Expectation::Question& question, const std::string& where) {
                        at(where, [&] { read_query(question.query); });
                      });
  return expectation;
}

std::string size_text(const Expectation& expectation) {
  std::size_t queries = 0;
  for (const Expectation::Case& one : expectation.cases) queries += one.queries.size();
  return fmt::format("{} case{}", expectation.cases.size(),
                     expectation.cases.size() == 1 ? "" : "s") +
         (queries == 0 ? "" : fmt::format(" and {} quer{}", queries, queries == 1 ? "y" : "ies"));
}

Expectation default_questions() { return {{{.theory = {}}, {.theory = {.planar = true}}}}; }

FoundAnswers find_answers(const Trace& trace, Expectation asked, const MapOptions& options,
                          const std::string& file, const MapWatch& watch) {
  for (std::size_t i = 0; i < asked.cases.size(); ++i)
    if (auto why = answer(trace, asked.cases[i], options, number(file + ":/cases", i), watch))
      return {.answers = {}, .stopped_by = *why};
  return {.answers = std::move(asked)};
}

}  // namespace asterism
