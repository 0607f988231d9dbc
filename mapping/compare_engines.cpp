#include "mapping/comparing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "axioms/least_closure.hpp"
#include "engine/arm_table.hpp"
#include "engine/facts.hpp"
#include "engine/minimal/minimal_models.hpp"
#include "engine/proof/certify.hpp"
#include "engine/tree/map_tree.hpp"

namespace asterism {
namespace {

constexpr double certify_s = 10;  ///< for one trace; tens of milliseconds are used

LeastClosure closure_of(const AxiomSet& axioms, const Trace& trace, const Association& map) {
  const ArmTable table(trace);
  return {axioms, map_facts(table, table.named(map))};
}

/// As the closure counts them: where axioms let a gateway have several segments, these are one.
Extents extents_in_closure(const TopologicalMap& map) {
  std::vector<std::set<PlaceArm>> joined;
  for (const auto& [one, other] : map.segments) {
    std::set<PlaceArm> gateways{one, other};
    std::erase_if(joined, [&, &one = one, &other = other](std::set<PlaceArm>& others) {
      if (!others.contains(one) && !others.contains(other)) return false;
      gateways.merge(others);
      return true;
    });
    joined.push_back(std::move(gateways));
  }
  Extents extents = extents_of(map);
  extents.segments = static_cast<std::uint32_t>(joined.size());
  return extents;
}

std::string text(const Extents& extents) {
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
      if (growth == MapTree::Growth::complete) growth = tree.extend(trace.visits, until_deadline());
      if (growth == MapTree::Growth::stopped) return stop(by_time_limit);
      if (growth == MapTree::Growth::too_many) {
        ++found_.cut_short;
        return true;
      }
    } catch (const DifferenceError& error) {
      const DifferenceError shortest = shortest_difference(trace, planar).value_or(error);
      return differs(shortest.what(), std::get<Trace>(shortest.shortest), trace.name);
    }
    if (tree.undecided() > 0) return stop(why_undecided(tree, deadline_));
    const std::vector<Association> maps = associations_of(tree);
    found_.hypotheses += maps.size();
    found_.candidates += candidates.count;
    if (has_closure_ && !planar)
      for (const Association& map : maps)
        if (!count(trace, map)) return false;
    return maps.empty() || certify_minimal(tree, planar, trace.name);
  }

  MapTree::Options options(bool planar) const {
    return verify_tree_options({axioms_, planar}, is_shipped_ ? Check::both : Check::solver);
  }

  /// Growth in one pass may meet a difference of a later visit first.
  std::optional<DifferenceError> shortest_difference(const Trace& trace, bool planar) const {
    MapTree tree(options(planar));
    try {
      for (const Visit& visit : trace.visits) tree.extend(visit, until_deadline());
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
    MapTree tree(verify_tree_options({axioms_, planar}, Check::native));
    for (const Visit& visit : trace.visits) {
      tree.for_each([&](HypothesisId, std::span<const Arrival> parent) {
        ++result.count;
        for (const auto& place : make_map(trace, parent).places) result.count += place.star.size();
      });
      result.growth = tree.extend(visit, until_deadline());
      if (result.growth != MapTree::Growth::complete) break;
    }
    return result;
  }

  Stop until_deadline() const { return {.deadline = deadline_}; }

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

  /// The map's extents, and the closed form of |path|, against the least closure.   [theory §6]
  bool count(const Trace& trace, const Association& association) {
    if (is_over(deadline_)) return stop(by_time_limit);
    const TopologicalMap map = make_map(trace, association);
    const LeastClosure closure = closure_of(axioms_, trace, association);
    const Extents told = extents_in_closure(map);
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
    switch (certify(tree.trace(), {axioms_, planar}, models, until_deadline().within(certify_s))) {
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

EnginesFinding compare_engines(const AxiomSet& axioms, std::span<const Trace> traces,
                               Deadline deadline,
                               const std::function<void(std::size_t)>& progress) {
  Engines engines(axioms, deadline);
  for (std::size_t i = 0; i < traces.size() && engines.take(traces[i]); ++i) progress(i + 1);
  return std::move(engines).found();
}

}  // namespace asterism
