#include "tests/engine/seeded_walk.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "io/json/trace_file.hpp"
#include "simulation/corridor_world.hpp"
#include "simulation/grid_world.hpp"

namespace asterism {
namespace {

World seeded_world(unsigned seed, RandomEngine& engine) {
  switch (seed % 5) {
    case 0:
      return corridor_world({}, engine);
    case 1:
      return corridor_world({.corridors = 8, .ends_crossing = 0.6, .ends_blind = 0.3}, engine);
    case 2:
      return grid_world({.width = 3, .height = 2, .missing = 0.1, .stubs = 0.3}, engine);
    case 3:
      return grid_world({.width = 3, .height = 3}, engine);
    default:
      return grid_world({.width = 5, .height = 4, .missing = 0.3}, engine);
  }
}

}  // namespace

Walk seeded_walk(unsigned seed, std::size_t travels) {
  RandomEngine engine(seed);
  const World world = seeded_world(seed, engine);
  const Policy policy = seed % 7 == 0 ? Policy::laps : Policy::explore;
  Walk walked = walk(world, {.travels = travels, .policy = policy, .turn_around = 0.3}, engine);
  walked.trace.name = "red-" + std::to_string(seed);
  return walked;
}

std::string to_keep(unsigned seed, const Trace& trace) {
  return "seed " + std::to_string(seed) + "\n" + trace_json(trace);
}

const AxiomSet& shipped_with(const std::string& optional) {
  static std::map<std::string, AxiomSet> read;
  if (const auto known = read.find(optional); known != read.end()) return known->second;
  std::vector<std::string> names;
  if (!optional.empty()) names.push_back(optional);
  return read.emplace(optional, AxiomSet::shipped(names)).first->second;
}

MapTree tree_of(const Trace& trace, MapTree::Options options) {
  MapTree tree(std::move(options));
  if (tree.extend(trace.visits) != MapTree::Growth::complete)
    throw std::logic_error("the tree stopped growing");
  return tree;
}

std::vector<Association> maps_of(const MapTree& tree) {
  std::vector<Association> result;
  tree.for_each([&](HypothesisId, std::span<const Arrival> arrivals) {
    result.emplace_back(arrivals.begin(), arrivals.end());
  });
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<Association> minimal_of(const MapTree& tree) {
  std::vector<Association> result;
  tree.for_each(tree.minimal(), [&](HypothesisId, std::span<const Arrival> arrivals) {
    result.emplace_back(arrivals.begin(), arrivals.end());
  });
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace asterism
