#include "axioms/grounder.hpp"

#include <stdexcept>
#include <utility>

#include "core/error.hpp"

namespace asterism {
namespace {

/// Deeper terms come of an axiom that makes terms of terms without end.
constexpr std::size_t max_depth = 16;

/// The relations that can make a formula true by holding themselves, or where `negated`, false.
void collect_heads(const Formula& formula, bool negated, std::vector<const Formula*>& heads) {
  if (formula.kind == Formula::Kind::relation && !negated) heads.push_back(&formula);
  const bool turned = negated != (formula.kind == Formula::Kind::negation);
  for (const Formula& part : formula.parts) collect_heads(part, turned, heads);
}

/// Where the atoms with one argument at one position of one relation are listed.
std::uint64_t key(std::uint32_t relation, std::size_t position, Grounder::TermId argument) {
  return (std::uint64_t{relation} * 8 + position) << 32 | argument;
}

}  // namespace

std::size_t Grounder::BoundTermHash::operator()(const std::pair<const Term*, TermId>& bound) const {
  return (std::hash<const Term*>()(bound.first) + bound.second) * 0x9e3779b97f4a7c15u >> 7;
}

std::size_t Grounder::AtomHash::operator()(const GroundAtom& atom) const {
  std::size_t hash = atom.relation;
  for (const TermId argument : atom.arguments) hash = hash * 0x9e3779b97f4a7c15u + argument + 1;
  return hash ^ (hash >> 29);
}

Grounder::Grounder(const AxiomSet& axioms) : axioms_(axioms) {
  for (const auto& [name, function] : axioms_.functions()) {
    if (function.result != "Bool") continue;
    if (function.arguments.size() > 8) throw std::invalid_argument(name + ": too many arguments");
    relation_numbers_[name] = static_cast<std::uint32_t>(relations_.size());
    relations_.push_back(name);
  }
  for (const std::string& sort : axioms_.sorts())
    unique_names_[sort] = axioms_.has_unique_names(sort);
  for (const Axiom& axiom : axioms_.axioms()) {
    if (axiom.by_signature) continue;
    Rule rule{.axiom = &axiom, .premises = {}, .heads = {}, .equalities = {}};
    for (const Formula& part : axiom.premise) {
      if (part.kind == Formula::Kind::relation)
        rule.premises.push_back({relation_numbers_.at(part.relation), &part});
      if (part.kind == Formula::Kind::equality) rule.equalities.push_back(&part);
      if (part.kind == Formula::Kind::negation) collect_heads(part, true, rule.heads);
    }
    collect_heads(axiom.conclusion, false, rule.heads);
    rules_.push_back(std::move(rule));
  }
  triggers_.resize(relations_.size());
  by_relation_.resize(relations_.size());
  for (const Rule& rule : rules_)
    for (std::size_t i = 0; i < rule.premises.size(); ++i)
      triggers_[rule.premises[i].relation].push_back({&rule, i});
}

Grounder::TermId Grounder::intern(const std::string& symbol, std::vector<TermId> argument,
                                  const std::string& sort) {
  const auto [entry, is_new] =
      term_numbers_.try_emplace(std::pair(symbol, argument), static_cast<TermId>(terms_.size()));
  if (is_new) terms_.push_back({symbol, std::move(argument), sort});
  return entry->second;
}

Grounder::TermId Grounder::constant(const std::string& name, const std::string& sort) {
  return intern(name, {}, sort);
}

Grounder::TermId Grounder::bind(const Term& term, std::span<const TermId> binding) {
  if (term.kind == Term::Kind::variable) return binding[term.variable];
  const bool is_constant = term.kind == Term::Kind::constant;
  const TermId argument = is_constant ? unbound : bind(term.argument.front(), binding);
  const auto [entry, is_new] = bound_terms_.try_emplace(std::pair(&term, argument), 0);
  if (is_new) {
    const std::string& sort = axioms_.functions().at(term.symbol).result;
    entry->second =
        is_constant ? constant(term.symbol, sort) : intern(term.symbol, {argument}, sort);
  }
  return entry->second;
}

Grounder::GroundAtom Grounder::atom(const Fact& fact) {
  GroundAtom result{relation_numbers_.at(fact.relation), {}};
  const auto& sorts = axioms_.functions().at(fact.relation).arguments;
  if (sorts.size() != fact.arguments.size())
    throw std::invalid_argument(fact.relation + ": wrong number of arguments");
  for (std::size_t i = 0; i < sorts.size(); ++i)
    result.arguments.push_back(constant(fact.arguments[i], sorts[i]));
  return result;
}

std::string Grounder::text(TermId id) const {
  const GroundTerm& term = terms_[id];
  if (term.argument.empty()) return term.symbol;
  return "(" + term.symbol + " " + text(term.argument.front()) + ")";
}

std::size_t Grounder::depth(TermId id) const {
  std::size_t result = 0;
  for (; !terms_[id].argument.empty(); id = terms_[id].argument.front()) ++result;
  return result;
}

bool Grounder::named_apart(TermId a, TermId b) const {
  return a != b && unique_names_.at(terms_[a].sort);
}

bool Grounder::learn(GroundAtom atom) {
  const auto number = static_cast<AtomId>(known_.size());
  if (!known_numbers_.emplace(atom, number).second) return false;
  by_relation_[atom.relation].push_back(number);
  for (std::size_t i = 0; i < atom.arguments.size(); ++i)
    by_argument_[key(atom.relation, i, atom.arguments[i])].push_back(number);
  known_.push_back(std::move(atom));
  return true;
}

void Grounder::pop() {
  for (; known_.size() > marks_.back(); known_.pop_back()) {
    const GroundAtom& atom = known_.back();
    by_relation_[atom.relation].pop_back();
    for (std::size_t i = 0; i < atom.arguments.size(); ++i)
      by_argument_[key(atom.relation, i, atom.arguments[i])].pop_back();
    known_numbers_.erase(atom);
  }
  processed_ = known_.size();
  marks_.pop_back();
}

void Grounder::add(const Fact& fact, const std::function<void(Instance)>& found) {
  learn(atom(fact));
  for (; processed_ < known_.size(); ++processed_) {
    const auto newest = static_cast<AtomId>(processed_);
    for (const Trigger& trigger : triggers_[known_[newest].relation]) {
      const Rule& rule = *trigger.rule;
      Instance instance{rule.axiom, {}, {}, {}};
      instance.binding.assign(rule.axiom->variables.size(), unbound);
      const GroundAtom at = known_[newest];
      if (match(rule.premises[trigger.premise], at, instance))
        join(rule, trigger.premise, 0, newest, instance, found);
    }
  }
}

bool Grounder::match(const Premise& premise, const GroundAtom& atom, Instance& instance) const {
  for (std::size_t i = 0; i < atom.arguments.size(); ++i) {
    const Term& pattern = premise.atom->terms[i];
    const TermId argument = atom.arguments[i];
    if (pattern.kind == Term::Kind::variable) {
      TermId& bound = instance.binding[pattern.variable];
      if (bound == unbound) {
        bound = argument;
      } else if (bound != argument) {
        if (named_apart(bound, argument)) return false;
        instance.equal.emplace_back(bound, argument);
      }
    } else if (pattern.kind == Term::Kind::constant && unique_names_.at(terms_[argument].sort)) {
      if (terms_[argument].symbol != pattern.symbol) return false;
    } else {
      instance.patterns.emplace_back(&pattern, argument);
    }
  }
  return true;
}

/// Binds the premises other than `fixed`, in order. To find each instance once, those before it
/// must be older than the newest atom, those after it no newer.
void Grounder::join(const Rule& rule, std::size_t fixed, std::size_t premise, AtomId newest,
                    Instance& instance, const std::function<void(Instance)>& found) {
  if (premise == fixed) ++premise;
  if (premise >= rule.premises.size()) return complete(rule, instance, found);
  const Premise& wanted = rule.premises[premise];

  // The shortest list that an argument known by now leads to.
  const std::vector<AtomId>* candidates = &by_relation_[wanted.relation];
  for (std::size_t i = 0; i < wanted.atom->terms.size(); ++i) {
    const Term& pattern = wanted.atom->terms[i];
    if (pattern.kind != Term::Kind::variable) continue;
    const TermId bound = instance.binding[pattern.variable];
    if (bound == unbound || !unique_names_.at(terms_[bound].sort)) continue;
    const auto list = by_argument_.find(key(wanted.relation, i, bound));
    if (list == by_argument_.end()) return;
    if (list->second.size() < candidates->size()) candidates = &list->second;
  }
  const AtomId end = premise < fixed ? newest : newest + 1;
  for (std::size_t i = 0; i < candidates->size() && (*candidates)[i] < end; ++i) {
    Instance extended = instance;
    if (match(wanted, known_[(*candidates)[i]], extended))
      join(rule, fixed, premise + 1, newest, extended, found);
  }
}

void Grounder::complete(const Rule& rule, Instance& instance,
                        const std::function<void(Instance)>& found) {
  for (const auto& [pattern, argument] : instance.patterns)
    if (const TermId bound = bind(*pattern, instance.binding); bound != argument)
      instance.equal.emplace_back(bound, argument);
  for (const Formula* equality : rule.equalities)
    if (named_apart(bind(equality->terms[0], instance.binding),
                    bind(equality->terms[1], instance.binding)))
      return;
  for (const Formula* head : rule.heads) {
    GroundAtom derived{relation_numbers_.at(head->relation), {}};
    for (const Term& term : head->terms) {
      derived.arguments.push_back(bind(term, instance.binding));
      if (term.kind == Term::Kind::application && depth(derived.arguments.back()) > max_depth)
        throw InputError(
            rule.axiom->file + ":" + std::to_string(rule.axiom->line),
            "terms of " + term.symbol + " without end in the conclusion of " + rule.axiom->name,
            "terms at most " + std::to_string(max_depth) + " deep");
    }
    learn(std::move(derived));
  }
  found(std::move(instance));
}

}  // namespace asterism
