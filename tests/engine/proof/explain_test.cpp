#include "engine/proof/explain.hpp"

#include <algorithm>

#include "axioms/axiom_solver.hpp"
#include "engine/ask/query_reader.hpp"
#include "engine/facts.hpp"
#include "planarity/euler.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/engine/tree/known_counts.hpp"
#include "tests/support/axiom_files.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

Stop ample() { return Stop{}.within(600); }
constexpr unsigned ample_ms = 60'000;

struct Pair {
  std::size_t one, other;
  bool same;  ///< or they differ
};

Claim claim_of(const Pair& pair) {
  const Claim same{Claim::Same{VisitId(pair.one), VisitId(pair.other)}};
  return pair.same ? same : Claim{Claim::Not{{same}}};
}

/// Looks for a map of some visits, one visit after another: each may be at any arm of any place or
/// at a new one, and a solver that keeps to the ground is asked at each.
class MapOfVisits {
 public:
  MapOfVisits(const Trace& trace, const std::set<std::size_t>& told, const AxiomSet& axioms,
              bool planar, const std::vector<Pair>& pairs)
      : trace_(trace),
        told_(told.begin(), told.end()),
        planar_(planar),
        pairs_(pairs),
        solver_(axioms, ample_ms),
        named_(trace.visits.size()) {
    for (const Visit& visit : trace.visits) table_.append(visit);
    solver_.add(general_facts());
  }

  bool exists() { return place_from(0); }

  /// Whether this map, given, is one.
  bool is_map(const PartialMap& map) {
    std::vector<VisitId> first_visits;
    for (std::size_t i = 0; i < told_.size(); ++i) {
      const std::size_t k = told_[i];
      if (!map[k]) return false;
      const bool is_new = map[k]->place.index() == first_visits.size();
      if (is_new) first_visits.emplace_back(k);
      const VisitId first = first_visits.at(map[k]->place.index());
      if (!enter(VisitId(k), table_.arm(first, map[k]->entered.value_or(0)))) return false;
    }
    for (std::size_t k = 0; k < map.size(); ++k)
      if (map[k] && !is_told(k)) return false;
    return is_accepted();
  }

 private:
  bool is_told(std::size_t k) const { return std::ranges::find(told_, k) != told_.end(); }

  bool place_from(std::size_t i) {
    if (i == told_.size()) return is_accepted();
    const VisitId k(told_[i]);
    std::vector<ArmId> arms{table_.entered(k)};
    for (std::size_t j = 0; j < i; ++j) {
      const VisitId earlier(told_[j]);
      if (table_.visit_of(*named_[earlier]) != earlier) continue;
      for (const ArmId arm : table_.arms(earlier)) arms.push_back(arm);
    }
    for (const ArmId arm : arms) {
      solver_.push();
      const bool found = enter(k, arm) && place_from(i + 1);
      solver_.pop();
      named_[k].reset();
      if (found) return true;
    }
    return false;
  }

  bool enter(VisitId k, ArmId arm) {
    named_[k] = arm;
    for (const auto& [one, other, same] : pairs_)
      if (named_[VisitId(one)] && named_[VisitId(other)] &&
          (table_.visit_of(*named_[VisitId(one)]) == table_.visit_of(*named_[VisitId(other)])) !=
              same)
        return false;
    if (table_.visit_of(arm) == k) solver_.add(place_facts(table_, k));
    if (k.index() == 0) return true;
    const VisitId before = k.previous();
    const bool travelled = is_told(before.index());
    const auto facts =
        travel_facts(table_, k, travelled ? table_.left(before, *named_[before]) : arm, arm);
    solver_.add(std::span(facts).first(travelled ? 2 : 1));
    return solver_.check() != Verdict::inconsistent;
  }

  bool is_accepted() const {
    if (!planar_) return true;
    TopologicalMap map;
    std::map<VisitId, PlaceId> places;
    std::set<TopologicalMap::Segment> segments;
    const auto gateway = [&](ArmId arm) {
      return PlaceArm{places.at(table_.visit_of(arm)), table_.position(arm)};
    };
    for (const std::size_t told : told_) {
      const VisitId k(told);
      if (table_.visit_of(*named_[k]) == k) {
        places.emplace(k, PlaceId(map.places.size()));
        map.places.push_back({trace_.visits[told].star, k});
      }
      if (told > 0 && is_told(told - 1))
        segments.insert(std::minmax(gateway(table_.left(k.previous(), *named_[k.previous()])),
                                    gateway(*named_[k])));
    }
    map.segments.assign(segments.begin(), segments.end());
    return can_be_drawn(map);
  }

  /// Whichever segments are taken where a gateway has several.
  static bool can_be_drawn(const TopologicalMap& map) {
    for (std::size_t i = 0; i < map.segments.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        const auto& [a, b] = map.segments[i];
        const auto& [c, d] = map.segments[j];
        if (i == j ? a != b : a != c && a != d && b != c && b != d) continue;
        for (const std::size_t spared : {i, j}) {
          TopologicalMap fewer = map;
          fewer.segments.erase(fewer.segments.begin() + static_cast<std::ptrdiff_t>(spared));
          if (!can_be_drawn(fewer)) return false;
        }
        return true;
      }
    return is_planar(map);
  }

  const Trace& trace_;
  std::vector<std::size_t> told_;
  bool planar_;
  std::vector<Pair> pairs_;
  AxiomSolver solver_;
  ArmTable table_;
  IdVector<VisitId, std::optional<ArmId>> named_;
};

/// What a clash says, or what is left of it without one member.
struct Parts {
  std::set<std::size_t> visits;
  std::set<std::string> axioms;
  bool planar = false;
  std::vector<Pair> pairs;

  void add(const Premise& premise, const std::vector<Pair>& given) {
    switch (premise.kind) {
      case Premise::Kind::visit:
        visits.insert(premise.number);
        break;
      case Premise::Kind::axiom:
        axioms.insert(shipped_with().axioms()[premise.number].name);
        break;
      case Premise::Kind::planarity:
        planar = true;
        break;
      case Premise::Kind::claim:
        pairs.push_back(given.at(premise.number));
        break;
    }
  }
  MapOfVisits search(const Trace& trace) const {
    return {trace, visits, only(axioms), planar, pairs};
  }
};

/// The members clash, and the map shown for each is one that all the others allow.
void check_clash(const Trace& trace, const Clash& clash, const std::vector<Pair>& given) {
  Parts all;
  for (const auto& [premise, without] : clash.members) all.add(premise, given);
  CHECK_FALSE(all.search(trace).exists());
  for (const auto& [spared, without] : clash.members) {
    Parts others;
    for (const auto& [premise, map] : clash.members)
      if (premise != spared) others.add(premise, given);
    CHECK(others.search(trace).is_map(without));
  }
}

bool is_in_some_map(const std::vector<Association>& maps, const std::vector<Pair>& pairs) {
  return std::ranges::any_of(maps, [&](const Association& map) {
    return std::ranges::all_of(pairs, [&](const Pair& pair) {
      return (map[pair.one].place == map[pair.other].place) == pair.same;
    });
  });
}

/// @return  what the explanation rests on, if the claim is impossible
std::optional<Clash> check_explained(const Trace& trace, bool planar,
                                     const std::vector<Association>& maps,
                                     const std::vector<Pair>& pairs) {
  for (const Pair& pair : pairs) INFO(pair.one << (pair.same ? " = " : " != ") << pair.other);
  std::vector<Claim> claims;
  for (const Pair& pair : pairs) claims.push_back(claim_of(pair));
  const Reason reason = explain(trace, {shipped_with(), planar}, claims, ample());
  REQUIRE(reason.verdict != Verdict::undecided);
  CHECK((reason.verdict == Verdict::consistent) == is_in_some_map(maps, pairs));
  if (reason.verdict == Verdict::consistent) {
    Association map;
    for (const auto& arrival : reason.map) map.push_back(arrival.value());
    CHECK(std::ranges::find(maps, map) != maps.end());
    CHECK(is_in_some_map({map}, pairs));
    return std::nullopt;
  }
  check_clash(trace, reason.clash, pairs);
  return reason.clash;
}

void check_every_pair(const std::string& name, std::size_t step) {
  const Trace known = trace(name);
  for (const bool planar : {false, true}) {
    const std::vector<Association> maps = maps_of(tree_of(known, planar));
    std::size_t pair = planar ? step / 2 : 0;
    std::size_t explained = 0;
    for (std::size_t i = 0; i < known.visits.size(); ++i)
      for (std::size_t j = i + 1; j < known.visits.size(); ++j) {
        if (pair++ % step != 0) continue;
        INFO(name << (planar ? ", planar" : ""));
        explained += check_explained(known, planar, maps, {{i, j, true}}) ? 1U : 0U;
      }
    CHECK(explained > 0);
  }
}

/// Claims about two pairs of visits; how many were impossible.
std::size_t check_worlds(unsigned first_seed, unsigned seeds) {
  std::size_t impossible = 0;
  for (unsigned seed = first_seed; seed < first_seed + seeds; ++seed) {
    RandomEngine engine(seed);
    const Trace trace = seeded_walk(seed, 5 + seed % 3).trace;
    INFO(to_keep(seed, trace));
    const auto visit = [&] { return below(trace.visits.size(), engine); };
    const std::vector<Pair> pairs{{visit(), visit(), true}, {visit(), visit(), seed % 4 != 0}};
    for (const bool planar : {false, true}) {
      const auto explanation =
          check_explained(trace, planar, maps_of(tree_of(trace, planar)), pairs);
      impossible += explanation ? 1U : 0U;
    }
  }
  return impossible;
}

}  // namespace

TEST_CASE("explanations of pairs of visits clash, and none of their members can be spared") {
  check_every_pair("eight-crossings", 40);
  check_every_pair("aces-stubs", 41);
  check_every_pair("grid-4x4-snake", 42);
}

TEST_CASE("each impossible pair of visits is explained by what cannot be spared", "[full]") {
  check_every_pair("eight-crossings", 1);
  check_every_pair("aces-stubs", 1);
  check_every_pair("grid-4x4-snake", 1);
}

TEST_CASE("where planarity clashes, the closed way to cross is told") {
  const Trace known = trace("eight-crossings");
  const std::vector<Pair> pairs{{2, 10, true}, {4, 11, true}};
  CHECK_FALSE(check_explained(known, false, maps_of(tree_of(known, false)), pairs));
  const auto explanation = check_explained(known, true, maps_of(tree_of(known, true)), pairs);
  REQUIRE(explanation);
  REQUIRE(explanation->crossing);
  const Crossing& crossing = *explanation->crossing;
  CHECK(crossing.visit == VisitId(11));
  REQUIRE(crossing.loops.size() == 1);
  CHECK(crossing.loops.front().size() == 8);
}

TEST_CASE("clashes are explained on random worlds") { CHECK(check_worlds(0, 24) > 5); }

TEST_CASE("clashes are explained on 500 random worlds", "[full]") {
  CHECK(check_worlds(24, 500) > 100);
}
