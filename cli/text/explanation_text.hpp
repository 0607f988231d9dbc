#pragma once

#include <string>

#include "core/trace.hpp"
#include "io/json/explanation_json.hpp"

namespace asterism {

inline constexpr double default_explain_s = 60;  ///< for an explanation

/// The visits, axioms and planarity of a clash, in words.
/// @param candidate  whose places are named, if the clash is of one
std::string premises_text(const Trace& trace, const AxiomSet& axioms, const Clash& clash,
                          const PartialMap& candidate = {});

/// In words, a premise and a map a line.
std::string explanation_text(const Trace& trace, const AxiomSet& axioms,
                             const ExplainReport& report);

/// As a picture, where something clashes.
std::string explanation_svg(const Trace& trace, const AxiomSet& axioms,
                            const ExplainReport& report);

}  // namespace asterism
