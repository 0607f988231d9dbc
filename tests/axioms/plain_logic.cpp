#include "tests/axioms/plain_logic.hpp"

#include "axioms/bench/z3.hpp"

namespace asterism {
namespace {

std::string term_text(const Term& term, const Axiom& axiom, const Binding& binding) {
  switch (term.kind) {
    case Term::Kind::variable:
      return binding.at(axiom.variables[term.variable].name);
    case Term::Kind::constant:
      return term.symbol;
    case Term::Kind::application:
      break;
  }
  return "(" + term.symbol + " " + term_text(term.argument.front(), axiom, binding) + ")";
}

std::string head_text(const Formula& formula) {
  switch (formula.kind) {
    case Formula::Kind::truth:
      return "true";
    case Formula::Kind::falsity:
      return "false";
    case Formula::Kind::relation:
      return formula.relation;
    case Formula::Kind::equality:
      return "=";
    case Formula::Kind::negation:
      return "not";
    case Formula::Kind::conjunction:
      return "and";
    case Formula::Kind::disjunction:
      break;
  }
  return "or";
}

std::string formula_text(const Formula& formula, const Axiom& axiom, const Binding& binding) {
  std::string result = head_text(formula);
  if (formula.terms.empty() && formula.parts.empty()) return result;
  for (const Term& term : formula.terms) result += " " + term_text(term, axiom, binding);
  for (const Formula& part : formula.parts) result += " " + formula_text(part, axiom, binding);
  return "(" + result + ")";
}

std::vector<std::string> terms_of(const AxiomSet& axioms, const std::string& sort,
                                  std::span<const Fact> facts, int functions) {
  const auto constants = constants_of(axioms, facts);
  std::vector<std::string> result;
  if (const auto known = constants.find(sort); known != constants.end())
    result.assign(known->second.begin(), known->second.end());
  if (functions == 0) return result;
  for (const auto& [name, function] : axioms.functions())
    if (function.result == sort && !function.arguments.empty())
      for (const std::string& argument :
           terms_of(axioms, function.arguments.front(), facts, functions - 1))
        result.push_back("(" + name + " " + argument + ")");
  return result;
}

}  // namespace

std::map<std::string, std::set<std::string>> constants_of(const AxiomSet& axioms,
                                                          std::span<const Fact> facts) {
  std::map<std::string, std::set<std::string>> result;
  for (const auto& [name, function] : axioms.functions())
    if (function.arguments.empty()) result[function.result].insert(name);
  for (const Fact& fact : facts) {
    const auto& sorts = axioms.functions().at(fact.relation).arguments;
    for (std::size_t i = 0; i < sorts.size(); ++i) result[sorts[i]].insert(fact.arguments[i]);
  }
  return result;
}

std::string declarations_text(const AxiomSet& axioms, std::span<const Fact> facts) {
  std::string result;
  for (const std::string& sort : axioms.sorts()) result += "(declare-sort " + sort + " 0)\n";
  for (const auto& [name, function] : axioms.functions()) {
    std::string sorts;
    for (const std::string& sort : function.arguments) sorts += " " + sort;
    result += "(declare-fun " + name + " (" + sorts + ") " + function.result + ")\n";
  }
  for (const auto& [sort, names] : constants_of(axioms, facts)) {
    std::string all;
    for (const std::string& name : names) {
      if (!axioms.functions().contains(name))
        result += "(declare-fun " + name + " () " + sort + ")\n";
      all += " " + name;
    }
    if (axioms.has_unique_names(sort) && names.size() > 1)
      result += "(assert (distinct" + all + "))\n";
  }
  return result;
}

std::string fact_text(const Fact& fact) {
  std::string result = "(" + fact.relation;
  for (const std::string& argument : fact.arguments) result += " " + argument;
  return result + ")";
}

std::string instance_text(const Axiom& axiom, const Binding& binding) {
  std::string premise = "(and";
  for (const Formula& part : axiom.premise) premise += " " + formula_text(part, axiom, binding);
  return "(=> " + premise + ") " + formula_text(axiom.conclusion, axiom, binding) + ")";
}

std::vector<std::string> every_instance(const AxiomSet& axioms, std::span<const Fact> facts) {
  std::vector<std::string> result;
  for (const Axiom& axiom : axioms.axioms()) {
    if (axiom.by_signature) continue;
    std::vector<Binding> bindings{{}};
    for (const auto& variable : axiom.variables) {
      std::vector<Binding> extended;
      for (const std::string& term : terms_of(axioms, variable.sort, facts, 2))
        for (Binding binding : bindings) {
          binding[variable.name] = term;
          extended.push_back(std::move(binding));
        }
      bindings = std::move(extended);
    }
    for (const Binding& binding : bindings) result.push_back(instance_text(axiom, binding));
  }
  return result;
}

Verdict verdict_of(const std::string& declarations, std::span<const std::string> assertions) {
  std::string text = declarations;
  for (const std::string& assertion : assertions) text += "(assert " + assertion + ")\n";
  z3::context context;
  z3::solver solver(context);
  solver.from_string(text.c_str());
  return verdict_of(solver.check());
}

Verdict plain_verdict(const AxiomSet& axioms, std::span<const Fact> facts) {
  std::vector<std::string> assertions = every_instance(axioms, facts);
  for (const Fact& fact : facts) assertions.push_back(fact_text(fact));
  return verdict_of(declarations_text(axioms, facts), assertions);
}

}  // namespace asterism
