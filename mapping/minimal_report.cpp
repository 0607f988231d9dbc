#include "mapping/minimal_report.hpp"

#include "engine/minimal/longest_explained_prefix.hpp"
#include "mapping/trace_maps.hpp"

namespace asterism {

MapReport find_minimal(MinimalSearch& search, const Trace& trace, const MapOptions& options,
                       const Stop& stop, Checkpointing* checkpoint) {
  MapReport report{{.trace = trace.name, .options = options}};
  const auto outcome = checkpoint ? checkpoint->run(search, stop) : search.run(stop);
  const MapReport::Bounds known = bounds_of(search);
  if (outcome == MinimalSearch::Outcome::stopped) {
    report.stopped_by = stop.reason;
    report.complete = false;
    report.bounds = known;
  } else if (known.best) {
    report.minimal = {known.best->paths, known.best->places, known.best->count, false};
  } else {
    report.consistent = 0;
    report.explained_visits = longest_explained_prefix(trace, search.options(), stop);
  }
  return report;
}

}  // namespace asterism
