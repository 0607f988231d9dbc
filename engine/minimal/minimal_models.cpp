#include "engine/minimal/minimal_models.hpp"

#include <algorithm>

namespace asterism {

bool is_before(std::span<const Arrival> one, std::span<const Arrival> other) {
  for (const auto part : {true, false})
    for (std::size_t k = 0; k < one.size(); ++k) {
      const auto order =
          part ? one[k].place <=> other[k].place : one[k].entered <=> other[k].entered;
      if (order != 0) return order < 0;
    }
  return false;
}

std::vector<std::vector<Arrival>> minimal_models(const MapTree& tree) {
  std::vector<std::vector<Arrival>> models;
  tree.for_each(tree.minimal(), [&](HypothesisId, std::span<const Arrival> arrivals) {
    models.emplace_back(arrivals.begin(), arrivals.end());
  });
  std::ranges::sort(models, is_before);
  return models;
}

}  // namespace asterism
