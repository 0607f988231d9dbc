#include "axioms/bench/formula.hpp"

namespace asterism {
namespace {

z3::sort sort_for(z3::context& context, const std::string& name) {
  return name == "Bool" ? context.bool_sort() : context.uninterpreted_sort(name.c_str());
}

}  // namespace

std::map<std::string, z3::func_decl> declare_functions(z3::context& context,
                                                       const AxiomSet& axioms) {
  std::map<std::string, z3::func_decl> result;
  for (const auto& [name, function] : axioms.functions()) {
    z3::sort_vector arguments(context);
    for (const std::string& sort : function.arguments) arguments.push_back(sort_for(context, sort));
    const z3::sort value = sort_for(context, function.result);
    result.emplace(name, context.function(name.c_str(), arguments, value));
  }
  return result;
}

z3::expr z3_formula(z3::context& context, const Formula& formula, const AtomForZ3& atom) {
  z3::expr_vector parts(context);
  for (const Formula& part : formula.parts) parts.push_back(z3_formula(context, part, atom));
  switch (formula.kind) {
    case Formula::Kind::truth:
      return context.bool_val(true);
    case Formula::Kind::falsity:
      return context.bool_val(false);
    case Formula::Kind::negation:
      return !parts[0];
    case Formula::Kind::conjunction:
      return z3::mk_and(parts);
    case Formula::Kind::disjunction:
      return z3::mk_or(parts);
    case Formula::Kind::relation:
    case Formula::Kind::equality:
      break;
  }
  return atom(formula);
}

z3::expr z3_implication(z3::expr_vector premise, const Axiom& axiom, const AtomForZ3& atom) {
  z3::context& context = premise.ctx();
  for (const Formula& part : axiom.premise) premise.push_back(z3_formula(context, part, atom));
  return z3::implies(z3::mk_and(premise), z3_formula(context, axiom.conclusion, atom));
}

}  // namespace asterism
