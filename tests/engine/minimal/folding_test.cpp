#include "engine/minimal/folding.hpp"

#include <algorithm>

#include "tests/engine/minimal/small_trace.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

using Pairs = std::vector<std::pair<ArmId, ArmId>>;

Verdict begin(Folding& folding, const Folding* before = nullptr,
              const std::vector<Assumption>& assumptions = {}) {
  return folding.begin(assumptions, before, {});
}

/// All that can be asked of a folding.
std::vector<std::size_t> told(const Folding& folding, const ArmTable& table) {
  std::vector<std::size_t> result;
  for (const VisitId visit : folding.settled().visits()) result.push_back(visit.index());
  for (const VisitId visit : table.all_visits()) {
    result.push_back(folding.arms().representative(visit).index());
    result.push_back(folding.settled().contains(visit));
    result.push_back(folding.arms().visits_there(visit));
  }
  for (const ArmId x : table.all_arms()) {
    result.push_back(folding.arms().representative(x).index());
    result.push_back((*folding.arms().across(x)).index());
    for (const ArmId y : table.all_arms()) result.push_back(folding.arms().may_be_one(x, y));
    folding.for_each_settled(x, [&](ArmId y) {
      result.push_back(y.index());
      return true;
    });
  }
  return result;
}

/// Which arms are one, whatever stands for them.
std::vector<bool> one(const Folding& folding, const ArmTable& table) {
  std::vector<bool> result;
  for (const ArmId x : table.all_arms())
    for (const ArmId y : IdRange(ArmId(0), x))
      result.push_back(folding.arms().representative(x) == folding.arms().representative(y));
  return result;
}

Pairs random_pairs(std::size_t arms, std::size_t count, const Folding& folding,
                   RandomEngine& engine) {
  Pairs result;
  for (std::size_t n = 0; n < 200 && result.size() < count; ++n) {
    const auto x = folding.arms().representative(ArmId(below(arms, engine)));
    const auto y = folding.arms().representative(ArmId(below(arms, engine)));
    if (x != y && folding.arms().may_be_one(x, y)) result.emplace_back(x, y);
  }
  return result;
}

bool identify(Folding& folding, const Pairs& pairs) {
  return std::ranges::all_of(
      pairs, [&](const auto& pair) { return folding.identify(pair.first, pair.second); });
}

}  // namespace

TEST_CASE("what is done to a folding is undone", "[engine][folding][property]") {
  std::size_t steps = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Trace trace = small_trace(seed, 500);
    INFO(to_keep(seed, trace));
    const ArmTable table(trace);
    Folding folding(table, {.faces = seed % 2 == 0, .one_segment = seed % 3 == 0});
    if (begin(folding) != Verdict::consistent) continue;
    RandomEngine engine(seed);
    const auto at_first = told(folding, table);
    std::vector<std::pair<Folding::Mark, std::vector<std::size_t>>> marks;
    for (int n = 0; n < 30; ++n) {
      if (!marks.empty() && chance(0.3, engine)) {
        marks.resize(1 + below(marks.size(), engine));
        folding.undo(marks.back().first);
        REQUIRE(told(folding, table) == marks.back().second);
        marks.pop_back();
        continue;
      }
      marks.emplace_back(folding.mark(), told(folding, table));
      const auto arm = ArmId(below(table.size(), engine));
      const bool holds = chance(0.4, engine)
                             ? folding.settle(arm)
                             : identify(folding, random_pairs(table.size(), 1, folding, engine));
      ++steps;
      if (holds) continue;
      folding.undo(marks.back().first);
      REQUIRE(told(folding, table) == marks.back().second);
      marks.pop_back();
    }
    folding.undo({});
    CHECK(told(folding, table) == at_first);
  }
  CHECK(steps > 5'000);
}

TEST_CASE("it does not matter in which order arms are identified", "[engine][folding][property]") {
  std::size_t held = 0;
  std::size_t contradicted = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    const Trace trace = small_trace(seed, 500);
    INFO(to_keep(seed, trace));
    const ArmTable table(trace);
    Folding folding(table, {});
    REQUIRE(begin(folding) == Verdict::consistent);
    RandomEngine engine(seed);
    Pairs pairs = random_pairs(table.size(), 2 + below(3, engine), folding, engine);
    const bool holds = identify(folding, pairs);
    const std::vector<bool> first = one(folding, table);
    for (int n = 0; n < 5; ++n) {
      folding.undo({});
      for (std::size_t i = pairs.size(); i > 1; --i)
        std::swap(pairs[i - 1], pairs[below(i, engine)]);
      for (auto& [x, y] : pairs)
        if (chance(0.5, engine)) std::swap(x, y);
      REQUIRE(identify(folding, pairs) == holds);
      if (holds) CHECK(one(folding, table) == first);
    }
    ++(holds ? held : contradicted);
  }
  CHECK(held > 100);
  CHECK(contradicted > 100);
}

TEST_CASE("every map is a folding, and nothing forbids it", "[engine][folding][property]") {
  std::size_t maps = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Trace trace = small_trace(seed, 100);
    INFO(to_keep(seed, trace));
    const bool planar = seed % 2 == 0;
    const ArmTable table(trace);
    Folding folding(table, {.faces = planar});
    REQUIRE(begin(folding) == Verdict::consistent);
    for (const Association& map : maps_of(tree_of(trace, planar))) {
      ++maps;
      const std::vector<ArmId> named = table.named(map);
      for (const VisitId k : table.all_visits()) {
        const ArmId x = folding.arms().representative(table.entered(k));
        const ArmId y = folding.arms().representative(named[k.index()]);
        const bool is_new = table.visit_of(named[k.index()]) == k;
        if (is_new && !folding.settled().contains(table.visit_of(x))) REQUIRE(folding.settle(x));
        if (!is_new && x != y) {
          REQUIRE(folding.arms().may_be_one(x, y));
          REQUIRE(folding.identify(x, y));
        }
      }
      CHECK(folding.named() == named);
      folding.undo({});
    }
  }
  CHECK(maps > 5'000);
}

TEST_CASE("a folding begun from a shorter one is the same", "[engine][folding][property]") {
  for (unsigned seed = 0; seed < 500; ++seed) {
    const Trace trace = small_trace(seed, 500);
    INFO(to_keep(seed, trace));
    RandomEngine engine(seed);
    const ArmTable table(trace);
    const ArmTable shorter(trace, 1 + below(trace.visits.size(), engine));
    std::vector<Assumption> assumptions;
    if (seed % 4 == 0)
      assumptions.push_back(
          {Assumption::Kind::differ, VisitId(0), VisitId(1 + below(trace.visits.size(), engine))});
    const NativeEngine::Rules axioms{.one_segment = seed % 3 == 0};
    Folding before(shorter, axioms);
    Folding after(table, axioms);
    Folding at_once(table, axioms);
    if (begin(before, nullptr, assumptions) != Verdict::consistent) continue;
    const Verdict verdict = begin(at_once, nullptr, assumptions);
    REQUIRE(begin(after, &before, assumptions) == verdict);
    if (verdict != Verdict::consistent) continue;
    CHECK(told(after, table) == told(at_once, table));
  }
}

TEST_CASE("a folding stopped while it begins can be begun again", "[engine][folding]") {
  const ArmTable table(small_trace(3, 500));
  Folding folding(table, {});
  for (int n = 0;; ++n) {
    int left = n;
    const Verdict verdict = folding.begin({}, nullptr, stop_unless([&] { return left-- > 0; }));
    if (verdict == Verdict::consistent) break;
    REQUIRE(verdict == Verdict::undecided);
  }
  Folding at_once(table, {});
  REQUIRE(begin(at_once) == Verdict::consistent);
  CHECK(told(folding, table) == told(at_once, table));
}
