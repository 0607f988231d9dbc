#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "axioms/grounder.hpp"

namespace asterism {

/// The least that axioms and facts force: what holds, and which terms are equal.  [theory §5]
///
/// Every instance that the grounder finds is applied until nothing is new, equal terms being taken
/// for one. No solver takes part, and no map: extents counted here judge those that maps tell.
///
/// For one thread at a time.
/// For one thread at a time.
class LeastClosure {
 public:
  /// Whether a least closure exists for all facts: nothing is negated in a premise, and conclusions
  /// leave no choice.
  static bool exists(const AxiomSet& axioms);

  /// Closes the facts under the axioms.
  /// @pre exists(axioms)
  LeastClosure(const AxiomSet& axioms, std::span<const Fact> facts);

  /// Whether the facts cannot be.
  bool is_contradictory() const { return is_contradictory_; }
  /// Whether a fact is forced.
  bool holds(const Fact& fact);
  /// How many things there are that the facts speak of, as the shipped extents count them.
  const Extents& extents() const { return extents_; }
  /// Sizes of the extents that the axioms minimise, in order of preference.
  const std::vector<std::size_t>& minimised() const { return minimised_; }

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

  /// Which terms are equal.
  class Classes {
   public:
    void add() { parent_.push_back(static_cast<TermId>(parent_.size())); }
    TermId size() const { return static_cast<TermId>(parent_.size()); }
    TermId of(TermId term) const;
    void join(TermId a, TermId b) { parent_[of(a)] = of(b); }

   private:
    std::vector<TermId> parent_;
  };

  void collect(const Formula& formula, const Grounder::Instance& instance, Clause& clause,
               Literals& literals);
  TermId root(TermId term) const { return classes_.of(term); }
  Key key(const Atom& atom) const;
  bool holds(const Literals& literals) const;
  void apply_all();
  void close_equalities();
  bool finds_contradiction() const;

  /// What an extent's variables stand for.
  using Binding = std::vector<TermId>;
  void make_terms(const ExtentDeclaration& extent);
  std::uint32_t count(const ExtentDeclaration& extent);
  void bind(const ExtentDeclaration& extent, std::size_t part, const Binding& binding,
            const std::function<void(const Binding&)>& found);
  std::optional<Binding> matched(const Formula& premise, const Key& atom, Binding binding);
  bool holds(const Formula& formula, const Binding& binding);

  Grounder grounder_;
  std::vector<TermId> dstates_;  ///< of the facts
  std::vector<Clause> clauses_;
  std::vector<Atom> known_;
  std::set<Key> keys_;  ///< of those, by the classes there were in this round
  Classes classes_;
  bool is_contradictory_ = false;
  Extents extents_;
  std::vector<std::size_t> minimised_;
};

}  // namespace asterism
