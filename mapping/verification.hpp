#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/stop.hpp"
#include "core/trace.hpp"
#include "io/json/verification_json.hpp"
#include "mapping/axiom_source.hpp"

namespace asterism {

/// Watches a verification.
struct VerifyWatch {
  /// Told of a stage that is over: "axioms", "engines", "change".
  std::function<void(const std::string&)> stage_is_over = [](const std::string&) {};
  /// Told how many traces of how many are compared.
  std::function<void(std::size_t, std::size_t)> traces_done = [](std::size_t, std::size_t) {};
};

/// Checks axioms, and who decides by them: of each axiom, whether the others imply it, and of the
/// shipped ones also of each optional one that is off; whether all together allow a travel; on
/// traces, that native engine and solver keep the same maps, and that maps count what the axioms
/// force. Of axioms from a folder, what changes against the shipped ones.
VerifyReport verify(const AxiomSource& source, std::vector<Trace> traces,
                    Deadline deadline = Deadline::max(), const VerifyWatch& watch = {});

}  // namespace asterism
