#include "mapping/sorted_maps.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

namespace asterism {

SortedMaps::SortedMaps(const MapTree& tree) : tree_(tree), width_(2 * tree.trace().visits.size()) {
  keys_.reserve(width_ * tree.size());
  tree.for_each([&](HypothesisId, std::span<const Arrival> arrivals) {
    for (const Arrival& arrival : arrivals)
      keys_.push_back(static_cast<std::uint32_t>(arrival.place.index()));
    for (const Arrival& arrival : arrivals)
      keys_.push_back(arrival.entered ? static_cast<std::uint32_t>(*arrival.entered) + 1 : 0);
  });
  order_.resize(tree.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::ranges::sort(order_, [&](std::size_t a, std::size_t b) {
    return std::ranges::lexicographical_compare(key(a), key(b));
  });
}

void SortedMaps::for_each(const std::function<void(const TopologicalMap&)>& f) const {
  for (const std::size_t i : order_) {
    std::vector<Arrival> arrivals;
    for (std::size_t k = 0; k < width_ / 2; ++k) {
      const std::uint32_t entered = key(i)[width_ / 2 + k];
      arrivals.push_back({PlaceId(key(i)[k]), std::nullopt});
      if (entered > 0) arrivals.back().entered = entered - 1;
    }
    f(make_map(tree_.trace(), arrivals));
  }
}

}  // namespace asterism
