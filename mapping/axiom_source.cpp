#include "mapping/axiom_source.hpp"

#include <algorithm>

namespace asterism {

AxiomSet read_axioms(const AxiomSource& source) {
  return source.folder ? AxiomSet::read(*source.folder, source.optional)
                       : AxiomSet::shipped(source.optional);
}

TheoryRecord record_of(const Theory& theory, const AxiomSource& source) {
  TheoryRecord record{.planar = theory.planar,
                      .axioms = source.folder.value_or("shipped"),
                      .optional_axioms = source.optional,
                      .preference = theory.axioms.preference_names(),
                      .assumptions = theory.assumptions};
  std::ranges::sort(record.optional_axioms);
  return record;
}

}  // namespace asterism
