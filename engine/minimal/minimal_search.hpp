#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "axioms/theory.hpp"
#include "core/extents.hpp"
#include "core/search_state.hpp"
#include "core/stop.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"

namespace asterism {

/// The minimal models of a trace, all of them and proved, without the tree of its maps.
///                                                                          [theory §6] [L99]
/// Depth first over foldings of the trace (engine/folding.hpp): the place with the fewest settled
/// places it may be one with is decided next, for each of these and for being another. What leads
/// to more of the extents than the best found, or than the level in work allows, is left out; the
/// level is raised until there is a map. docs/minimal.md tells how, and what was tried.
///
/// The models are the same for any number of threads.
/// It starts threads of its own, and is used by one thread at a time.
class MinimalSearch {
 public:
  struct Options {
    Theory theory = {};
    unsigned jobs = 1;  ///< threads
  };
  /// What is known so far.
  struct Bounds {
    /// No map has less of the extent that counts most.
    std::uint64_t at_least = 0;
    std::optional<Extents> best;  ///< of the best map found
    std::uint64_t count = 0;      ///< maps found with these extents
  };
  enum class Outcome { complete, stopped };
  /// Of a trace: each arm has a row of bits for every other.
  static constexpr std::size_t max_visits = 4'000;

  /// @throws std::invalid_argument if the axioms are not the shipped ones
  explicit MinimalSearch(Options options);
  explicit MinimalSearch(Theory theory) : MinimalSearch(Options{.theory = std::move(theory)}) {}
  MinimalSearch() : MinimalSearch(Options{}) {}
  ~MinimalSearch();
  MinimalSearch(MinimalSearch&&) noexcept;
  MinimalSearch& operator=(MinimalSearch&&) noexcept;

  /// Further visits. What was proved of the trace so far bounds what is searched next.
  /// @pre    the visit before each was left
  /// @throws std::invalid_argument, Error  as ArmTable::append
  void extend(std::span<const Visit> visits);
  void extend(const Visit& visit) { extend({&visit, 1}); }
  /// The robot leaves the place of the last visit.
  void leave(std::size_t left_by);

  /// Searches on, until all is known or it is to stop.
  /// @param stop  asked some fifty times a second, when bounds(), models() and state() may be
  /// called
  /// @throws std::invalid_argument if it was resumed from a state that cannot be one
  Outcome run(const Stop& stop = {});

  Bounds bounds() const;
  /// Whether all minimal models are known; if there are none, no map explains the trace.
  bool is_complete() const;
  /// Data associations of the best maps found, in the order of reports: the minimal models, if the
  /// search is complete.
  std::vector<std::vector<Arrival>> models() const;
  /// Calls f for each of these, or for the first so many, until it returns false; for there may be
  /// millions.
  void for_each_while(const std::function<bool(std::span<const Arrival>)>& f,
                      std::size_t most = SIZE_MAX) const;
  /// Bytes held: for the maps found, and for each thread what it knows of the trace.
  std::size_t memory_bytes() const;

  /// Branchings so far, by all threads; differs from run to run if there are several.
  std::uint64_t branchings() const;
  const Trace& trace() const;
  const Options& options() const;

  /// @pre  not while it runs, but for `stop`
  SearchState state() const;
  /// Goes on from a state of a search with the same trace and options.
  /// @throws std::invalid_argument if it cannot be one of these
  void resume(const SearchState& state);

 private:
  class Searching;
  std::unique_ptr<Searching> searching_;
};

}  // namespace asterism
