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
#include "core/any_trace.hpp"
#include "core/error.hpp"
#include "core/id.hpp"
#include "core/stop.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"

namespace asterism {

/// Who decides which children a hypothesis has.                                   [theory §8]
enum class Check {
  native,  ///< incremental bookkeeping: exact and fast
  solver,  ///< Z3 over the axiom files alone
  both     ///< each, compared at every candidate
};

/// Native engine and solver disagree: a fault in one of them.
class DifferenceError : public Error {
 public:
  /// @param candidate  what they differ about, "visit 3 at a new place"
  /// @param kept       by the native engine, not by the solver; or the other way round
  DifferenceError(const std::string& candidate, bool kept, AnyTrace shortest);
  AnyTrace shortest;  ///< the beginning of the trace that shows it
};

/// The tree of every map that explains the visits so far.            [BMK10, Fig. 5] [theory §4]
///
/// Level k holds the hypotheses that explain visits 0 to k; siblings differ in where visit k was. A
/// hypothesis is kept as the one arm by which visit k was entered, under its parent, so a live one
/// costs a few bytes; HypothesisId numbers those of the last level, in the order of growth.
/// Branches that died out are forgotten.
/// For one thread at a time; what is const may run side by side.
class MapTree {
 public:
  struct Options {
    Theory theory = {};
    Check check = Check::native;
    /// No level of the tree may hold more; while it grows a level may, for some milliseconds.
    std::uint64_t max_hypotheses = UINT64_MAX;
  };
  enum class Growth { complete, too_many, stopped };

  /// @throws std::invalid_argument if the axioms or their extents need the solver, and `check` does
  /// not name it
  explicit MapTree(Options options);
  explicit MapTree(Theory theory) : MapTree(Options{.theory = std::move(theory)}) {}
  MapTree() : MapTree(Options{}) {}
  ~MapTree();
  MapTree(MapTree&&) noexcept;
  MapTree& operator=(MapTree&&) noexcept;

  /// Grows the tree by the visits just made, in one pass. Where growth stops early, the tree is
  /// left as it was before the call. A question that the solver does not answer in time is
  /// *undecided*, and the child stays.
  /// @param stop  told of the visit in work and the hypotheses found so far on its level
  /// @pre    the visit before each was left: see leave()
  /// @throws std::invalid_argument if a visit lacks the arm it was entered by
  /// @throws DifferenceError       with Check::both
  Growth extend(std::span<const Visit> visits, const Stop& stop = {});
  Growth extend(const Visit& visit, const Stop& stop = {}) { return extend({&visit, 1}, stop); }

  /// The robot leaves the place of the last visit by an arm of that visit's own star.
  /// @throws std::invalid_argument if there was no visit, or the arm has no gateway
  void leave(std::size_t left_by);

  /// Hypotheses that explain all visits.
  std::uint64_t size() const;
  /// How many there were after each visit.
  std::span<const std::uint64_t> per_visit() const;
  /// Answers the solver owed: each kept its child.
  std::uint64_t undecided() const;
  /// Bytes held for the hypotheses.
  std::size_t memory_bytes() const;
  const Trace& trace() const;
  const Options& options() const;

  /// Those minimal under the preference of the axioms, in order.                  [theory §6]
  std::span<const HypothesisId> minimal() const;

  /// All of them by preference, the minimal ones first; those of one preference together, in order.
  std::vector<std::vector<HypothesisId>> by_preference() const;

  /// Writes out one hypothesis. Walks the tree: for many, use for_each.
  TopologicalMap map(HypothesisId id) const;
  /// Calls f(id, where each visit was) for every hypothesis, in order.
  void for_each(const std::function<void(HypothesisId, std::span<const Arrival>)>& f) const;
  /// Calls f(id, where each visit was) for those of `ids`, which are in order.
  void for_each(std::span<const HypothesisId> ids,
                const std::function<void(HypothesisId, std::span<const Arrival>)>& f) const;
  /// Calls f for hypotheses in order, until it returns false.
  void for_each_while(const std::function<bool(HypothesisId, std::span<const Arrival>)>& f) const;
  /// Calls f for those of `ids`, which are in order, until it returns false.
  void for_each_while(std::span<const HypothesisId> ids,
                      const std::function<bool(HypothesisId, std::span<const Arrival>)>& f) const;

 private:
  class Growing;
  std::unique_ptr<Growing> growing_;
};

}  // namespace asterism
