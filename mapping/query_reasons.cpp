#include "mapping/query_reasons.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "engine/ask/map_list.hpp"
#include "engine/minimal/minimal_search.hpp"
#include "engine/preference.hpp"
#include "engine/proof/explain.hpp"
#include "engine/proof/map_problem.hpp"
#include "engine/proof/optimum.hpp"

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

/// A map of all visits.
std::vector<Arrival> whole(const PartialMap& map) {
  std::vector<Arrival> result;
  for (const std::optional<Arrival>& arrival : map) result.push_back(arrival.value());
  return result;
}

/// Why no minimal model makes the claim true, or none makes it false; nothing if some do both.
class ByPreference {
 public:
  ByPreference(const Trace& trace, const Theory& theory, unsigned jobs, ExplainReport& report,
               const Stop& stop)
      : trace_(trace), theory_(theory), jobs_(jobs), report_(report), stop_(stop) {}

  void explain() {
    const bool can_search =
        theory_.axioms.is_shipped() && trace_.visits.size() <= MinimalSearch::max_visits;
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
    report_.preference = {extents_by_preference(make_map(trace_, *minimal), theory_.axioms), other};
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
    return {Verdict::consistent, extents_by_preference(make_map(trace_, map), theory_.axioms), map};
  }
  MinimalSearch searched(const std::optional<Assumption>& assumption) const {
    Theory theory = theory_;
    if (assumption) theory.assumptions.push_back(*assumption);
    MinimalSearch search({.theory = std::move(theory), .jobs = jobs_});
    search.extend(trace_.visits);
    search.run(stop_);
    return search;
  }
  Optimum solved(const std::optional<Claim>& claim) {
    if (!problem_) problem_.emplace(trace_, theory_, stop_);
    std::vector<Premise> premises = problem_->premises();
    if (claim) premises.push_back(problem_->add(*claim));
    return find_optimum(*problem_, trace_, theory_.axioms, std::move(premises));
  }

  const Trace& trace_;
  const Theory& theory_;
  unsigned jobs_;
  ExplainReport& report_;
  const Stop& stop_;
  std::optional<MapProblem> problem_;
};

}  // namespace

ExplainReport explain_query(const Trace& trace, const Theory& theory, const Query& query,
                            bool only_minimal, unsigned jobs, const Stop& stop) {
  ExplainReport report{.trace = trace.name, .only_minimal = only_minimal, .query = query};
  Reason holds = explain(trace, theory, {&query.claim, 1}, stop);
  if (holds.verdict == Verdict::undecided) return report;
  if (holds.verdict == Verdict::inconsistent) {
    report.modality = Modality::impossible;
    report.clash = std::move(holds.clash);
    return report;
  }
  const Claim opposite = contrary(query.claim);
  Reason fails = explain(trace, theory, {&opposite, 1}, stop);
  if (fails.verdict == Verdict::undecided) return report;
  report.witness = whole(holds.map);
  if (fails.verdict == Verdict::inconsistent) {
    report.modality = Modality::certain;
    report.clash = std::move(fails.clash);
    return report;
  }
  report.modality = Modality::possible;
  report.counterexample = whole(fails.map);
  if (only_minimal) ByPreference(trace, theory, jobs, report, stop).explain();
  return report;
}

}  // namespace asterism
