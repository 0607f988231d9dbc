#include "engine/certify.hpp"

#include <chrono>
#include <stdexcept>

#include "axioms/axiom_solver.hpp"
#include "engine/arm_table.hpp"
#include "engine/facts.hpp"
#include "engine/map_problem.hpp"
#include "planarity/euler.hpp"

namespace asterism {
namespace {

using Clock = std::chrono::steady_clock;

/// Sizes of the extents in order of preference.
std::vector<std::size_t> rank(const TopologicalMap& map, const AxiomSet& axioms) {
  std::vector<std::size_t> result;
  for (const std::string& extent : axioms.preference())
    result.push_back(extent == "path"    ? map.paths.size()
                     : extent == "place" ? map.places.size()
                                         : map.segments.size());
  return result;
}

unsigned milliseconds_until(Clock::time_point deadline) {
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
  return left.count() < 1 ? 1U : static_cast<unsigned>(left.count());
}

Verdict check_model(const ArmTable& table, const AxiomSet& axioms, std::span<const ArmIndex> named,
                    Clock::time_point deadline) {
  AxiomSolver solver(axioms, milliseconds_until(deadline));
  solver.add(general_facts());
  for (std::size_t k = 0; k < named.size(); ++k) {
    if (Clock::now() > deadline) return Verdict::undecided;
    solver.add(visit_facts(table, named.first(k + 1)));
  }
  return solver.check();
}

/// "Preferred to a map of these extents": one is smaller, and those preferred to it are no larger.
Claim preferred_to(const std::vector<std::size_t>& best, const AxiomSet& axioms) {
  const auto extent = [&](std::size_t i, Claim::Relation relation) {
    const std::string& name = axioms.preference()[i];
    const Claim::Count count = name == "path"    ? Claim::Count::paths
                               : name == "place" ? Claim::Count::places
                                                 : Claim::Count::segments;
    return Claim{Claim::Comparison{count, relation, std::uint64_t{best[i]}}};
  };
  Claim::Any ways;
  for (std::size_t i = 0; i < best.size(); ++i) {
    Claim::All way{{extent(i, Claim::Relation::less)}};
    for (std::size_t j = 0; j < i; ++j) way.parts.push_back(extent(j, Claim::Relation::at_most));
    ways.parts.push_back({way});
  }
  return {ways};
}

Verdict exists_preferred(const Trace& trace, const AxiomSet& axioms, bool planar,
                         const std::vector<std::size_t>& best, Clock::time_point deadline) {
  MapProblem problem(trace, axioms, 1e-3 * milliseconds_until(deadline));
  std::vector<Premise> premises = problem.premises(planar);
  premises.push_back(problem.add(preferred_to(best, axioms)));
  return problem.check(premises);
}

}  // namespace

Certificate certify(const Trace& trace, const AxiomSet& axioms, bool planar,
                    std::span<const std::vector<Arrival>> models, double seconds) {
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(std::min(seconds, 1e6)));
  ArmTable table;
  for (const Visit& visit : trace.visits) table.append(visit);

  std::optional<std::vector<std::size_t>> best;
  for (const auto& model : models) {
    const TopologicalMap map = make_map(trace, model);
    if (!best) best = rank(map, axioms);
    if (rank(map, axioms) != *best || (planar && !is_planar(map))) return Certificate::refuted;
    switch (check_model(table, axioms, table.named(model), deadline)) {
      case Verdict::inconsistent:
        return Certificate::refuted;
      case Verdict::undecided:
        return Certificate::not_shown;
      case Verdict::consistent:
        break;
    }
  }
  if (!best) throw std::invalid_argument("no models to certify");
  switch (exists_preferred(trace, axioms, planar, *best, deadline)) {
    case Verdict::inconsistent:
      return Certificate::shown;
    case Verdict::consistent:
      return Certificate::refuted;
    case Verdict::undecided:
      break;
  }
  return Certificate::not_shown;
}

}  // namespace asterism
