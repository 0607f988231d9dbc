#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axioms/axiom_set.hpp"
#include "core/assumption.hpp"
#include "core/error.hpp"
#include "core/id.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"

namespace asterism {

/// Who decides which children a hypothesis has.                                   [DESIGN §8]
enum class Check {
  native,  ///< incremental bookkeeping: exact and fast
  solver,  ///< Z3 over the axiom files alone
  both     ///< each, compared at every candidate
};

/// Native engine and solver disagree: a fault in one of them.
class DifferenceError : public Error {
 public:
  DifferenceError(const std::string& what, Trace shortest)
      : Error(what), shortest_trace(std::move(shortest)) {}
  Trace shortest_trace;  ///< the shortest prefix of the trace that shows it
};

/// The tree of every map that explains the visits so far.            [BMK10, Fig. 5] [DESIGN §4]
///
/// Level k holds the hypotheses that explain visits 0 to k; siblings differ in where visit k was. A
/// hypothesis is kept as the one arm by which visit k was entered, under its parent, so a live one
/// costs a few bytes; HypothesisId numbers those of the last level, in the order of growth.
/// Branches that died out are forgotten.
class MapTree {
 public:
  struct Options {
    bool planar = false;
    Check check = Check::native;
    AxiomSet axioms = AxiomSet::shipped();
    /// No level of the tree may hold more; while it grows a level may, for some milliseconds.
    std::uint64_t max_hypotheses = UINT64_MAX;
    /// For each question to the solver; past it the answer is *undecided*, and the child stays.
    unsigned solver_timeout_ms = 10'000;
    /// What is known beside the trace; one that names a visit to come holds from then on.
    std::vector<Assumption> assumptions = {};
    /// Asked now and then while growing, with the hypotheses found so far on the level in work;
    /// false stops the growth.
    std::function<bool(std::size_t visit, std::uint64_t hypotheses)> go_on = {};
  };
  enum class Growth { complete, too_many, stopped };

  /// @throws std::invalid_argument if the axioms need the solver, and `check` does not name it
  explicit MapTree(Options options);
  MapTree() : MapTree(Options{}) {}
  ~MapTree();
  MapTree(MapTree&&) noexcept;
  MapTree& operator=(MapTree&&) noexcept;

  /// Grows the tree by the visits just made, in one pass. Where growth stops early, the tree is
  /// left as it was before the call.
  /// @pre    the visit before each was left: see leave()
  /// @throws std::invalid_argument if a visit lacks the arm it was entered by
  /// @throws DifferenceError       with Check::both
  Growth extend(std::span<const Visit> visits);
  Growth extend(const Visit& visit) { return extend({&visit, 1}); }

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

  /// Those minimal under the preference of the axioms, in order.                  [DESIGN §6]
  std::span<const HypothesisId> minimal() const;

  /// All of them by preference, the minimal ones first; those of one preference together, in order.
  std::vector<std::vector<HypothesisId>> by_preference() const;

  /// Writes out one hypothesis. Walks the tree: for many, use for_each.
  TopologicalMap map(HypothesisId id) const;
  /// Calls f(id, where each visit was) for every hypothesis, in order.
  void for_each(const std::function<void(HypothesisId, std::span<const Arrival>)>& f) const;
  /// The same for those of `ids`, which are in order.
  void for_each(std::span<const HypothesisId> ids,
                const std::function<void(HypothesisId, std::span<const Arrival>)>& f) const;
  /// Both, until f returns false.
  void for_each_while(const std::function<bool(HypothesisId, std::span<const Arrival>)>& f) const;
  void for_each_while(std::span<const HypothesisId> ids,
                      const std::function<bool(HypothesisId, std::span<const Arrival>)>& f) const;

 private:
  class Growing;
  std::unique_ptr<Growing> growing_;
};

}  // namespace asterism
