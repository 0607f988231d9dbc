#include <algorithm>

#include "tests/engine/seeded_walk.hpp"
#include "tests/support/axiom_files.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

/// How one visit's star is listed: arm i of the old listing is position(i) of the new one.
struct Listing {
  std::size_t size;
  std::size_t first;
  std::size_t position(std::size_t arm) const { return (arm + size - first) % size; }
};

struct Relisted {
  Trace trace;
  std::vector<Listing> listings;
};

/// Lists every star from a random arm, with new labels and some pairs of signs swapped.
Relisted relisted(const Trace& trace, RandomEngine& engine) {
  Relisted result{trace, {}};
  for (Visit& visit : result.trace.visits) {
    const Star old = visit.star;
    const Listing listing{old.size(), below(old.size(), engine)};
    std::vector<Arm> arms(old.size());
    for (std::size_t i = 0; i < old.size(); ++i) {
      const bool swapped = old.arm(i).label.back() % 2 == 0;
      const char sign = (old.arm(i).sign == '+') != swapped ? '+' : '-';
      arms[listing.position(i)] = {"new_" + old.arm(i).label, sign, old.has_gateway(i)};
    }
    visit.star = Star(std::move(arms));
    if (visit.entered_by) visit.entered_by = listing.position(*visit.entered_by);
    if (visit.left_by) visit.left_by = listing.position(*visit.left_by);
    result.listings.push_back(listing);
  }
  return result;
}

Association relisted(const Association& map, const std::vector<Listing>& listings) {
  Association result;
  std::vector<Listing> of_place;
  for (std::size_t k = 0; k < map.size(); ++k) {
    const auto& [place, entered] = map[k];
    if (place.index() == of_place.size()) of_place.push_back(listings[k]);
    result.push_back({place, entered});
    if (entered) result.back().entered = of_place[place.index()].position(*entered);
  }
  return result;
}

/// The same map as the one who walks the trace backwards tells it: places numbered by last visit,
/// arms as listed there.
Association backwards(const Trace& trace, const Association& association) {
  const TopologicalMap map = make_map(trace, association);
  std::vector<std::optional<PlaceId>> number(map.places.size());
  std::vector<std::size_t> turned(map.places.size());  // clockwise, from its listing to the place's
  std::size_t places = 0;
  Association result;
  for (std::size_t k = map.visits.size(); k-- > 0;) {
    const std::size_t place = map.visits[k].index();
    const std::size_t size = map.places[place].star.size();
    if (!number[place]) {
      number[place] = PlaceId(places++);
      if (map.entered[k])
        turned[place] = (*map.entered[k] + size - *trace.visits[k].entered_by) % size;
    }
    result.push_back({*number[place], {}});
    if (map.left[k]) result.back().entered = (*map.left[k] + size - turned[place]) % size;
  }
  return result;
}

template <class F>
std::vector<Association> transformed(std::vector<Association> maps, F&& f) {
  for (Association& map : maps) map = f(map);
  std::sort(maps.begin(), maps.end());
  return maps;
}

}  // namespace

TEST_CASE("labels, signs and the arm listed first change nothing", "[engine][property]") {
  for (unsigned seed = 0; seed < 150; ++seed) {
    const Trace trace = seeded_walk(seed, 5 + seed % 8).trace;
    INFO(to_keep(seed, trace));
    RandomEngine engine(seed);
    const auto [other_trace, listings] = relisted(trace, engine);
    const auto relist = [&, &to = listings](const Association& map) { return relisted(map, to); };
    for (const bool planar : {false, true}) {
      const MapTree tree = tree_of(trace, planar);
      const MapTree other = tree_of(other_trace, planar);
      CHECK(std::ranges::equal(other.per_visit(), tree.per_visit()));
      CHECK(maps_of(other) == transformed(maps_of(tree), relist));
      CHECK(minimal_of(other) == transformed(minimal_of(tree), relist));
    }
  }
}

TEST_CASE("a trace walked backwards has the same maps", "[engine][property]") {
  for (unsigned seed = 0; seed < 150; ++seed) {
    const Trace trace = seeded_walk(seed, 5 + seed % 8).trace;
    INFO(to_keep(seed, trace));
    const auto turn = [&](const Association& map) { return backwards(trace, map); };
    for (const bool planar : {false, true}) {
      const MapTree tree = tree_of(trace, planar);
      const MapTree back = tree_of(reversed(trace), planar);
      CHECK(maps_of(back) == transformed(maps_of(tree), turn));
      CHECK(minimal_of(back) == transformed(minimal_of(tree), turn));
    }
  }
}

TEST_CASE("however the visits come in, the tree is the same, in the same order",
          "[engine][property]") {
  for (unsigned seed = 0; seed < 150; ++seed) {
    const Trace trace = seeded_walk(seed, 5 + seed % 8).trace;
    INFO(to_keep(seed, trace));
    RandomEngine engine(seed);
    const auto in_order = [](const MapTree& tree) {
      std::vector<Association> result;
      tree.for_each([&](HypothesisId id, std::span<const Arrival> map) {
        CHECK(id.index() == result.size());
        result.emplace_back(map.begin(), map.end());
      });
      return result;
    };
    for (const bool planar : {false, true}) {
      const MapTree at_once = tree_of(trace, planar);
      MapTree in_pieces({.axioms = shipped_with(), .planar = planar});
      for (std::size_t from = 0; from < trace.visits.size();) {
        const std::size_t count = 1 + below(trace.visits.size() - from, engine);
        const auto piece = std::span(trace.visits).subspan(from, count);
        REQUIRE(in_pieces.extend(piece) == MapTree::Growth::complete);
        from += count;
      }
      MapTree one_by_one({.axioms = shipped_with(), .planar = planar});
      for (Visit visit : trace.visits) {
        const auto left_by = std::exchange(visit.left_by, std::nullopt);
        REQUIRE(one_by_one.extend(visit) == MapTree::Growth::complete);
        if (left_by) one_by_one.leave(*left_by);
      }
      for (const MapTree* tree : {&in_pieces, &one_by_one}) {
        CHECK(in_order(*tree) == in_order(at_once));
        CHECK(std::ranges::equal(tree->per_visit(), at_once.per_visit()));
        CHECK(std::ranges::equal(tree->minimal(), at_once.minimal()));
      }
    }
  }
}

TEST_CASE("minimal models are the least maps, whatever the order of preference",
          "[engine][preference][property]") {
  using Order = std::vector<std::string>;
  const auto order = GENERATE(values<Order>({{"path", "place"},
                                             {"place", "path"},
                                             {"segment", "path"},
                                             {"path", "segment", "place"},
                                             {"place"}}));
  std::string text;
  for (const std::string& extent : order) text += " " + extent;
  AxiomFiles files = shipped_files();
  files["preference.smt2"] = "(set-info :minimise (" + text.substr(1) + "))\n";
  const AxiomSet axioms = AxiomSet::parse(files);
  REQUIRE(axioms.preference_names() == order);
  for (unsigned seed = 0; seed < 100; ++seed) {
    const Trace trace = seeded_walk(seed, 5 + seed % 8).trace;
    INFO(to_keep(seed, trace));
    const MapTree tree = tree_of(trace, {.theory = {.axioms = axioms, .planar = seed % 2 == 1}});
    std::vector<std::size_t> least;
    std::vector<Association> minimal;
    for (const Association& association : maps_of(tree)) {
      const TopologicalMap map = make_map(trace, association);
      std::vector<std::size_t> extents;
      for (const std::string& extent : order)
        extents.push_back(extent == "path"    ? map.paths.size()
                          : extent == "place" ? map.places.size()
                                              : map.segments.size());
      if (minimal.empty() || extents < least) {
        least = extents;
        minimal.clear();
      }
      if (extents == least) minimal.push_back(association);
    }
    CHECK(minimal_of(tree) == minimal);
  }
}
