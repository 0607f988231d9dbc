#include <utility>

#include "tests/engine/tree/known_counts.hpp"

using namespace asterism;

TEST_CASE("the native engine finds every known number", "[engine][traces]") {
  const auto all = expected();
  for (const auto& [name, known] : all.items()) check_trace(name, Check::native);
}

TEST_CASE("a tree grown visit by visit is the tree grown in one pass", "[engine][traces]") {
  const auto all = expected();
  for (const auto& [name, known] : all.items()) {
    MapTree tree({.planar = true});
    for (Visit visit : trace(name).visits) {
      const auto left_by = std::exchange(visit.left_by, std::nullopt);
      REQUIRE(tree.extend(visit) == MapTree::Growth::complete);
      if (left_by) tree.leave(*left_by);
    }
    check_against(known.at("planar"), tree);
  }
}
