#include "engine/ask/route.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include "engine/ask/joint_search.hpp"
#include "engine/ask/route_map.hpp"
#include "engine/minimal/minimal_models.hpp"

namespace asterism {
namespace {

constexpr std::uint64_t maps_between_questions = 4096;  ///< some milliseconds

/// The way of the trace itself, on or back. Each map knows its travels.
Turns way_of_trace(const Trace& trace, VisitId first, VisitId last) {
  const std::size_t from = first.index();
  const std::size_t to = last.index();
  const auto turn = [&](std::size_t k) {
    const Visit& visit = trace.visits[k];
    const std::size_t size = visit.star.size();
    return (*visit.left_by + size - visit.entered_by.value_or(0)) % size;
  };
  Turns route;
  for (std::size_t k = from; k < to; ++k) route.push_back(turn(k));
  if (to < from) route.push_back(0);
  for (std::size_t k = from; k-- > to + 1;) {
    const std::size_t size = trace.visits[k].star.size();
    route.push_back((size - turn(k)) % size);
  }
  return route;
}

/// The shortest routes of single maps, counted.
class Tally {
 public:
  explicit Tally(std::size_t most) : most_(most) {}

  void add(Turns route, std::span<const Arrival> map) {
    const auto known = counted_.find(route);
    if (known == counted_.end() && counted_.size() == most_) {
      ++unlisted_[route.size()];
      return;
    }
    Counted& counted = known != counted_.end() ? known->second : counted_[std::move(route)];
    if (counted.maps++ == 0 || is_before(map, counted.witness))
      counted.witness.assign(map.begin(), map.end());
  }

  /// Writes down those of fewer travels.
  void write(std::size_t travels, RouteAnswer& answer) && {
    for (auto& [route, counted] : counted_)
      if (route.size() < travels)
        answer.shorter.push_back({route, counted.maps, std::move(counted.witness)});
    std::ranges::stable_sort(answer.shorter, [](const auto& one, const auto& other) {
      return std::tuple(other.maps, one.route.size()) < std::tuple(one.maps, other.route.size());
    });
    for (const auto& [length, maps] : unlisted_)
      if (length < travels) answer.unlisted += maps;
  }

 private:
  struct Counted {
    std::uint64_t maps = 0;
    std::vector<Arrival> witness;
  };
  std::size_t most_;
  std::map<Turns, Counted> counted_;
  std::map<std::size_t, std::uint64_t> unlisted_;  ///< maps, by travels
};

/// Looks for the routes of one question.
class Finding {
 public:
  Finding(const MapList& maps, const RouteQuery& query, const Stop& stop, const RouteLimits& limits)
      : maps_(maps),
        from_(query.from),
        to_(query.to),
        stop_(stop),
        limits_(limits),
        table_(maps.trace),
        map_(table_) {}

  std::optional<RouteAnswer> find() {
    if (!look_at_each()) return std::nullopt;
    if (answer_.of > 0 && answer_.unreachable == 0 && !look_at_all()) return std::nullopt;
    std::move(*tally_).write(answer_.certain ? answer_.certain->size() : SIZE_MAX, answer_);
    return std::move(answer_);
  }

 private:
  /// Calls f for each map, which is then `map_`.
  /// @return  false if it was told to stop
  template <class F>
  bool for_each_map(F&& f) {
    std::uint64_t maps = 0;
    bool stopped = false;
    maps_.for_each_while([&](std::span<const Arrival> arrivals) {
      map_.set(arrivals);
      f(arrivals);
      if (++maps % maps_between_questions == 0) stopped = stop_.is_due({.maps = maps});
      return !stopped;
    });
    return !stopped;
  }

  /// Counts what is shortest in each map, and asks whether the trace's own way leads there in all,
  /// as it does unless axioms of one's own give one travel two results.
  bool look_at_each() {
    const Turns own = way_of_trace(maps_.trace, from_, to_);
    bool is_certain = true;
    tally_.emplace(limits_.routes);
    const bool finished = for_each_map([&](std::span<const Arrival> arrivals) {
      ++answer_.of;
      is_certain = is_certain && map_.leads(from_, to_, own);
      auto route = map_.shortest(from_, to_);
      if (!route) {
        ++answer_.unreachable;
        return;
      }
      if (!farthest_ || route->size() > least_travels_) farthest_ = map_;
      least_travels_ = std::max(least_travels_, route->size());
      tally_->add(std::move(*route), arrivals);
    });
    if (answer_.of > 0 && is_certain) answer_.certain = own;
    return finished;
  }

  /// Looks for a certain route, one shorter than the trace's own. A few maps are searched at once,
  /// first the one in which it is farthest; what is found is put to all, and each that refutes it
  /// joins the few. What no map refutes is certain; and as what is certain in all is certain in the
  /// few, nothing shorter is.
  bool look_at_all() {
    const std::size_t most_travels = answer_.certain ? answer_.certain->size() : SIZE_MAX;
    if (least_travels_ >= most_travels) return true;
    JointSearch search(from_, to_, limits_.travels);
    search.add(*farthest_);
    std::optional<Turns> route = search.shortest(most_travels - 1);
    for (bool is_refuted = true; is_refuted && route;) {
      is_refuted = false;
      const bool finished = for_each_map([&](std::span<const Arrival>) {
        if (!route || map_.leads(from_, to_, *route)) return;
        is_refuted = true;
        search.add(map_);
        route = search.shortest(most_travels - 1);
      });
      if (!finished) return false;
    }
    answer_.is_shortest = !search.gave_up();
    if (route) answer_.certain = std::move(route);
    return true;
  }

  const MapList& maps_;
  VisitId from_;
  VisitId to_;
  const Stop& stop_;
  RouteLimits limits_;
  ArmTable table_;
  RouteMap map_;
  std::optional<RouteMap> farthest_;
  std::size_t least_travels_ = 0;  ///< that a certain route must have
  std::optional<Tally> tally_;
  RouteAnswer answer_;
};

}  // namespace

Modality RouteAnswer::modality() const {
  if (of == unreachable) return Modality::impossible;
  return certain ? Modality::certain : Modality::possible;
}

std::optional<RouteAnswer> find_route(const MapList& maps, const RouteQuery& query,
                                      const Stop& stop, const RouteLimits& limits) {
  require_visits(query.text, query.mentions, maps.trace);
  return Finding(maps, query, stop, limits).find();
}

}  // namespace asterism
