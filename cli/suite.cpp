#include "cli/suite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "cli/grow.hpp"
#include "cli/map_parts.hpp"
#include "cli/progress.hpp"
#include "core/error.hpp"
#include "engine/query.hpp"
#include "engine/query_reader.hpp"

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

/// The maps to ask, as `asterism map` would be told.
MapCommand command_of(const TestCommand& command, const Trace& trace,
                      const Expectation::Options& asked, const std::string& where) {
  MapCommand result;
  result.options.planar = asked.planar;
  result.options.check = command.check;
  result.options.max_hypotheses = command.limits.max_hypotheses;
  result.options.certify_s = 0;
  result.options.assumptions = asked.assumptions;
  result.axioms.optional = asked.optional_axioms;
  result.visits = trace.visits.size();
  for (std::size_t i = 0; i < asked.assumptions.size(); ++i)
    at(number(where + "/options/assumptions", i),
       [&] { require_visits(read_assumption(text_of(asked.assumptions[i])), trace); });
  return result;
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

Expectation default_questions() { return {{{.options = {}}, {.options = {.planar = true}}}}; }

std::optional<Expectation> SuiteRun::found(const Trace& trace, Expectation asked,
                                           const std::string& file) {
  for (std::size_t i = 0; i < asked.cases.size(); ++i)
    if (!answer(trace, asked.cases[i], number(file + ":/cases", i))) return std::nullopt;
  return asked;
}

/// @return  false if it must stop
bool SuiteRun::answer(const Trace& trace, Expectation::Case& asked, const std::string& where) {
  MapCommand command = command_of(command_, trace, asked.options, where);
  std::vector<Query> queries;
  for_each_question(asked.queries, where,
                    [&](const Expectation::Question& question, const std::string& place) {
                      queries.push_back(read_query(question.query));
                      at(place, [&] { require_visits(queries.back(), trace); });
                    });
  const AxiomSet axioms =
      at(where + "/options/optional_axioms", [&] { return read_axioms(command); });

  if (command_.limits.time_limit_s) {
    const double gone_s = std::chrono::duration<double>(Clock::now() - begin_).count();
    command.options.time_limit_s = std::max(0.0, *command_.limits.time_limit_s - gone_s);
  }
  Progress progress(trace.visits.size(), command.options.time_limit_s);
  MapTree::Options options = tree_options(command, axioms);
  options.go_on = std::ref(progress);
  MapTree tree(std::move(options));
  const MapReport report =
      report_of(tree, command, axioms, grow(tree, trace, command, progress), progress);
  const auto go_on = [&](std::uint64_t maps) { return progress(trace.visits.size() - 1, maps); };
  bool is_complete = report.complete;
  for (std::size_t i = 0; i < queries.size() && is_complete; ++i) {
    Expectation::Question& question = asked.queries[i];
    const auto answers = ask(tree, {&queries[i], 1}, question.only_minimal, go_on);
    is_complete = answers.has_value();
    if (is_complete) question.answer = {answers->front().holds, answers->front().of};
  }
  if (is_complete)
    asked.counts = counts_of(report);
  else
    stopped_by_ = report.stopped_by.value_or(progress.stopped_by().value_or("a limit"));
  return is_complete;
}

}  // namespace asterism
