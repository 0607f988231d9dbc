#include "io/path_colours.hpp"

#include <array>
#include <vector>

namespace asterism {
namespace {

// Okabe and Ito's colours for all kinds of sight, without their yellow, which fades on white paper;
// then darker companions. Neighbouring numbers differ in lightness too.
constexpr std::array palette{"#0072b2", "#e69f00", "#009e73", "#cc79a7", "#d55e00", "#56b4e9",
                             "#882255", "#999933", "#332288", "#44aa99", "#aa4499", "#6d4c41"};

}  // namespace

PathOfArm paths_of_arms(const TopologicalMap& map) {
  std::map<PlaceArm, PlaceArm> linked;
  for (const auto& [one, other] : map.segments) {
    linked.insert({one, other});
    linked.insert({other, one});
  }
  // Paths are numbered by their smallest arms, so in the order found.
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

const char* path_colour(std::size_t path) { return palette[path % palette.size()]; }

}  // namespace asterism
