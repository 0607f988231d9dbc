#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axioms/theory.hpp"
#include "core/theory_record.hpp"

namespace asterism {

/// Where the axioms of a theory are from.
struct AxiomSource {
  std::optional<std::string> folder = {};  ///< of *.smt2 files; absent: the shipped ones
  std::vector<std::string> optional = {};  ///< names of optional axioms, switched on
};

/// @throws InputError if they cannot be read
AxiomSet read_axioms(const AxiomSource& source);

/// How files tell which theory it was.
TheoryRecord record_of(const Theory& theory, const AxiomSource& source = {});

}  // namespace asterism
