#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/experience.hpp"
#include "core/ranked_map.hpp"
#include "core/ssh_map.hpp"
#include "core/theory_record.hpp"
#include "core/topological_map.hpp"

namespace asterism {

/// What was asked of a run, as recorded in its maps file.
struct MapOptions {
  TheoryRecord theory = {};
  std::string check = "native";  ///< "native", "solver" or "both"     [theory §8]
  double certify_s = 10;         ///< seconds for certification; 0: none
  std::optional<std::uint64_t> max_hypotheses = {};  ///< live, on one level
  std::optional<double> time_limit_s = {};
  std::optional<std::uint64_t> memory_limit_bytes = {};
  bool all = false;  ///< `maps` holds every hypothesis, not the minimal models alone
  /// Where the minimal models alone were asked for: "search" for them, or "listing" of all maps.
  std::optional<std::string> method = {};
};

/// What a run found out about the maps of a trace, of visits or of the basic SSH.     [theory §9]
struct Findings {
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

  std::string trace = {};  ///< its name
  MapOptions options = {};
  std::optional<std::uint64_t> consistent = {};              ///< absent: not listed
  std::optional<std::vector<std::uint64_t>> per_visit = {};  ///< maps after visit k, or view k
  bool complete = true;
  std::optional<std::string> stopped_by = {};  ///< which limit, where not complete
  std::optional<Minimal> minimal = {};         ///< absent: nothing is consistent, or not all listed
  /// How many each minimal model has of what the axioms declare and minimise; in no file.
  std::vector<std::pair<std::string, std::size_t>> own_extents = {};
  std::optional<Bounds> bounds = {};  ///< of a search that did not go to the end
  /// Visits explained, where no map explains all of the trace.
  std::optional<std::size_t> explained_visits = {};
};

/// Everything a run found out: the content of a maps file.
struct MapReport : Findings {
  std::vector<TopologicalMap> maps = {};  ///< sorted by (visits, entered)
  std::vector<RankedMap> ranked = {};     ///< in order of rank; empty: none was laid out
};

/// Everything a run on an experience of the basic SSH found out: the content of its maps file.
struct SshReport : Findings {
  Experience experience;
  std::vector<SshMap> maps = {};  ///< sorted by dstates
};

}  // namespace asterism
