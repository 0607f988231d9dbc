#include <fmt/format.h>

#include <iostream>
#include <optional>
#include <utility>
#include <vector>

#include "cli/explanation_text.hpp"
#include "cli/map_parts.hpp"
#include "cli/query_parts.hpp"
#include "core/deadline.hpp"
#include "engine/map_list.hpp"
#include "engine/query_reader.hpp"
#include "io/atomic_file.hpp"
#include "io/trace_file.hpp"

namespace asterism {
namespace {

/// What the claim assumes of two visits, if that is all it says.
std::optional<Assumption> assumption_of(const Claim& claim, bool is_negated = false) {
  if (const auto* negation = std::get_if<Claim::Not>(&claim.is))
    return assumption_of(negation->part.front(), !is_negated);
  const auto* same = std::get_if<Claim::Same>(&claim.is);
  if (same == nullptr) return std::nullopt;
  return Assumption{is_negated ? Assumption::Kind::differ : Assumption::Kind::same, same->one,
                    same->other};
}

Claim contrary(const Claim& claim) { return {Claim::Not{{claim}}}; }

/// Why no minimal model makes the claim true, or none makes it false; nothing if some do both.
class ByPreference {
 public:
  ByPreference(const ExplainCommand& command, const Trace& trace, const AxiomSet& axioms,
               ExplainReport& report, Deadline deadline)
      : options_(command.map.options),
        jobs_(command.map.jobs),
        trace_(trace),
        axioms_(axioms),
        report_(report),
        deadline_(deadline) {}

  void explain() {
    const bool can_search =
        axioms_.is_shipped() && trace_.visits.size() <= MinimalSearch::max_visits;
    if (!(can_search ? by_search() : by_solver())) report_.modality.reset();
  }

 private:
  /// Asks the minimal models, and then for the best map where it is otherwise. To prove that none
  /// is better is what the solver takes longest for.
  bool by_search() {
    const MinimalSearch search = searched(std::nullopt);
    if (!search.is_complete()) return false;
    const Answer answer = ask(minimal_maps(search), {&report_.query, 1}).value().front();
    if (answer.witness) report_.witness = *answer.witness;
    if (answer.counterexample) report_.counterexample = *answer.counterexample;
    if (answer.modality() == Modality::possible) return true;
    const bool is_impossible = answer.modality() == Modality::impossible;
    const Claim& claim = report_.query.claim;
    const Optimum other = best_with(is_impossible ? claim : contrary(claim));
    if (other.verdict != Verdict::consistent) return false;
    (is_impossible ? report_.witness : report_.counterexample) = other.map;
    report_.modality = answer.modality();
    const auto& minimal = is_impossible ? answer.counterexample : answer.witness;
    report_.preference = {extents_by_preference(make_map(trace_, *minimal), axioms_), other};
    return true;
  }

  bool by_solver() {
    const Optimum best = solved(std::nullopt);
    const Optimum holding = solved(report_.query.claim);
    const Optimum failing = solved(contrary(report_.query.claim));
    for (const Optimum* optimum : {&best, &holding, &failing})
      if (optimum->verdict != Verdict::consistent) return false;
    report_.witness = holding.map;
    report_.counterexample = failing.map;
    if (holding.extents == best.extents && failing.extents == best.extents) return true;
    const bool is_impossible = holding.extents != best.extents;
    report_.modality = is_impossible ? Modality::impossible : Modality::certain;
    report_.preference = {best.extents, is_impossible ? holding : failing};
    return true;
  }

  Optimum best_with(const Claim& claim) {
    const auto assumption = assumption_of(claim);
    if (!assumption) return solved(claim);
    const MinimalSearch search = searched(assumption);
    if (!search.is_complete() || search.bounds().count == 0) return {Verdict::undecided, {}, {}};
    std::vector<Arrival> map = search.models().front();
    return {Verdict::consistent, extents_by_preference(make_map(trace_, map), axioms_), map};
  }
  MinimalSearch searched(const std::optional<Assumption>& assumption) const {
    std::vector<Assumption> assumptions = options_.assumptions;
    if (assumption) assumptions.push_back(*assumption);
    MinimalSearch search({.planar = options_.planar,
                          .axioms = axioms_,
                          .assumptions = std::move(assumptions),
                          .jobs = jobs_});
    search.extend(trace_.visits);
    search.run([&](const MinimalSearch&) { return !is_over(deadline_); });
    return search;
  }
  Optimum solved(const std::optional<Claim>& claim) {
    if (!problem_) {
      problem_.emplace(trace_, axioms_, seconds_until(deadline_));
      premises_ = problem_->premises(options_.planar);
      for (const Assumption& assumption : options_.assumptions)
        premises_.push_back(problem_->add(claim_of(assumption)));
    }
    std::vector<Premise> premises = premises_;
    if (claim) premises.push_back(problem_->add(*claim));
    return find_optimum(*problem_, trace_, axioms_, std::move(premises));
  }

  const MapOptions& options_;
  unsigned jobs_;
  const Trace& trace_;
  const AxiomSet& axioms_;
  ExplainReport& report_;
  Deadline deadline_;
  std::optional<MapProblem> problem_;
  std::vector<Premise> premises_;
};

void find_reasons(const ExplainCommand& command, const Trace& trace, const AxiomSet& axioms,
                  ExplainReport& report) {
  const Deadline deadline =
      deadline_in(command.map.options.time_limit_s.value_or(default_explain_s));
  const auto reason_of = [&](const Claim& claim) {
    std::vector<Claim> claims;
    for (const Assumption& assumption : command.map.options.assumptions)
      claims.push_back(claim_of(assumption));
    claims.push_back(claim);
    return explain(trace, axioms, command.map.options.planar, claims, seconds_until(deadline));
  };
  Reason holds = reason_of(report.query.claim);
  if (holds.verdict == Verdict::undecided) return;
  if (holds.verdict == Verdict::inconsistent) {
    report.modality = Modality::impossible;
    report.clash = std::move(holds.explanation);
    return;
  }
  Reason fails = reason_of({Claim::Not{{report.query.claim}}});
  if (fails.verdict == Verdict::undecided) return;
  report.witness = whole(holds.map);
  if (fails.verdict == Verdict::inconsistent) {
    report.modality = Modality::certain;
    report.clash = std::move(fails.explanation);
    return;
  }
  report.modality = Modality::possible;
  report.counterexample = whole(fails.map);
  if (command.only_minimal) ByPreference(command, trace, axioms, report, deadline).explain();
}

}  // namespace

int explain_command(const ExplainCommand& given) {
  ExplainCommand command = given;
  ExplainReport report{read_query(command.query)};
  const auto stated = read_assumptions(command.map.assume);
  const Trace trace = read_trace_file(command.map.trace == "-" ? "/dev/stdin" : command.map.trace);
  require_visits(report.query, trace);
  command.map.options.assumptions = assumptions_of(stated, trace);
  command.map.options.check = "solver";  // it is the solver that explains, whatever the axioms
  const AxiomSet axioms = read_axioms(command.map);
  require_countable(report.query.claim, report.query.text, axioms);
  find_reasons(command, trace, axioms, report);

  const auto write = [&](std::ostream& out) {
    out << explanation_json(command, trace, axioms, report);
  };
  if (command.map.json == "-") {
    write(std::cout);
  } else {
    if (command.map.json) write_atomically(*command.map.json, write);
    fmt::print("{}", explanation_text(command, trace, axioms, report));
  }
  if (command.svg && report.clash)
    write_atomically(*command.svg, explanation_svg(command, trace, axioms, report));
  else if (command.svg)
    fmt::print(stderr, "nothing clashes: {} is not written\n", *command.svg);
  if (!report.modality) return exit_undecided;
  return *report.modality == Modality::impossible ? exit_inconsistent : exit_consistent;
}

}  // namespace asterism
