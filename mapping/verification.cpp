#include "mapping/verification.hpp"

#include <algorithm>
#include <utility>

#include "axioms/independence.hpp"
#include "mapping/comparing.hpp"
#include "mapping/random_traces.hpp"

namespace asterism {
namespace {

/// Every axiom of the set; of the shipped set also the optional ones that are off, each put to it
/// alone.
std::vector<AxiomFinding> findings_of(const AxiomSource& source, const AxiomSet& axioms,
                                      Deadline deadline) {
  std::vector<AxiomFinding> result;
  for (const Axiom& axiom : axioms.axioms())
    result.push_back({axiom, false, independence(axiom, axioms, deadline)});
  if (source.folder) return result;
  for (const std::string& name : AxiomSet::optional_names()) {
    if (axioms.contains(name)) continue;
    std::vector<std::string> names = source.optional;
    names.push_back(name);
    const AxiomSet with = AxiomSet::shipped(names);
    const auto axiom = std::ranges::find(with.axioms(), name, &Axiom::name);
    result.push_back({*axiom, true, independence(*axiom, with, deadline)});
  }
  return result;
}

}  // namespace

VerifyReport verify(const AxiomSource& source, std::vector<Trace> traces, Deadline deadline,
                    const VerifyWatch& watch) {
  const AxiomSet axioms = read_axioms(source);
  const TheoryRecord record = record_of({.axioms = axioms}, source);
  const auto done = [&](std::size_t so_far) { watch.traces_done(so_far, traces.size()); };
  VerifyReport report;
  report.axioms = record.axioms;
  report.optional_axioms = record.optional_axioms;
  report.findings = findings_of(source, axioms, deadline);
  report.together = model_with_travel(axioms, deadline);
  watch.stage_is_over("axioms");
  report.engines = compare_engines(axioms, traces, deadline, done);
  watch.stage_is_over("engines");
  if (!source.folder) return report;
  traces.push_back(ring_trace());
  report.change = compare_with_shipped(axioms, traces, deadline, done);
  watch.stage_is_over("change");
  return report;
}

}  // namespace asterism
