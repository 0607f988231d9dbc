#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "axioms/axiom_set.hpp"
#include "core/map_report.hpp"
#include "engine/ask/query.hpp"
#include "engine/proof/explain.hpp"
#include "engine/proof/optimum.hpp"

namespace asterism {

/// Why a query is certain, possible or impossible: the content of a file of an explanation.
///                                                                           [docs/formats.md]
struct ExplainReport {
  /// The preference excludes the maps asked for: the best of them is not as good as the best.
  struct Preference {
    std::vector<std::size_t>
        minimal;   ///< extents of the minimal models, in the order of preference
    Optimum best;  ///< of the maps excluded

    /// The first extent in which they differ, by its position in the preference.
    std::size_t deciding() const;
  };

  std::string trace = {};  ///< its name
  MapOptions options = {};
  bool only_minimal = false;  ///< the minimal models were asked, not all maps
  Query query;
  std::optional<Modality> modality = {};  ///< nothing: undecided
  std::optional<Clash> clash = {};        ///< why impossible, or certain
  std::string claim = {};                 ///< that clashes: the query, or its contrary
  std::optional<Preference> preference = {};
  std::vector<Arrival> witness = {};  ///< where it holds; of the maps asked, or of all
  std::vector<Arrival> counterexample = {};
};

/// The file's content, a premise that clashes a line.
/// @param axioms  those of the maps asked
std::string explanation_json(const ExplainReport& report, const AxiomSet& axioms);

}  // namespace asterism
