#include "tests/engine/minimal/small_trace.hpp"

#include <algorithm>
#include <stdexcept>

#include "simulation/corridor_world.hpp"
#include "simulation/grid_world.hpp"
#include "simulation/walk.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/support/axiom_files.hpp"

namespace asterism {
namespace {

World small_world(unsigned kind, RandomEngine& engine) {
  switch (kind) {
    case 0:
      return corridor_world({}, engine);
    case 1:
      return corridor_world({.corridors = 7, .ends_crossing = 0.7, .ends_blind = 0.2}, engine);
    case 2:  // dead ends
      return corridor_world({.corridors = 9, .ends_crossing = 0, .ends_blind = 0}, engine);
    case 3:
      return grid_world({.width = 3, .height = 2, .missing = 0.1, .stubs = 0.3}, engine);
    case 4:
      return grid_world({.width = 3, .height = 3, .missing = 0, .stubs = 0}, engine);
    case 5:
      return grid_world({.width = 4, .height = 4, .missing = 0.3, .stubs = 0.4}, engine);
    default:
      return grid_world({.width = 6, .height = 2, .missing = 0.15}, engine);
  }
}

}  // namespace

Trace retraced(Trace trace) {
  std::vector<Visit>& visits = trace.visits;
  visits.back().left_by = visits.back().entered_by;
  for (std::size_t k = visits.size() - 1; k-- > 0;) {
    Visit back = visits[k];
    back.entered_by = visits[k].left_by;
    back.left_by = visits[k].entered_by;
    visits.push_back(back);
  }
  visits.back().left_by.reset();
  return trace;
}

Trace small_trace(unsigned seed, std::uint64_t most_maps) {
  RandomEngine engine(seed);
  const World world = small_world(seed % 7, engine);
  const WalkOptions options{.travels = 8 + below(40, engine),
                            .policy = seed % 5 == 0 ? Policy::laps : Policy::explore,
                            .turn_around = seed % 3 == 0 ? 0.5 : 0.05,
                            .disguised = seed % 2 == 0};
  Trace trace = walk(world, options, engine).trace;
  Visit& first = trace.visits.front();
  if (chance(0.5, engine))
    for (std::size_t arm = 0; arm < first.star.size(); ++arm)
      if (first.star.has_gateway(arm)) first.entered_by = arm;
  if (seed % 11 == 0) trace = retraced(trace);

  MapTree tree({.theory = {.axioms = shipped_with()}, .max_hypotheses = most_maps});
  std::size_t visits = 0;
  while (visits < trace.visits.size() &&
         tree.extend(trace.visits[visits]) == MapTree::Growth::complete)
    ++visits;
  trace.visits.resize(visits, first);
  trace.visits.back().left_by.reset();
  trace.name = "red-" + std::to_string(seed);
  return trace;
}

Trace long_trace(unsigned seed, std::size_t side, std::size_t travels) {
  RandomEngine engine(seed);
  const World world = grid_world({.width = side, .height = side}, engine);
  return walk(world, {.travels = travels}, engine).trace;
}

AxiomSet preferring(const std::vector<std::string>& order) {
  std::string text;
  for (const std::string& extent : order) text += (text.empty() ? "" : " ") + extent;
  AxiomFiles files = shipped_files();
  files["preference.smt2"] = "(set-info :minimise (" + text + "))\n";
  return AxiomSet::parse(files);
}

MinimalSearch searched(const Trace& trace, MinimalSearch::Options options) {
  MinimalSearch search(std::move(options));
  search.extend(trace.visits);
  if (search.run() != MinimalSearch::Outcome::complete)
    throw std::logic_error("the search stopped early");
  return search;
}

}  // namespace asterism
