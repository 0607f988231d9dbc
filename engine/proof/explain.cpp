#include "engine/proof/explain.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "axioms/bench/spare.hpp"
#include "engine/proof/map_problem.hpp"
#include "planarity/euler.hpp"

namespace asterism {
namespace {

/// Premises in the order in which they are tried to be spared.
std::vector<Premise> by_importance(std::vector<Premise> premises) {
  const auto group = [](const Premise& premise) {
    switch (premise.kind) {
      case Premise::Kind::claim:
        return 0;
      case Premise::Kind::planarity:
        return 1;
      case Premise::Kind::visit:
        return 2;
      case Premise::Kind::axiom:
        break;
    }
    return 3;
  };
  std::ranges::sort(premises, [&](const Premise& one, const Premise& other) {
    if (group(one) != group(other)) return group(one) < group(other);
    return one.kind == Premise::Kind::visit ? one < other : other < one;
  });
  return premises;
}

std::vector<Premise> without(const std::vector<Premise>& premises, const Premise& spared) {
  std::vector<Premise> result = premises;
  std::erase(result, spared);
  return result;
}

/// Drops premises one by one as long as the rest cannot be; nothing when out of time.
std::optional<std::vector<Premise>> minimise(MapProblem& problem,
                                             const std::vector<Premise>& premises) {
  using Premises = std::vector<Premise>;
  bool is_undecided = false;
  Premises needed = spare_one_by_one(
      premises, by_importance(premises), [&](const Premises& others) -> std::optional<Premises> {
        if (is_undecided) return std::nullopt;
        // What is needed beside more premises is nearly always needed beside fewer: confirm() sees.
        const Verdict verdict = problem.check(others);
        is_undecided = verdict == Verdict::undecided;
        if (verdict != Verdict::inconsistent) return std::nullopt;
        return Premises(problem.core().begin(), problem.core().end());
      });
  return is_undecided ? std::nullopt : std::optional(std::move(needed));
}

/// Checks, by a solver that knows nothing yet, that the premises cannot all be and that none can be
/// spared; if one can after all, goes on with the others. Nothing when out of time.
std::optional<std::vector<Clash::Member>> confirm(MapProblem& fresh,
                                                  const std::vector<Premise>& premises) {
  const Verdict all = fresh.check(premises);
  if (all == Verdict::consistent)
    throw std::logic_error("an explanation did not stand a second check");
  if (all == Verdict::undecided) return std::nullopt;
  std::vector<Clash::Member> members;
  for (const Premise& premise : premises) {
    const std::vector<Premise> others = without(premises, premise);
    const Verdict verdict = fresh.check(others);
    if (verdict == Verdict::inconsistent) return confirm(fresh, others);
    if (verdict == Verdict::undecided) return std::nullopt;
    members.push_back({premise, fresh.map()});
  }
  return members;
}

/// The face that a gateway without a segment opens into.
std::vector<PlaceArm> face_of(const TopologicalMap& map, PlaceArm open) {
  const Star& star = map.places[open.place.index()].star;
  for (std::size_t steps = 1; steps < star.size(); ++steps) {
    const PlaceArm next{open.place, star.clockwise(open.arm, steps)};
    for (const auto& face : faces(map))
      if (std::ranges::find(face, next) != face.end()) return face;
  }
  return {};
}

/// The border of a face without what it passes on both sides: closed ways, as rows of places.
std::vector<std::vector<PlaceId>> loops_of(const TopologicalMap& map,
                                           const std::vector<PlaceArm>& face) {
  std::map<PlaceArm, PlaceArm> linked;
  for (const auto& [one, other] : map.segments) {
    linked.emplace(one, other);
    linked.emplace(other, one);
  }
  std::vector<std::vector<PlaceId>> loops;
  std::vector<PlaceId> way;
  for (const PlaceArm& gateway : face) {
    if (std::ranges::find(face, linked.at(gateway)) != face.end()) continue;
    way.push_back(gateway.place);
    // A place met again closes a loop.
    const PlaceId next = linked.at(gateway).place;
    const auto begin = std::ranges::find(way, next);
    if (begin == way.end()) continue;
    loops.emplace_back(begin, way.end());
    way.erase(begin, way.end());
  }
  return loops;
}

/// @param anew  anew() makes the problem: twice, for the second to know nothing of the first
template <class Anew>
Reason reason(const Trace& trace, std::span<const Claim> claims, const Anew& anew) {
  MapProblem problem = anew();
  std::vector<Premise> premises = problem.premises();
  for (const Claim& claim : claims) premises.push_back(problem.add(claim));
  const Verdict verdict = problem.check(premises);
  if (verdict == Verdict::consistent) return {verdict, problem.map(), {}};
  if (verdict == Verdict::undecided) return {verdict, {}, {}};

  const auto core = minimise(problem, {problem.core().begin(), problem.core().end()});
  if (!core) return {Verdict::undecided, {}, {}};

  MapProblem fresh = anew();
  for (const Claim& claim : claims) fresh.add(claim);
  auto members = confirm(fresh, *core);
  if (!members) return {Verdict::undecided, {}, {}};
  Clash clash{std::move(*members), std::nullopt};
  for (const Clash::Member& member : clash.members)
    if (member.premise.kind == Premise::Kind::planarity)
      clash.crossing = find_crossing(trace, member.without);
  return {verdict, {}, std::move(clash)};
}

}  // namespace

std::optional<Crossing> find_crossing(const Trace& trace, const PartialMap& map) {
  for (std::size_t k = 1; k < map.size(); ++k) {
    const Sketch sketch = sketch_of(trace, std::span(map).first(k + 1));
    const auto part = part_not_planar(sketch.map);
    if (!part) continue;
    const auto [left, entered] = sketch.last.value();
    TopologicalMap before = *part;
    std::erase(before.segments, TopologicalMap::Segment(std::minmax(left, entered)));
    const std::vector<PlaceArm> face = face_of(before, left);
    return Crossing{VisitId(k), left, entered, part->segments, face, loops_of(before, face)};
  }
  return std::nullopt;
}

Reason explain(const Trace& trace, const Theory& theory, std::span<const Claim> claims,
               const Stop& stop) {
  return reason(trace, claims, [&] { return MapProblem(trace, theory, stop); });
}

Reason explain_candidate(const Trace& trace, const Theory& theory,
                         std::span<const Arrival> candidate, const Stop& stop) {
  return reason(trace, {}, [&] { return MapProblem(trace, theory, stop, candidate); });
}

}  // namespace asterism
