#include "engine/explained_visits.hpp"

#include <span>

namespace asterism {

std::optional<std::size_t> explained_visits(
    const Trace& trace, const MinimalSearch::Options& options,
    const std::function<bool(const MinimalSearch&)>& go_on) {
  // A map of a trace has one of each shorter trace in it, so that halving finds the end.
  std::size_t explained = 0;
  std::size_t least_not = trace.visits.size() + 1;
  while (explained + 1 < least_not) {
    const std::size_t visits = explained + (least_not - explained) / 2;
    MinimalSearch search(options);
    search.extend(std::span(trace.visits).first(visits));
    const auto has_map = [&] { return search.bounds().count > 0; };
    search.run([&](const MinimalSearch& now) { return !has_map() && (!go_on || go_on(now)); });
    if (!has_map() && !search.is_complete()) return std::nullopt;
    (has_map() ? explained : least_not) = visits;
  }
  return explained;
}

}  // namespace asterism
