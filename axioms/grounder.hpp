#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "axioms/axiom_set.hpp"

namespace asterism {

/// A ground atom as given from outside: a relation of constants.
struct Fact {
  std::string relation;
  std::vector<std::string> arguments;
  friend auto operator<=>(const Fact&, const Fact&) = default;
};

/// Finds the ground instances of the axioms that matter for a growing set of facts.     [DESIGN §8]
///
/// Semi-naive joining: an instance is found when the last of its premises arrives, as a fact or as
/// the conclusion of another instance. Leaving out instances whose premises nothing derives is
/// exact, since their premises may be taken to be false. Equalities are not joined over: those
/// between constants that are named apart are decided here, all others are left to the solver, and
/// a variable of another sort matches any term, with an equality added to the premise. So too much
/// may be derived, which only costs time, and never too little.
class Grounder {
 public:
  using TermId = std::uint32_t;
  using AtomId = std::uint32_t;

  /// A ground term: a constant, or a function of a term.
  struct GroundTerm {
    std::string symbol;
    std::vector<TermId> argument;
    std::string sort;
  };
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
  /// Forgets the atoms derived since the matching push().
  void push() { marks_.push_back(known_.size()); }
  void pop();

  const AxiomSet& axioms() const { return axioms_; }
  const std::vector<std::string>& relations() const { return relations_; }
  const GroundTerm& term(TermId id) const { return terms_[id]; }
  /// Number of terms made so far; numbers are never given up.
  std::size_t terms() const { return terms_.size(); }
  TermId constant(const std::string& name, const std::string& sort);
  GroundAtom atom(const Fact& fact);
  /// The ground term that an axiom's term becomes.
  TermId bind(const Term& term, std::span<const TermId> binding);
  std::uint32_t relation(const std::string& name) const { return relation_numbers_.at(name); }
  /// Constants that are named apart are equal only if they are the same.
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
