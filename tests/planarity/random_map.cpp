#include "tests/planarity/random_map.hpp"

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include "planarity/euler.hpp"

namespace asterism {
namespace {

class Growth {
 public:
  Growth(std::uint32_t seed, const RandomMapOptions& options) : random_(seed), options_(options) {
    add_place(2);
    while (!open_.empty()) {
      const PlaceArm gateway = take_open(below(open_.size()));
      if (below(3) == 0 && close(gateway)) continue;
      if (map_.places.size() < options.most_places) {
        add_place(1);
        const std::size_t entered = open_.size() - 1 - below(newest_gateways_);
        map_.segments.push_back(std::minmax(gateway, take_open(entered)));
      }
    }
    std::sort(map_.segments.begin(), map_.segments.end());
  }

  TopologicalMap map() && { return std::move(map_); }

 private:
  std::size_t below(std::size_t bound) { return random_() % bound; }

  PlaceArm take_open(std::size_t i) {
    const PlaceArm gateway = open_[i];
    open_.erase(open_.begin() + static_cast<std::ptrdiff_t>(i));
    return gateway;
  }

  void add_place(std::size_t least_local_paths) {
    const PlaceId place(map_.places.size());
    const Star star = random_star(least_local_paths);
    map_.places.push_back({star, VisitId(place.index())});
    newest_gateways_ = 0;
    for (std::size_t arm = 0; arm < star.size(); ++arm) {
      if (!star.has_gateway(arm)) continue;
      open_.push_back({place, arm});
      ++newest_gateways_;
    }
  }

  /// Half of the local-paths have α = 0 in one direction.
  Star random_star(std::size_t least_local_paths) {
    const std::size_t choices = options_.most_local_paths + 1 - least_local_paths;
    const std::size_t local_paths = least_local_paths + below(4 * choices - 1) / 4;
    std::vector<Arm> arms;
    for (std::size_t i = 0; i < local_paths; ++i) {
      const std::size_t fate = below(4);
      for (const auto& [sign, ending] : {std::pair('+', 0U), std::pair('-', 1U)}) {
        const auto position = static_cast<std::ptrdiff_t>(below(arms.size() + 1));
        arms.insert(arms.begin() + position, {"p" + std::to_string(i), sign, fate != ending});
      }
    }
    return Star(arms);
  }

  /// Joins the gateway to an open one of another place, where there is one that fits.
  bool close(PlaceArm gateway) {
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < open_.size(); ++i)
      if (open_[i].place != gateway.place) candidates.push_back(i);
    std::shuffle(candidates.begin(), candidates.end(), random_);
    for (const std::size_t i : candidates) {
      map_.segments.push_back(std::minmax(gateway, open_[i]));
      if (!options_.is_planar || is_planar(map_)) {
        take_open(i);
        return true;
      }
      map_.segments.pop_back();
    }
    return false;
  }

  std::mt19937 random_;
  RandomMapOptions options_;
  TopologicalMap map_;
  std::vector<PlaceArm> open_;
  std::size_t newest_gateways_ = 0;
};

}  // namespace

TopologicalMap random_map(std::uint32_t seed, const RandomMapOptions& options) {
  return Growth(seed, options).map();
}

}  // namespace asterism
