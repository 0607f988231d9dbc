// From a laser log to ranked maps: perceive the places, find every map that explains the drive, lay
// each out, and rank them by preference and likelihood.

#include <cstdlib>
#include <iostream>

#include "core/error.hpp"
#include "mapping/log_maps.hpp"

using namespace asterism;

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << "usage: example_06_log_to_map LOG\n";
    return EXIT_FAILURE;
  }
  const LogMaps found =
      map_log(argv[1], {.maps = {.theory = {.planar = true}}, .ranking = {.models = 3}});
  std::cout << found.perceived.scans.size() << " scans show " << found.perceived.trace.visits.size()
            << " visits\n"
            << found.explained.report.consistent.value_or(0) << " maps explain them\n";

  std::size_t rank = 0;
  for (const DrawnModel& model : found.models) {
    const RankedMap& ranked = model.ranked;
    std::cout << "rank " << ++rank << ", " << (ranked.is_plausible ? "plausible" : "implausible")
              << ": " << ranked.map.paths.size() << " paths, " << ranked.map.places.size()
              << " places; the visits were to";
    for (const PlaceId place : ranked.map.visits) std::cout << ' ' << place.index();
    std::cout << '\n';
  }
  return EXIT_SUCCESS;
} catch (const Error& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
