#include "engine/minimal/longest_explained_prefix.hpp"

#include <span>

namespace asterism {

std::optional<std::size_t> longest_explained_prefix(const Trace& trace,
                                                    const MinimalSearch::Options& options,
                                                    const Stop& stop) {
  // A map of a trace has one of each shorter trace in it, so that halving finds the end.
  std::size_t explained = 0;
  std::size_t least_not = trace.visits.size() + 1;
  while (explained + 1 < least_not) {
    const std::size_t visits = explained + (least_not - explained) / 2;
    MinimalSearch search(options);
    search.extend(std::span(trace.visits).first(visits));
    const auto has_map = [&] { return search.bounds().count > 0; };
    Stop until_map = stop;
    until_map.watch = [&](const Standing& standing) -> std::optional<std::string> {
      if (has_map()) return "map found";
      return stop.watch ? stop.watch(standing) : std::nullopt;
    };
    search.run(until_map);
    if (!has_map() && !search.is_complete()) {
      stop.reason = until_map.reason;
      return std::nullopt;
    }
    (has_map() ? explained : least_not) = visits;
  }
  return explained;
}

}  // namespace asterism
