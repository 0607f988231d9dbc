#include "mapping/sorted_maps.hpp"

#include <algorithm>
#include <utility>

#include "tests/mapping/shipped_trace.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

TEST_CASE("maps are told by places of visits, then by arms entered by, each once",
          "[mapping][unit]") {
  MapTree tree;
  tree.extend(shipped_trace("aces-stubs").visits);
  std::vector<std::pair<std::vector<PlaceId>, std::vector<std::optional<std::size_t>>>> told;
  SortedMaps(tree).for_each(
      [&](const TopologicalMap& map) { told.emplace_back(map.visits, map.entered); });
  CHECK(told.size() == 107);
  CHECK(std::ranges::is_sorted(told));
  CHECK(std::ranges::adjacent_find(told) == told.end());
}
