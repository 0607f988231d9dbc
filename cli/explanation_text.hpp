#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "engine/explanation.hpp"
#include "engine/query.hpp"
#include "engine/solver_query.hpp"

namespace asterism {

/// What `asterism explain` found out.
struct ExplainReport {
  /// The preference excludes the maps asked for: the best of them is not as good as the best.
  struct Preference {
    std::vector<std::size_t>
        minimal;   ///< extents of the minimal models, in the order of preference
    Optimum best;  ///< of the maps excluded
  };

  Query query;
  std::optional<Modality> modality = {};  ///< nothing: undecided
  std::optional<Explanation> clash = {};  ///< why impossible, or certain
  std::optional<Preference> preference = {};
  std::vector<Arrival> witness = {};  ///< where it holds; of the maps asked, or of all
  std::vector<Arrival> counterexample = {};
};

/// In words, a premise and a map a line.
std::string explanation_text(const ExplainCommand& command, const Trace& trace,
                             const AxiomSet& axioms, const ExplainReport& report);

/// As a picture, where something clashes.
std::string explanation_svg(const ExplainCommand& command, const Trace& trace,
                            const AxiomSet& axioms, const ExplainReport& report);

/// As JSON, docs/formats.md: "asterism/explanation".
std::string explanation_json(const ExplainCommand& command, const Trace& trace,
                             const AxiomSet& axioms, const ExplainReport& report);

}  // namespace asterism
