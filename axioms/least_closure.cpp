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

}  // namespace

bool LeastClosure::exists(const AxiomSet& axioms) {
  return std::all_of(axioms.axioms().begin(), axioms.axioms().end(), [](const Axiom& axiom) {
    return std::all_of(axiom.premise.begin(), axiom.premise.end(), is_atom) &&
           leaves_no_choice(axiom.conclusion);
  });
}

LeastClosure::LeastClosure(const AxiomSet& axioms, std::span<const Fact> facts)
    : grounder_(axioms) {
  for (const Fact& fact : facts) known_.push_back(grounder_.atom(fact));
  for (TermId term = 0; term < grounder_.terms(); ++term)
    if (grounder_.term(term).sort == "DState") dstates_.push_back(term);
  for (const Fact& fact : facts)
    grounder_.add(fact, [&](const Grounder::Instance& instance) {
      Clause& clause = clauses_.emplace_back();
      clause.premise.equalities = instance.equal;
      for (const Formula& part : instance.axiom->premise)
        collect(part, instance, clause, clause.premise);
      collect(instance.axiom->conclusion, instance, clause, clause.conclusion);
    });
  // What is counted is there also where no instance names it.
  const AxiomSet& own = grounder_.axioms();
  for (const Extent extent : all_extents) make_terms(own.shipped_extent(extent));
  for (const ExtentDeclaration& extent : own.minimised()) make_terms(extent);
  while (classes_.size() < grounder_.terms()) classes_.add();
  apply_all();
  is_contradictory_ = finds_contradiction();
  extents_ = {.paths = count(own.shipped_extent(Extent::path)),
              .places = count(own.shipped_extent(Extent::place)),
              .segments = count(own.shipped_extent(Extent::segment))};
  for (const ExtentDeclaration& extent : own.minimised())
    minimised_.push_back(extent.known ? extents_.of(*extent.known) : count(extent));
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

LeastClosure::TermId LeastClosure::Classes::of(TermId term) const {
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
                                    [&](TermId term) { return term < classes_.size(); });
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
      for (const auto& [a, b] : clause.conclusion.equalities) classes_.join(a, b);
    }
  }
}

/// What functions make of equal arguments is equal.
void LeastClosure::close_equalities() {
  for (bool is_new = true; is_new;) {
    is_new = false;
    std::map<std::pair<std::string, TermId>, TermId> values;
    for (TermId term = 0; term < classes_.size(); ++term) {
      const auto& [symbol, argument, sort] = grounder_.term(term);
      if (argument.empty()) continue;
      const auto [known, is_first] = values.try_emplace({symbol, root(argument.front())}, term);
      if (is_first || root(known->second) == root(term)) continue;
      classes_.join(term, known->second);
      is_new = true;
    }
  }
}

bool LeastClosure::finds_contradiction() const {
  std::map<TermId, TermId> named;
  for (TermId term = 0; term < classes_.size(); ++term) {
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

namespace {

constexpr Grounder::TermId unbound = UINT32_MAX;

bool has_unbound(const Term& term, const std::vector<Grounder::TermId>& binding) {
  if (term.kind == Term::Kind::variable) return binding[term.variable] == unbound;
  return !term.argument.empty() && has_unbound(term.argument.front(), binding);
}

void collect_terms(const Formula& formula, std::vector<const Term*>& terms) {
  for (const Term& term : formula.terms) terms.push_back(&term);
  for (const Formula& part : formula.parts) collect_terms(part, terms);
}

}  // namespace

/// A term has one variable at most, which may stand for any dstate.
void LeastClosure::make_terms(const ExtentDeclaration& extent) {
  std::vector<const Term*> terms;
  for (const Term& term : extent.terms) terms.push_back(&term);
  for (const Formula& part : extent.premise) collect_terms(part, terms);
  for (const TermId dstate : dstates_)
    for (const Term* const term : terms)
      grounder_.bind(*term, Binding(extent.variables.size(), dstate));
}

std::uint32_t LeastClosure::count(const ExtentDeclaration& extent) {
  Classes joined = classes_;  // what is not equal, but counts as one
  std::set<TermId> values;
  bind(extent, 0, Binding(extent.variables.size(), unbound), [&](const Binding& binding) {
    const TermId first = grounder_.bind(extent.terms.front(), binding);
    for (const Term& term : extent.terms) {
      const TermId value = grounder_.bind(term, binding);
      values.insert(value);
      joined.join(value, first);
    }
  });
  std::set<TermId> counted;
  for (const TermId value : values) counted.insert(joined.of(value));
  return static_cast<std::uint32_t>(counted.size());
}

/// Calls f for all that the variables may stand for: relations of the premise tell most of them.
void LeastClosure::bind(const ExtentDeclaration& extent, std::size_t part, const Binding& binding,
                        const std::function<void(const Binding&)>& f) {
  if (part < extent.premise.size()) {
    const Formula& formula = extent.premise[part];
    if (formula.kind != Formula::Kind::relation) return bind(extent, part + 1, binding, f);
    const std::size_t relation = grounder_.relation(formula.relation);
    for (auto atom = keys_.lower_bound({relation});
         atom != keys_.end() && atom->front() == relation; ++atom)
      if (const auto more = matched(formula, *atom, binding)) bind(extent, part + 1, *more, f);
    return;
  }
  if (const auto free = std::ranges::find(binding, unbound); free != binding.end()) {
    Binding more = binding;
    for (const TermId dstate : dstates_) {
      more[static_cast<std::size_t>(free - binding.begin())] = dstate;
      bind(extent, part, more, f);
    }
    return;
  }
  if (std::ranges::all_of(extent.premise, [&](const auto& each) { return holds(each, binding); }))
    f(binding);
}

/// The binding with the variables that stand by themselves in the atom; nothing if the premise says
/// another atom. What has a variable inside that is not bound yet is left to holds().
std::optional<LeastClosure::Binding> LeastClosure::matched(const Formula& premise, const Key& atom,
                                                           Binding binding) {
  for (std::size_t i = 0; i < premise.terms.size(); ++i) {
    const Term& term = premise.terms[i];
    const auto argument = static_cast<TermId>(atom[i + 1]);
    if (has_unbound(term, binding)) {
      if (term.kind != Term::Kind::variable) continue;
      // Dstates are named apart, so that each is a class of its own.
      if (!std::ranges::binary_search(dstates_, argument)) return std::nullopt;
      binding[term.variable] = argument;
    } else if (root(grounder_.bind(term, binding)) != argument) {
      return std::nullopt;
    }
  }
  return binding;
}

bool LeastClosure::holds(const Formula& formula, const Binding& binding) {
  const auto value = [&](const Term& term) { return grounder_.bind(term, binding); };
  if (formula.kind == Formula::Kind::negation) return !holds(formula.parts.front(), binding);
  if (formula.kind == Formula::Kind::equality)
    return root(value(formula.terms[0])) == root(value(formula.terms[1]));
  Atom atom{grounder_.relation(formula.relation), {}};
  for (const Term& term : formula.terms) atom.arguments.push_back(value(term));
  return keys_.contains(key(atom));
}

}  // namespace asterism
