#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/assumption.hpp"
#include "core/ranked_map.hpp"
#include "core/topological_map.hpp"

namespace asterism {

/// What was asked of a run, as recorded in its maps file.
struct MapOptions {
  bool planar = false;
  std::string check = "native";              ///< "native", "solver" or "both"       [DESIGN §8]
  std::string axioms = "shipped";            ///< or the directory they were read from
  std::vector<std::string> optional_axioms;  ///< names, switched on
  std::vector<std::string> preference{"path", "place"};  ///< extents to minimise, in order
  double certify_s = 10;                                 ///< seconds for certification; 0: none
  std::optional<std::uint64_t> max_hypotheses;           ///< live, on one level
  std::optional<double> time_limit_s;
  std::optional<std::uint64_t> memory_limit_bytes = {};
  std::vector<Assumption> assumptions = {};
  bool all = false;  ///< `maps` holds every hypothesis, not the minimal models alone
  /// Where the minimal models alone were asked for: "search" for them, or "listing" of all maps.
  std::optional<std::string> method = {};
};

/// Everything a run found out: the content of a maps file.                          [DESIGN §9]
struct MapReport {
  struct Minimal {
    std::size_t paths = 0;
    std::size_t places = 0;
    std::size_t count = 0;
    bool certified = false;
  };
  /// What a search for minimal models knew when a limit ended it.
  struct Bounds {
    struct Best {
      std::size_t paths = 0;
      std::size_t places = 0;
      std::size_t count = 0;  ///< maps found with as many; `maps` may hold the first 100 alone
    };
    std::uint64_t at_least = 0;  ///< no map has less of the extent that counts most
    std::optional<Best> best;    ///< absent: no map was found
  };

  std::string trace;  ///< its name
  MapOptions options;
  std::optional<std::uint64_t> consistent;              ///< absent: not listed
  std::optional<std::vector<std::uint64_t>> per_visit;  ///< hypotheses after visit k
  bool complete = true;
  std::optional<std::string> stopped_by;  ///< which limit, where not complete
  std::optional<Minimal> minimal;         ///< absent: nothing is consistent, or not all listed
  std::optional<Bounds> bounds = {};      ///< of a search that did not go to the end
  std::vector<TopologicalMap> maps;       ///< sorted by (visits, entered)
  /// Visits explained, where no map explains all of the trace.
  std::optional<std::size_t> explained_visits = {};
  std::vector<RankedMap> ranked = {};  ///< in order of rank; empty: none was laid out
};

}  // namespace asterism
