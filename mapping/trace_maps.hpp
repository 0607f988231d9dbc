#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "axioms/theory.hpp"
#include "core/map_report.hpp"
#include "core/stop.hpp"
#include "core/trace.hpp"
#include "engine/ask/map_list.hpp"
#include "engine/minimal/minimal_search.hpp"
#include "engine/proof/certify.hpp"
#include "engine/tree/map_tree.hpp"
#include "io/json/maps_file.hpp"

namespace asterism {

/// The maps of a trace: all of them, listed by the tree; or the minimal models alone, which a
/// search finds without the tree. The tree is grown for these too where others than the native
/// engine are to decide, a limit is set on the maps that it lists, or the trace is too long.
/// For one thread at a time.
class TraceMaps {
 public:
  /// @param options  `check` and `max_hypotheses` say how the maps are found; time and memory are
  ///                 for the Stop to limit
  /// @throws std::invalid_argument if the axioms need the solver, and `check` does not name it
  TraceMaps(Trace trace, Theory theory, MapOptions options, bool only_minimal = false,
            unsigned jobs = 1);

  /// Lists them, or searches for them.
  /// @return what stopped it, if anything did
  std::optional<std::string> find(const Stop& stop = {});
  /// Keeps the visits before the first that no map explains, and finds the maps of these.
  /// @pre  find() was called
  void keep_explained(const Stop& stop = {});

  /// All those found, or the minimal models among them where they alone are asked for.
  MapList list() const;
  /// The minimal models of those found.
  MapList minimal() const;
  /// How many maps explain the trace; absent where they were not listed.
  std::optional<std::uint64_t> consistent() const;
  /// How many maps there are after each visit; none where they were not listed.
  std::vector<std::uint64_t> per_visit() const;
  /// Visits that some map explains.
  std::size_t explained_visits() const;
  /// What is known of the trace by now, its minimal models not certified.
  /// @param stop  says whether there is room for these
  MapReport report(const Stop& stop = {}) const;
  /// Whether the solver certifies the minimal models, in the time that `stop` leaves.
  /// @throws std::logic_error if it refutes them
  bool are_certified(const Stop& stop) const;
  /// All of them in the order of reports, for as long as this is there; nothing where there is no
  /// room to sort them.
  /// @pre  they are listed
  std::optional<MapSource> all_in_order(const Stop& stop = {}) const;

  /// The maps of this trace where planarity is asked for if it was not, and is not if it was;
  /// nothing is found of it yet. Ends where there would be too many maps for a picture.
  TraceMaps under_other_view() const;

  /// As far as it is explained, once keep_explained() was called.
  const Trace& trace() const { return trace_; }
  std::size_t steps() const { return trace_.visits.size(); }
  const Theory& theory() const { return theory_; }
  const MapOptions& options() const { return options_; }
  /// What ended the finding early, if anything did.
  const std::optional<std::string>& stopped_by() const { return stopped_by_; }
  /// Whether the minimal models alone were asked for.
  bool are_minimal_alone() const { return only_minimal_; }
  /// Whether a search finds them, without the tree.
  bool are_searched() const { return std::holds_alternative<MinimalSearch>(found_); }
  /// @pre  they are listed
  const MapTree& tree() const { return std::get<MapTree>(found_); }
  /// @pre  they are searched for
  const MinimalSearch& search() const { return std::get<MinimalSearch>(found_); }

 private:
  std::optional<std::string> run(MinimalSearch& search, const Stop& stop);
  std::vector<std::vector<Arrival>> models() const;
  void add_minimal(MapReport& report) const;

  Trace trace_;
  Theory theory_;
  MapOptions options_;
  bool only_minimal_;
  std::variant<MapTree, MinimalSearch> found_;
  std::size_t searched_visits_ = 0;  ///< that some map explains
  std::optional<std::string> stopped_by_ = {};
};

/// Watches while maps are looked for.
struct MapWatch {
  /// When to stop looking for these maps.
  std::function<Stop(const TraceMaps&)> stop = [](const TraceMaps&) { return Stop{}; };
  /// Told, once they are found, what is done with them: "certifying the minimal models".
  std::function<void(const std::string&)> found = [](const std::string&) {};
};

/// How the tree of these maps is grown.
MapTree::Options tree_options(const Theory& theory, const MapOptions& options);

/// What a search knows so far.
MapReport::Bounds bounds_of(const MinimalSearch& search);

/// Whether the solver certifies the minimal models of a trace, in the time that `stop` leaves and
/// a memory of its own.
/// @param may_be_refuted  since the solver owes answers: given more time, it may well refute
/// @throws std::logic_error if it refutes them and may not
bool is_certified(const Trace& trace, const Theory& theory,
                  const std::vector<std::vector<Arrival>>& models, const Stop& stop,
                  bool may_be_refuted = false);

/// What the solver says of minimal models. It is asked in a process of its own, since it may not
/// look at the clock for minutes: out of time or memory, they are not shown.
/// @throws std::logic_error if it refutes them and may not
bool is_shown(const std::function<Certificate()>& certify, const Stop& stop, bool may_be_refuted);

}  // namespace asterism
