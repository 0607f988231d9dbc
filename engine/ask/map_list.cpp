#include "engine/ask/map_list.hpp"

namespace asterism {

MapList all_maps(const MapTree& tree) {
  return {tree.trace(), tree.options().theory, tree.size(), [&tree](const auto& f) {
            tree.for_each_while([&](HypothesisId, std::span<const Arrival> map) { return f(map); });
          }};
}

MapList minimal_maps(const MapTree& tree) {
  return {tree.trace(), tree.options().theory, tree.minimal().size(), [&tree](const auto& f) {
            tree.for_each_while(tree.minimal(),
                                [&](HypothesisId, std::span<const Arrival> map) { return f(map); });
          }};
}

MapList minimal_maps(const MinimalSearch& search) {
  return {search.trace(), search.options().theory, search.bounds().count,
          [&search](const auto& f) { search.for_each_while(f); }};
}

}  // namespace asterism
