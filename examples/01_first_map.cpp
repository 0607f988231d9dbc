// The whole of Asterism in one page: read a trace, grow the tree of maps visit by visit as a robot
// would, and look at the simplest maps that are left.

#include <cstdlib>
#include <iostream>

#include "engine/proof/certify.hpp"
#include "engine/tree/map_tree.hpp"
#include "io/json/trace_file.hpp"

using namespace asterism;

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: example_01_first_map TRACE\n";
    return EXIT_FAILURE;
  }
  const Trace trace = read_trace_file(argv[1]);

  MapTree tree({.planar = true});
  for (const Visit& visit : trace.visits) {
    tree.extend(visit);
    std::cout << tree.size() << ' ';
  }
  std::cout << "planar maps, visit by visit\n";

  std::vector<std::vector<Arrival>> models;
  for (const HypothesisId id : tree.minimal()) {
    const TopologicalMap map = tree.map(id);
    std::cout << map.places.size() << " places, " << map.paths.size() << " paths:";
    for (const PlaceId place : map.visits) std::cout << ' ' << place.index();
    std::cout << '\n';
    models.push_back(arrivals(map));
  }
  const bool certified = certify(trace, tree.options().theory, models) == Certificate::shown;
  std::cout << (certified ? "the solver agrees that none is simpler\n" : "not certified\n");
  return EXIT_SUCCESS;
}
