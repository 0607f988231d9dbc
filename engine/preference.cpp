#include "engine/preference.hpp"

#include "axioms/least_closure.hpp"
#include "engine/facts.hpp"

namespace asterism {

std::vector<std::size_t> extents_by_preference(const ArmTable& table, std::span<const ArmId> named,
                                               const AxiomSet& axioms) {
  if (axioms.minimises_own()) return LeastClosure(axioms, map_facts(table, named)).minimised();
  return extents_by_preference(make_map(table.trace(), table.arrivals(named)), axioms);
}

std::vector<std::size_t> extents_by_preference(const Trace& trace, std::span<const Arrival> map,
                                               const AxiomSet& axioms) {
  if (!axioms.minimises_own()) return extents_by_preference(make_map(trace, map), axioms);
  const ArmTable table(trace);
  return extents_by_preference(table, table.named(map), axioms);
}

}  // namespace asterism
