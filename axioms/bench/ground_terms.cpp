#include "axioms/bench/ground_terms.hpp"

#include "axioms/bench/formula.hpp"

namespace asterism {
namespace {

constexpr std::size_t max_instances_an_axiom = 1 << 18;

}  // namespace

std::size_t Z3GroundTerms::KeyHash::operator()(const std::vector<Grounder::TermId>& key) const {
  std::size_t hash = key.size();
  for (const Grounder::TermId id : key) hash = (hash ^ id) * 0x9e3779b97f4a7c15u;
  return hash ^ (hash >> 29);
}

Z3GroundTerms::Z3GroundTerms(z3::context& context, Grounder& grounder)
    : context_(context),
      grounder_(grounder),
      functions_(declare_functions(context, grounder.axioms())) {
  for (const std::string& name : grounder.relations()) relations_.push_back(functions_.at(name));
}

z3::expr Z3GroundTerms::term(Grounder::TermId id) {
  // A term is made after its argument, so numbers below are always there.
  while (terms_.size() <= id) {
    const auto& ground = grounder_.term(static_cast<Grounder::TermId>(terms_.size()));
    if (ground.argument.empty())
      terms_.push_back(context_.constant(ground.symbol.c_str(),
                                         context_.uninterpreted_sort(ground.sort.c_str())));
    else
      terms_.push_back(functions_.at(ground.symbol)(terms_[ground.argument.front()]));
  }
  return terms_[id];
}

z3::expr Z3GroundTerms::atom(const Grounder::GroundAtom& atom) {
  z3::expr_vector arguments(context_);
  for (const Grounder::TermId argument : atom.arguments) arguments.push_back(term(argument));
  return relations_[atom.relation](arguments);
}

z3::expr Z3GroundTerms::equality(Grounder::TermId a, Grounder::TermId b) {
  if (a == b) return context_.bool_val(true);
  if (grounder_.named_apart(a, b)) return context_.bool_val(false);
  return term(a) == term(b);
}

z3::expr Z3GroundTerms::instance(const Grounder::Instance& instance) {
  // A search meets the same instance on many branches.
  std::vector<Grounder::TermId> key = instance.binding;
  for (const auto& [a, b] : instance.equal) key.insert(key.end(), {a, b});
  auto& instances = instances_[instance.axiom];
  const auto known = instances.find(key);
  if (known != instances.end()) return known->second;
  if (instances.size() >= max_instances_an_axiom) instances.clear();
  return instances.emplace(std::move(key), written(instance)).first->second;
}

z3::expr Z3GroundTerms::written(const Grounder::Instance& instance) {
  const auto bound = [&](const Term& term) { return grounder_.bind(term, instance.binding); };
  z3::expr_vector premise(context_);
  for (const auto& [a, b] : instance.equal) premise.push_back(equality(a, b));
  return z3_implication(premise, *instance.axiom, [&](const Formula& formula) {
    if (formula.kind == Formula::Kind::equality)
      return equality(bound(formula.terms[0]), bound(formula.terms[1]));
    Grounder::GroundAtom ground{grounder_.relation(formula.relation), {}};
    for (const Term& term : formula.terms) ground.arguments.push_back(bound(term));
    return atom(ground);
  });
}

}  // namespace asterism
