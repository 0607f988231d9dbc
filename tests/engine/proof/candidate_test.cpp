#include "engine/proof/explain.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "engine/facts.hpp"
#include "tests/engine/command_line.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/support/axiom_files.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

/// Every way to go on to the next visit: any arm of any place, or a new place.
std::vector<Association> candidates(const Trace& trace, const Association& map) {
  const TopologicalMap written = make_map(trace, map);
  std::vector<Association> result;
  const auto add = [&](PlaceId place, std::optional<std::size_t> entered) {
    result.push_back(map);
    result.back().push_back({place, entered});
  };
  for (std::size_t place = 0; place < written.places.size(); ++place)
    for (std::size_t arm = 0; arm < written.places[place].star.size(); ++arm)
      add(PlaceId(place), arm);
  add(PlaceId(written.places.size()), trace.visits[map.size()].entered_by);
  return result;
}

/// Every candidate child of every planar map of a prefix of the trace.
std::vector<Association> all_candidates(const Trace& trace) {
  std::vector<Association> result;
  const auto levels = every_map_by_visit(trace, {.planar = true});
  for (std::size_t k = 0; k + 1 < levels.size(); ++k)
    for (const Association& map : levels[k])
      for (Association& child : candidates(trace, map)) result.push_back(std::move(child));
  return result;
}

using Kind = Premise::Kind;

/// Why a child is dropped; nothing where it is not.
std::optional<Clash> why_dropped(const Trace& trace, const Association& child, const Theory& theory,
                                 const Stop& stop = {}) {
  Reason reason = explain_candidate(trace, theory, child, stop);
  if (reason.verdict != Verdict::inconsistent) return std::nullopt;
  return std::move(reason.clash);
}

std::set<std::size_t> numbers(const Clash& reason, Kind kind) {
  std::set<std::size_t> result;
  for (const auto& [premise, without] : reason.members)
    if (premise.kind == kind) CHECK(result.insert(premise.number).second);
  return result;
}

std::set<std::string> axioms_of(const Clash& reason, const AxiomSet& axioms) {
  std::set<std::string> names;
  for (const std::size_t number : numbers(reason, Kind::axiom))
    names.insert(axioms.axioms().at(number).name);
  return names;
}

/// What is told of a refutation is about this child.
void check_mentions(const Clash& reason, const Trace& trace, const Association& child) {
  const TopologicalMap map = make_map(trace, child);
  if (reason.crossing)
    for (const PlaceArm& arm : {reason.crossing->left, reason.crossing->entered}) {
      REQUIRE(arm.place.index() < map.places.size());
      CHECK(arm.arm < map.places[arm.place.index()].star.size());
    }
  const std::set<std::size_t> visits = numbers(reason, Kind::visit);
  for (const std::size_t visit : visits) CHECK(visit < child.size());
  // Its parent is consistent: the last visit takes part.
  CHECK(visits.contains(child.size() - 1));
}

/// What is left without a member is part of the child.
void check_without(const Clash& reason, const Association& child) {
  const std::set<std::size_t> visits = numbers(reason, Kind::visit);
  for (const auto& [premise, without] : reason.members)
    for (std::size_t k = 0; k < without.size(); ++k) {
      if (!without[k]) continue;
      CHECK(visits.contains(k));
      CHECK(Premise{Kind::visit, k} != premise);
      for (std::size_t j = 0; j < k; ++j)
        if (without[j])
          CHECK((without[j]->place == without[k]->place) == (child[j].place == child[k].place));
    }
}

void check_reason(const Trace& trace, const Association& child) {
  const auto reason = why_dropped(trace, child, {shipped_with(), true});
  const bool accepted = is_consistent(trace, child, {});
  if (is_consistent(trace, child, {.planar = true})) {
    CHECK_FALSE(reason);
    return;
  }
  REQUIRE(reason);
  const bool not_planar = !numbers(*reason, Kind::planarity).empty();
  const std::set<std::string> axioms = axioms_of(*reason, shipped_with());
  CHECK(not_planar == accepted);
  CHECK(axioms.empty() == accepted);
  CHECK(reason->crossing.has_value() == accepted);
  check_mentions(*reason, trace, child);
  check_without(*reason, child);
  if (accepted) {
    CHECK_FALSE(why_dropped(trace, child, {shipped_with()}));
    return;
  }
  // The axioms named suffice, and none of them can be spared.
  const auto again = why_dropped(trace, child, {only(axioms)});
  REQUIRE(again);
  CHECK(numbers(*again, Kind::planarity).empty());
}

std::string answer(const std::string& command, const std::string& problem) {
  const std::string output = output_of(command, problem);
  return output.substr(0, output.find('\n'));
}

}  // namespace

TEST_CASE("every child dropped has a reason, and its axioms suffice",
          "[engine][explain][property]") {
  std::size_t children = 0;
  for (unsigned seed = 0; seed < 8; ++seed) {
    const Trace trace = seeded_walk(seed, 3 + seed % 2).trace;
    INFO(to_keep(seed, trace));
    for (const Association& child : all_candidates(trace)) {
      check_reason(trace, child);
      ++children;
    }
  }
  CHECK(children > 100);
}

TEST_CASE("planarity is the reason where the axioms accept the child",
          "[engine][explain][planarity][property]") {
  std::size_t found = 0;
  for (unsigned seed = 0; seed < 40 && found < 10; ++seed) {
    const Trace trace = seeded_walk(seed, 8).trace;
    INFO(to_keep(seed, trace));
    const auto planar = maps_of(tree_of(trace, true));
    for (const Association& map : maps_of(tree_of(trace, false))) {
      const Association parent(map.begin(), map.end() - 1);
      if (std::ranges::binary_search(planar, map)) continue;
      if (!is_consistent(trace, parent, {.planar = true})) continue;
      ++found;
      check_reason(trace, map);
    }
  }
  CHECK(found >= 10);
}

TEST_CASE("an optional axiom is named where it alone refutes", "[engine][explain][axioms]") {
  for (const char* const name : {"one_segment", "one_crossing"}) {
    std::size_t found = 0;
    for (unsigned seed = 0; seed < 60 && found < 3; ++seed) {
      const Trace trace = seeded_walk(seed, 7).trace;
      INFO(to_keep(seed, trace));
      const auto kept = maps_of(tree_of(trace, {.theory = {.axioms = shipped_with(name)}}));
      for (const Association& map : maps_of(tree_of(trace, false))) {
        if (std::binary_search(kept.begin(), kept.end(), map)) continue;
        ++found;
        const auto reason = why_dropped(trace, map, {shipped_with(name)});
        REQUIRE(reason);
        CHECK(axioms_of(*reason, shipped_with(name)).contains(name));
      }
    }
    CHECK(found >= 3);
  }
}

TEST_CASE("without time no reason is made up", "[engine][explain]") {
  const Trace trace = seeded_walk(2, 6).trace;
  for (const Association& map : maps_of(tree_of(trace, false)))
    CHECK_FALSE(why_dropped(trace, map, {shipped_with()}, Stop{}.within(1e-3)));
}

TEST_CASE("solvers on the command line give the same verdict on the problem written out",
          "[engine][explain][property]") {
  const std::string command = GENERATE("z3", "cvc5 --lang=smt2");
  if (!is_installed(command)) {
    WARN(command << " is not installed");
    return;
  }
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Trace trace = seeded_walk(seed, 5).trace;
    INFO(to_keep(seed, trace));
    const auto children = all_candidates(trace);
    for (std::size_t i = 0; i < children.size(); i += 1 + children.size() / 6) {
      const std::string expected = is_consistent(trace, children[i], {}) ? "sat" : "unsat";
      CHECK(answer(command, smt2_text(trace, children[i], shipped_with())) == expected);
    }
    const Association map = maps_of(tree_of(trace, false)).back();
    CHECK(answer(command, smt2_text(trace, map, shipped_with())) == "sat");
  }
}
