#include "io/path_of_arm.hpp"

#include <vector>

namespace asterism {

PathOfArm paths_of_arms(const TopologicalMap& map) {
  std::map<PlaceArm, PlaceArm> linked;
  for (const auto& [one, other] : map.segments) {
    linked.insert({one, other});
    linked.insert({other, one});
  }
  PathOfArm result;
  std::size_t path = 0;
  for (std::size_t p = 0; p < map.places.size(); ++p) {
    for (std::size_t arm = 0; arm < map.places[p].star.size(); ++arm) {
      std::vector<PlaceArm> open{{PlaceId(p), arm}};
      if (result.contains(open.front())) continue;
      while (!open.empty()) {
        const PlaceArm at = open.back();
        open.pop_back();
        if (!result.insert({at, path}).second) continue;
        open.push_back({at.place, map.places[at.place.index()].star.opposite(at.arm)});
        if (const auto over = linked.find(at); over != linked.end()) open.push_back(over->second);
      }
      ++path;
    }
  }
  return result;
}

}  // namespace asterism
