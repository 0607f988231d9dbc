#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "axioms/axiom_set.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "core/map_report.hpp"
#include "core/trace.hpp"
#include "engine/map_list.hpp"
#include "engine/map_tree.hpp"
#include "engine/minimal_search.hpp"

namespace asterism {

/// The maps of a trace that a command asks: of the tree or, where the minimal models are enough, of
/// a search that spares the tree. The tree is grown even so where others than the native engine are
/// to decide, or a limit is set on the maps that it lists.
class AskedMaps {
 public:
  /// @param trace, progress  must outlive this
  AskedMaps(const MapCommand& command, const AxiomSet& axioms, const Trace& trace,
            bool only_minimal, Progress& progress);

  /// Lists them, or searches for them.
  /// @return what stopped it, if anything did
  std::optional<std::string> find();

  /// All those found, or the minimal models among them.
  MapList list() const;
  MapList minimal() const;
  bool are_searched() const { return std::holds_alternative<MinimalSearch>(found_); }
  /// How many maps explain the trace; absent where they were not listed.
  std::optional<std::uint64_t> consistent() const;
  /// Visits that some map explains; where nothing stopped it.
  std::size_t explained_visits() const;

  /// Parts with them.
  std::variant<MapTree, MinimalSearch> take() && { return std::move(found_); }

 private:
  /// @pre  they are listed, or searched for
  const MapTree& tree() const { return std::get<MapTree>(found_); }
  const MinimalSearch& search() const { return std::get<MinimalSearch>(found_); }
  std::optional<std::string> run(MinimalSearch& search);

  const MapCommand& command_;
  const Trace& trace_;
  bool only_minimal_;
  Progress& progress_;
  std::variant<MapTree, MinimalSearch> found_;
  std::size_t searched_visits_ = 0;  ///< that some map explains
};

}  // namespace asterism
