#include "axioms/least_closure.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace asterism {
namespace {

bool is_atom(const Formula& formula) {
  return formula.kind == Formula::Kind::relation || formula.kind == Formula::Kind::equality;
}

bool leaves_no_choice(const Formula& formula) {
  switch (formula.kind) {
    case Formula::Kind::disjunction:
      return false;
    case Formula::Kind::negation:
      return is_atom(formula.parts.front());
    case Formula::Kind::conjunction:
      return std::all_of(formula.parts.begin(), formula.parts.end(), leaves_no_choice);
    default:
      return true;
  }
}

Term application(const std::string& function) {
  return {.kind = Term::Kind::application,
          .symbol = function,
          .argument = {{.kind = Term::Kind::variable, .symbol = "", .argument = {}}}};
}

}  // namespace

bool LeastClosure::exists(const AxiomSet& axioms) {
  return std::all_of(axioms.axioms().begin(), axioms.axioms().end(), [](const Axiom& axiom) {
    return std::all_of(axiom.premise.begin(), axiom.premise.end(), is_atom) &&
           leaves_no_choice(axiom.conclusion);
  });
}

LeastClosure::LeastClosure(const AxiomSet& axioms, std::span<const Fact> facts)
    : grounder_(axioms) {
  for (const Fact& fact : facts) {
    known_.push_back(grounder_.atom(fact));
    grounder_.add(fact, [&](const Grounder::Instance& instance) {
      Clause& clause = clauses_.emplace_back();
      clause.premise.equalities = instance.equal;
      for (const Formula& part : instance.axiom->premise)
        collect(part, instance, clause, clause.premise);
      collect(instance.axiom->conclusion, instance, clause, clause.conclusion);
    });
  }
  // Each dstate has its place and its directed path, also where no instance names them.
  for (const TermId dstate : dstates())
    for (const char* const function : {"place", "along"}) applied(function, dstate);
  for (std::size_t i = 0; i < grounder_.terms(); ++i) parent_.push_back(static_cast<TermId>(i));
  apply_all();
  is_contradictory_ = finds_contradiction();
  extents_ = count();
}

void LeastClosure::collect(const Formula& formula, const Grounder::Instance& instance,
                           Clause& clause, Literals& literals) {
  const auto bound = [&](const Term& term) { return grounder_.bind(term, instance.binding); };
  switch (formula.kind) {
    case Formula::Kind::relation: {
      Atom atom{grounder_.relation(formula.relation), {}};
      for (const Term& term : formula.terms) atom.arguments.push_back(bound(term));
      literals.atoms.push_back(std::move(atom));
      break;
    }
    case Formula::Kind::equality:
      literals.equalities.emplace_back(bound(formula.terms[0]), bound(formula.terms[1]));
      break;
    case Formula::Kind::negation:
      collect(formula.parts.front(), instance, clause, clause.refuted);
      break;
    case Formula::Kind::falsity:
      clause.is_false = true;
      break;
    case Formula::Kind::conjunction:
      for (const Formula& part : formula.parts) collect(part, instance, clause, literals);
      break;
    case Formula::Kind::truth:
    case Formula::Kind::disjunction:
      break;
  }
}

LeastClosure::TermId LeastClosure::root(TermId term) const {
  while (parent_[term] != term) term = parent_[term];
  return term;
}

LeastClosure::Key LeastClosure::key(const Atom& atom) const {
  Key result{atom.relation};
  for (const TermId argument : atom.arguments) result.push_back(root(argument));
  return result;
}

bool LeastClosure::holds(const Literals& literals) const {
  return std::all_of(literals.atoms.begin(), literals.atoms.end(),
                     [&](const Atom& atom) { return keys_.contains(key(atom)); }) &&
         std::all_of(literals.equalities.begin(), literals.equalities.end(),
                     [&](const Equality& pair) { return root(pair.first) == root(pair.second); });
}

bool LeastClosure::holds(const Fact& fact) {
  Atom atom = grounder_.atom(fact);
  const bool is_known = std::all_of(atom.arguments.begin(), atom.arguments.end(),
                                    [&](TermId term) { return term < parent_.size(); });
  return is_known && keys_.contains(key(atom));
}

void LeastClosure::apply_all() {
  for (bool is_new = true; is_new;) {
    is_new = false;
    // Classes change within a round: an atom of old classes is then not found before the next.
    close_equalities();
    keys_.clear();
    for (const Atom& atom : known_) keys_.insert(key(atom));
    for (Clause& clause : clauses_) {
      if (clause.is_applied || !holds(clause.premise)) continue;
      clause.is_applied = is_new = true;
      for (const Atom& atom : clause.conclusion.atoms)
        if (keys_.insert(key(atom)).second) known_.push_back(atom);
      for (const auto& [a, b] : clause.conclusion.equalities) parent_[root(a)] = root(b);
    }
  }
}

/// What functions make of equal arguments is equal.
void LeastClosure::close_equalities() {
  for (bool is_new = true; is_new;) {
    is_new = false;
    std::map<std::pair<std::string, TermId>, TermId> values;
    for (TermId term = 0; term < parent_.size(); ++term) {
      const auto& [symbol, argument, sort] = grounder_.term(term);
      if (argument.empty()) continue;
      const auto [known, is_first] = values.try_emplace({symbol, root(argument.front())}, term);
      if (is_first || root(known->second) == root(term)) continue;
      parent_[root(term)] = root(known->second);
      is_new = true;
    }
  }
}

bool LeastClosure::finds_contradiction() const {
  std::map<TermId, TermId> named;
  for (TermId term = 0; term < parent_.size(); ++term) {
    const auto [known, is_first] = named.try_emplace(root(term), term);
    if (!is_first && grounder_.named_apart(known->second, term)) return true;
  }
  return std::any_of(clauses_.begin(), clauses_.end(), [&](const Clause& clause) {
    const auto is_equal = [&](const Equality& pair) {
      return root(pair.first) == root(pair.second);
    };
    const auto is_known = [&](const Atom& atom) { return keys_.contains(key(atom)); };
    return clause.is_applied &&
           (clause.is_false ||
            std::any_of(clause.refuted.equalities.begin(), clause.refuted.equalities.end(),
                        is_equal) ||
            std::any_of(clause.refuted.atoms.begin(), clause.refuted.atoms.end(), is_known));
  });
}

std::vector<LeastClosure::TermId> LeastClosure::dstates() const {
  std::vector<TermId> result;
  for (std::size_t i = 0; i < grounder_.terms(); ++i)
    if (grounder_.term(static_cast<TermId>(i)).sort == "DState")
      result.push_back(static_cast<TermId>(i));
  return result;
}

LeastClosure::TermId LeastClosure::applied(const char* function, TermId argument) {
  // The grounder remembers terms of axioms by where they are.
  static const std::map<std::string, Term> terms{{"place", application("place")},
                                                 {"along", application("along")}};
  return grounder_.bind(terms.at(function), {&argument, 1});
}

LeastClosure::Extents LeastClosure::count() {
  std::set<TermId> places;
  for (const TermId dstate : dstates()) places.insert(root(applied("place", dstate)));

  // A path is its two directions, taken for one when nothing else is still to be told apart.
  std::vector<TermId> apart = parent_;
  for (TermId term = 0; term < parent_.size(); ++term)
    if (const auto& [symbol, argument, sort] = grounder_.term(term); symbol == "opp")
      parent_[root(term)] = root(argument.front());
  std::set<TermId> paths;
  for (const TermId dstate : dstates()) paths.insert(root(applied("along", dstate)));
  parent_ = std::move(apart);

  std::map<std::size_t, std::size_t> around;
  std::vector<std::pair<std::size_t, std::size_t>> travels;
  const std::size_t leads = grounder_.relation("leads");
  for (const Key& atom : keys_) {
    if (atom.front() != leads) continue;
    const std::string& action = grounder_.term(static_cast<TermId>(atom[2])).symbol;
    if (action == "turn_around") around[atom[1]] = atom[3];
    if (action == "travel") travels.emplace_back(atom[1], atom[3]);
  }
  // A travel and its way back have the same two gateways.
  std::set<std::pair<std::size_t, std::size_t>> segments;
  for (const auto& [from, to] : travels) {
    const auto turned = around.find(to);
    const std::size_t gateway = turned == around.end() ? to : turned->second;
    segments.insert(std::minmax(from, gateway));
  }
  return {paths.size(), places.size(), segments.size()};
}

}  // namespace asterism
