#include "axioms/z3_vocabulary.hpp"

namespace asterism {
namespace {

constexpr std::size_t max_instances_an_axiom = 1 << 18;

}  // namespace

void ignore_interrupts(z3::solver& solver) {
  z3::params parameters(solver.ctx());
  parameters.set("ctrl_c", false);
  solver.set(parameters);
}

void set_timeout(z3::solver& solver, unsigned timeout_ms) {
  z3::params parameters(solver.ctx());
  parameters.set("timeout", timeout_ms);
  solver.set(parameters);
}

std::size_t Z3Vocabulary::KeyHash::operator()(const std::vector<Grounder::TermId>& key) const {
  std::size_t hash = key.size();
  for (const Grounder::TermId id : key) hash = (hash ^ id) * 0x9e3779b97f4a7c15u;
  return hash ^ (hash >> 29);
}

Z3Vocabulary::Z3Vocabulary(z3::context& context, Grounder& grounder)
    : context_(context), grounder_(grounder) {
  for (const auto& [name, function] : grounder.axioms().functions()) {
    z3::sort_vector arguments(context);
    for (const std::string& sort : function.arguments)
      arguments.push_back(context.uninterpreted_sort(sort.c_str()));
    const z3::sort result = function.result == "Bool"
                                ? context.bool_sort()
                                : context.uninterpreted_sort(function.result.c_str());
    functions_.emplace(name, context.function(name.c_str(), arguments, result));
  }
  for (const std::string& name : grounder.relations()) relations_.push_back(functions_.at(name));
}

z3::expr Z3Vocabulary::term(Grounder::TermId id) {
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

z3::expr Z3Vocabulary::atom(const Grounder::GroundAtom& atom) {
  z3::expr_vector arguments(context_);
  for (const Grounder::TermId argument : atom.arguments) arguments.push_back(term(argument));
  return relations_[atom.relation](arguments);
}

z3::expr Z3Vocabulary::equality(Grounder::TermId a, Grounder::TermId b) {
  if (a == b) return context_.bool_val(true);
  if (grounder_.named_apart(a, b)) return context_.bool_val(false);
  return term(a) == term(b);
}

z3::expr Z3Vocabulary::formula(const Formula& formula, const Grounder::Instance& instance) {
  using Kind = Formula::Kind;
  const auto bound = [&](std::size_t i) {
    return grounder_.bind(formula.terms[i], instance.binding);
  };
  z3::expr_vector parts(context_);
  for (const Formula& part : formula.parts) parts.push_back(this->formula(part, instance));
  switch (formula.kind) {
    case Kind::truth:
      return context_.bool_val(true);
    case Kind::falsity:
      return context_.bool_val(false);
    case Kind::negation:
      return !parts[0];
    case Kind::conjunction:
      return z3::mk_and(parts);
    case Kind::disjunction:
      return z3::mk_or(parts);
    case Kind::equality:
      return equality(bound(0), bound(1));
    case Kind::relation:
      break;
  }
  Grounder::GroundAtom ground{grounder_.relation(formula.relation), {}};
  for (std::size_t i = 0; i < formula.terms.size(); ++i) ground.arguments.push_back(bound(i));
  return atom(ground);
}

z3::expr Z3Vocabulary::instance(const Grounder::Instance& instance) {
  // A search meets the same instance on many branches.
  std::vector<Grounder::TermId> key = instance.binding;
  for (const auto& [a, b] : instance.equal) key.insert(key.end(), {a, b});
  auto& instances = instances_[instance.axiom];
  const auto known = instances.find(key);
  if (known != instances.end()) return known->second;
  if (instances.size() >= max_instances_an_axiom) instances.clear();
  return instances.emplace(std::move(key), make_instance(instance)).first->second;
}

z3::expr Z3Vocabulary::make_instance(const Grounder::Instance& instance) {
  z3::expr_vector premise(context_);
  for (const auto& [a, b] : instance.equal) premise.push_back(equality(a, b));
  for (const Formula& part : instance.axiom->premise) premise.push_back(formula(part, instance));
  return z3::implies(z3::mk_and(premise), formula(instance.axiom->conclusion, instance));
}

}  // namespace asterism
