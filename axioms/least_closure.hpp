#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "axioms/grounder.hpp"

namespace asterism {

/// The least that axioms and facts force: what holds, and which terms are equal.  [DESIGN §5]
///
/// Every instance that the grounder finds is applied until nothing is new, equal terms being taken
/// for one. No solver takes part, and no map: extents counted here judge those that maps tell.
class LeastClosure {
 public:
  /// How many things of each kind there are that the facts speak of.
  struct Extents {
    std::size_t paths = 0;   ///< classes of directed paths, up to direction, that dstates are along
    std::size_t places = 0;  ///< classes of places that dstates are at
    std::size_t segments = 0;  ///< travels, up to direction
    friend bool operator==(const Extents&, const Extents&) = default;
  };

  /// Whether a least closure exists for all facts: nothing is negated in a premise, and conclusions
  /// leave no choice.
  static bool exists(const AxiomSet& axioms);

  /// @pre exists(axioms)
  LeastClosure(const AxiomSet& axioms, std::span<const Fact> facts);

  /// Whether the facts cannot be.
  bool is_contradictory() const { return is_contradictory_; }
  bool holds(const Fact& fact);
  const Extents& extents() const { return extents_; }

 private:
  using TermId = Grounder::TermId;
  using Atom = Grounder::GroundAtom;
  using Equality = std::pair<TermId, TermId>;
  using Key = std::vector<std::size_t>;  ///< relation, classes of arguments

  struct Literals {
    std::vector<Atom> atoms;
    std::vector<Equality> equalities;
  };
  struct Clause {
    Literals premise;
    Literals conclusion;
    Literals refuted;  ///< each of these is not to be
    bool is_false = false;
    bool is_applied = false;
  };

  void collect(const Formula& formula, const Grounder::Instance& instance, Clause& clause,
               Literals& literals);
  TermId root(TermId term) const;
  Key key(const Atom& atom) const;
  bool holds(const Literals& literals) const;
  void apply_all();
  void close_equalities();
  bool finds_contradiction() const;
  Extents count();
  std::vector<TermId> dstates() const;
  TermId applied(const char* function, TermId argument);

  Grounder grounder_;
  std::vector<Clause> clauses_;
  std::vector<Atom> known_;
  std::set<Key> keys_;  ///< of those, by the classes there were in this round
  std::vector<TermId> parent_;
  bool is_contradictory_ = false;
  Extents extents_;
};

}  // namespace asterism
