#include "cli/verify_worlds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "axioms/least_closure.hpp"
#include "engine/arm_table.hpp"
#include "engine/certify.hpp"
#include "engine/facts.hpp"
#include "engine/map_tree.hpp"
#include "engine/minimal_models.hpp"
#include "simulation/corridor_world.hpp"
#include "simulation/grid_world.hpp"
#include "simulation/ring_building.hpp"
#include "simulation/walk.hpp"

namespace asterism {
namespace {

/// Of a trace; without some axioms there are more.
constexpr std::uint64_t max_hypotheses = 1000;
constexpr double certify_s = 10;  ///< for one trace; tens of milliseconds are used

World random_world(std::uint64_t seed, RandomEngine& engine) {
  switch (seed % 4) {
    case 0:
      return corridor_world({.corridors = 8, .ends_crossing = 0.6, .ends_blind = 0.3}, engine);
    case 1:
      return grid_world({.width = 3, .height = 2, .missing = 0.1, .stubs = 0.3}, engine);
    case 2:
      return grid_world({.width = 3, .height = 3}, engine);
    default:
      return corridor_world({}, engine);
  }
}

LeastClosure closure_of(const AxiomSet& axioms, const Trace& trace, const Association& map) {
  const ArmTable table(trace);
  const std::vector<ArmIndex> named = table.named(map);
  std::vector<Fact> facts = general_facts();
  for (std::size_t k = 0; k < named.size(); ++k)
    std::ranges::copy(visit_facts(table, std::span(named).first(k + 1)), std::back_inserter(facts));
  return {axioms, facts};
}

std::string text(const LeastClosure::Extents& extents) {
  return fmt::format("{} paths, {} places and {} segments", extents.paths, extents.places,
                     extents.segments);
}

std::string places_text(const Association& map) {
  std::string result;
  for (const Arrival& arrival : map) result += fmt::format(" {}", arrival.place.index());
  return result;
}

/// Everything that is compared on traces, up to the first difference.
class Engines {
 public:
  Engines(const AxiomSet& axioms, Deadline deadline)
      : axioms_(axioms),
        deadline_(deadline),
        is_shipped_(axioms.is_shipped()),
        has_closure_(LeastClosure::exists(axioms)) {
    found_.is_native = is_shipped_;
    if (!has_closure_)
      found_.remark = "conclusions leave a choice, so that there is no least closure to count in";
  }

  /// @return  whether to go on
  bool take(const Trace& trace) {
    ++found_.traces;
    for (const bool planar : {false, true}) {
      if (!compare(trace, planar)) return false;
    }
    return true;
  }

  EnginesFinding found() && { return std::move(found_); }

 private:
  bool compare(const Trace& trace, bool planar) {
    MapTree tree(options(planar));
    Candidates candidates;
    try {
      // The native engine alone soon knows where there are too many maps.
      if (is_shipped_) candidates = candidates_of(trace, planar);
      MapTree::Growth growth = candidates.growth;
      if (growth == MapTree::Growth::complete) growth = tree.extend(trace.visits);
      if (growth == MapTree::Growth::stopped) return stop(by_time_limit);
      if (growth == MapTree::Growth::too_many) {
        ++found_.cut_short;
        return true;
      }
    } catch (const DifferenceError& error) {
      const DifferenceError shortest = shortest_difference(trace, planar).value_or(error);
      return differs(shortest.what(), shortest.shortest_trace, trace.name);
    }
    if (tree.undecided() > 0)
      return stop(fmt::format("{} candidates undecided by the solver", tree.undecided()));
    const std::vector<Association> maps = associations_of(tree);
    found_.hypotheses += maps.size();
    found_.candidates += candidates.count;
    if (has_closure_ && !planar)
      for (const Association& map : maps)
        if (!count(trace, map)) return false;
    return maps.empty() || certify_minimal(tree, planar, trace.name);
  }

  MapTree::Options options(bool planar) const {
    return verify_tree_options(axioms_, is_shipped_ ? Check::both : Check::solver, planar,
                               deadline_);
  }

  /// Growth in one pass may meet a difference of a later visit first.
  std::optional<DifferenceError> shortest_difference(const Trace& trace, bool planar) const {
    MapTree tree(options(planar));
    try {
      for (const Visit& visit : trace.visits) tree.extend(visit);
    } catch (const DifferenceError& error) {
      return error;
    }
    return std::nullopt;
  }

  struct Candidates {
    MapTree::Growth growth = MapTree::Growth::complete;
    std::uint64_t count = 0;
  };
  /// Children that the solver has to decide: every arm of every place, and a new place.
  Candidates candidates_of(const Trace& trace, bool planar) const {
    Candidates result;
    MapTree tree(verify_tree_options(axioms_, Check::native, planar, deadline_));
    for (const Visit& visit : trace.visits) {
      tree.for_each([&](HypothesisId, std::span<const Arrival> parent) {
        ++result.count;
        for (const auto& place : make_map(trace, parent).places) result.count += place.star.size();
      });
      result.growth = tree.extend(visit);
      if (result.growth != MapTree::Growth::complete) break;
    }
    return result;
  }

  bool stop(const std::string& why) {
    found_.stopped_by = why;
    return false;
  }

  bool differs(const std::string& how, const Trace& trace, const std::string& name) {
    found_.difference = how;
    found_.shortest = trace;
    found_.shortest->name = name;  // a tree does not keep it
    return false;
  }

  /// The map's extents, and the closed form of |path|, against the least closure.   [DESIGN §6]
  bool count(const Trace& trace, const Association& association) {
    if (is_over(deadline_)) return stop(by_time_limit);
    const TopologicalMap map = make_map(trace, association);
    const LeastClosure closure = closure_of(axioms_, trace, association);
    const LeastClosure::Extents told{map.paths.size(), map.places.size(), map.segments.size()};
    const std::string where = "visits at places" + places_text(association);
    if (closure.is_contradictory())
      return differs(where + ": a map was kept that the axioms contradict", trace, trace.name);
    if (closure.extents() != told)
      return differs(fmt::format("{}: the map has {}, the axioms force {}", where, text(told),
                                 text(closure.extents())),
                     trace, trace.name);
    std::size_t arms = 0;
    for (const auto& place : map.places) arms += place.star.size();
    if (arms / 2 != map.paths.size() + map.segments.size()) {
      const std::string how = fmt::format("{}: {} arms and {} segments, but {} paths", where, arms,
                                          map.segments.size(), map.paths.size());
      if (is_shipped_) return differs(how, trace, trace.name);
      if (!found_.remark)
        found_.remark = "|paths| = arms / 2 - segments does not always hold: " + how;
    }
    ++found_.maps_counted;
    return true;
  }

  bool certify_minimal(const MapTree& tree, bool planar, const std::string& name) {
    const std::vector<Association> models = minimal_models(tree);
    const double left_s = seconds_until(deadline_);
    switch (certify(tree.trace(), axioms_, planar, models, std::clamp(left_s, 0.0, certify_s))) {
      case Certificate::shown:
        ++found_.certified;
        return true;
      case Certificate::not_shown:
        ++found_.not_certified;
        return true;
      case Certificate::refuted:
        break;
    }
    return differs("the solver refutes the minimal models", tree.trace(), name);
  }

  const AxiomSet& axioms_;
  Deadline deadline_;
  bool is_shipped_;
  bool has_closure_;
  EnginesFinding found_;
};

}  // namespace

MapTree::Options verify_tree_options(const AxiomSet& axioms, Check check, bool planar,
                                     Deadline deadline) {
  return {.planar = planar,
          .check = check,
          .axioms = axioms,
          .max_hypotheses = max_hypotheses,
          .go_on = [=](auto, auto) { return !is_over(deadline); }};
}

std::vector<Association> associations_of(const MapTree& tree) {
  std::vector<Association> result;
  tree.for_each([&](HypothesisId, std::span<const Arrival> arrivals) {
    result.emplace_back(arrivals.begin(), arrivals.end());
  });
  std::ranges::sort(result);
  return result;
}

Trace random_trace(std::uint64_t seed) {
  RandomEngine engine(seed);
  const World world = random_world(seed, engine);
  const Policy policy = seed % 7 == 0 ? Policy::laps : Policy::explore;
  const std::size_t travels = 4 + seed % 5;
  Trace trace =
      walk(world, {.travels = travels, .policy = policy, .turn_around = 0.3}, engine).trace;
  trace.name = fmt::format("random-world-{}", seed);
  return trace;
}

Trace ring_trace() {
  RandomEngine engine(0);  // of furniture, which no star shows
  const World ring = ring_building(engine).world;
  Trace trace = walk_along(ring, ring_route(ring), false, engine).trace;
  trace.name = "aces-like";
  return trace;
}

EnginesFinding compare_engines(const AxiomSet& axioms, std::span<const Trace> traces,
                               Deadline deadline,
                               const std::function<void(std::size_t)>& progress) {
  Engines engines(axioms, deadline);
  for (std::size_t i = 0; i < traces.size() && engines.take(traces[i]); ++i) progress(i + 1);
  return std::move(engines).found();
}

}  // namespace asterism
