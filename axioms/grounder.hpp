#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "axioms/axiom_set.hpp"
#include "axioms/fact.hpp"

namespace asterism {

/// Finds the ground instances of the axioms that matter for a growing set of facts.     [theory §8]
///
/// Semi-naive joining: an instance is found when the last of its premises arrives, as a fact or as
/// the conclusion of another instance. Leaving out instances whose premises nothing derives is
/// exact, since their premises may be taken to be false. Equalities are not joined over: those
/// between constants that are named apart are decided here, all others are left to the solver, and
/// a variable of another sort matches any term, with an equality added to the premise. So too much
/// may be derived, which only costs time, and never too little.
///
/// For one thread at a time.
class Grounder {
 public:
  /// Number of a ground term, counted from 0 as they are made.
  using TermId = std::uint32_t;
  /// Number of an atom that is known, counted from 0 as they are learnt.
  using AtomId = std::uint32_t;

  /// A ground term: a constant, or a function of a term.
  struct GroundTerm {
    std::string symbol;
    std::vector<TermId> argument;
    std::string sort;
  };
  /// A relation of ground terms.
  struct GroundAtom {
    std::uint32_t relation;  ///< index into relations()
    std::vector<TermId> arguments;
    bool operator==(const GroundAtom&) const = default;
  };
  /// An axiom with its variables bound. Variables of a sort without unique names may stand in more
  /// than one premise; the terms they met are then said to be equal.
  struct Instance {
    const Axiom* axiom;
    std::vector<TermId> binding;
    std::vector<std::pair<TermId, TermId>> equal;  ///< further premises
    /// Arguments that met a term with variables in it: become equalities when all are bound.
    std::vector<std::pair<const Term*, TermId>> patterns;
  };

  explicit Grounder(const AxiomSet& axioms);
  Grounder(const Grounder&) = delete;

  /// Adds a fact; calls `found` with every instance that it completes.
  /// @throws InputError if an axiom derives terms of terms without end
  void add(const Fact& fact, const std::function<void(Instance)>& found);
  /// Marks what is known.
  void push() { marks_.push_back(known_.size()); }
  /// Forgets the atoms derived since the last mark, and that mark.
  void pop();

  /// The axioms that are grounded; instances point into them.
  const AxiomSet& axioms() const { return axioms_; }
  /// Names of the relations, in the order of their numbers.
  const std::vector<std::string>& relations() const { return relations_; }
  /// @pre  there is a term of that number
  const GroundTerm& term(TermId id) const { return terms_[id]; }
  /// Number of terms made so far; numbers are never given up.
  std::size_t terms() const { return terms_.size(); }
  /// "place(d0_1)" as SMT-LIB has it: "(place d0_1)".
  std::string text(TermId id) const;
  /// The term that a constant is.
  TermId constant(const std::string& name, const std::string& sort);
  /// The atom that a fact is.
  /// @throws std::invalid_argument if its relation has another number of arguments
  GroundAtom atom(const Fact& fact);
  /// The ground term that an axiom's term becomes.
  TermId bind(const Term& term, std::span<const TermId> binding);
  /// The number of a relation.
  std::uint32_t relation(const std::string& name) const { return relation_numbers_.at(name); }
  /// Whether two terms are constants that are named apart, and so cannot be equal.
  bool named_apart(TermId a, TermId b) const;

 private:
  struct Premise {
    std::uint32_t relation;
    const Formula* atom;
  };
  struct Rule {
    const Axiom* axiom;
    std::vector<Premise> premises;           ///< positive relations
    std::vector<const Formula*> heads;       ///< relations that an instance may make true
    std::vector<const Formula*> equalities;  ///< premises to decide here where they can be
  };
  struct Trigger {
    const Rule* rule;
    std::size_t premise;
  };
  static constexpr TermId unbound = UINT32_MAX;

  TermId intern(const std::string& symbol, std::vector<TermId> argument, const std::string& sort);
  std::size_t depth(TermId id) const;
  bool learn(GroundAtom atom);
  void join(const Rule& rule, std::size_t fixed, std::size_t premise, AtomId newest,
            Instance& instance, const std::function<void(Instance)>& found);
  bool match(const Premise& premise, const GroundAtom& atom, Instance& instance) const;
  void complete(const Rule& rule, Instance& instance, const std::function<void(Instance)>& found);

  AxiomSet axioms_;
  std::vector<Rule> rules_;
  std::vector<std::string> relations_;
  std::map<std::string, std::uint32_t> relation_numbers_;
  std::map<std::string, bool> unique_names_;    ///< of a sort
  std::vector<std::vector<Trigger>> triggers_;  ///< by relation

  std::vector<GroundTerm> terms_;
  std::map<std::pair<std::string, std::vector<TermId>>, TermId> term_numbers_;
  struct BoundTermHash {
    std::size_t operator()(const std::pair<const Term*, TermId>& bound) const;
  };
  /// What a term of an axiom becomes, by its argument: saves comparing names.
  std::unordered_map<std::pair<const Term*, TermId>, TermId, BoundTermHash> bound_terms_;

  struct AtomHash {
    std::size_t operator()(const GroundAtom& atom) const;
  };
  std::vector<GroundAtom> known_;
  std::unordered_map<GroundAtom, AtomId, AtomHash> known_numbers_;
  std::vector<std::vector<AtomId>> by_relation_;
  std::unordered_map<std::uint64_t, std::vector<AtomId>> by_argument_;
  std::vector<std::size_t> marks_;
  std::size_t processed_ = 0;
};

}  // namespace asterism
