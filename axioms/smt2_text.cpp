#include "axioms/smt2_text.hpp"

#include <map>

#include "axioms/grounder.hpp"

namespace asterism {
namespace {

std::string text(Grounder& grounder, const Formula& formula, const Grounder::Instance& instance) {
  const auto list = [&](const std::string& head) {
    std::string result = "(" + head;
    for (const Term& term : formula.terms)
      result += " " + grounder.text(grounder.bind(term, instance.binding));
    for (const Formula& part : formula.parts) result += " " + text(grounder, part, instance);
    return result + ")";
  };
  switch (formula.kind) {
    case Formula::Kind::truth:
      return "true";
    case Formula::Kind::falsity:
      return "false";
    case Formula::Kind::relation:
      return list(formula.relation);
    case Formula::Kind::equality:
      return list("=");
    case Formula::Kind::negation:
      return list("not");
    case Formula::Kind::conjunction:
      return list("and");
    case Formula::Kind::disjunction:
      return list("or");
  }
  return "";
}

std::string text(Grounder& grounder, const Grounder::Instance& instance) {
  std::string premise = "(and true";
  for (const auto& [a, b] : instance.equal)
    premise += " (= " + grounder.text(a) + " " + grounder.text(b) + ")";
  for (const Formula& part : instance.axiom->premise)
    premise += " " + text(grounder, part, instance);
  return "(=> " + premise + ") " + text(grounder, instance.axiom->conclusion, instance) + ")";
}

}  // namespace

std::string smt2_text(const AxiomSet& axioms, std::span<const Fact> facts,
                      const std::string& title) {
  Grounder grounder(axioms);
  std::string assertions;
  for (std::size_t i = 0; i < facts.size(); ++i) {
    std::string atom = "(" + facts[i].relation;
    for (const std::string& argument : facts[i].arguments) atom += " " + argument;
    assertions += "(assert (! " + atom + ") :named fact." + std::to_string(i) + "))\n";
  }
  std::size_t number = facts.size();  // after a point, which no name has: each label is new
  for (const Fact& fact : facts)
    grounder.add(fact, [&](const Grounder::Instance& instance) {
      assertions += "(assert (! " + text(grounder, instance) + " :named " + instance.axiom->name +
                    "." + std::to_string(number++) + "))\n";
    });

  std::string result = "; " + title + "\n(set-logic QF_UF)\n";
  for (const std::string& sort : axioms.sorts()) result += "(declare-sort " + sort + " 0)\n";
  for (const auto& [name, function] : axioms.functions()) {
    result += "(declare-fun " + name + " (";
    for (const std::string& sort : function.arguments)
      result += (result.back() == '(' ? "" : " ") + sort;
    result += ") " + function.result + ")\n";
  }
  std::map<std::string, std::string> constants;  // of each sort
  std::map<std::string, std::size_t> count;
  for (std::size_t i = 0; i < grounder.terms(); ++i) {
    const auto& term = grounder.term(static_cast<Grounder::TermId>(i));
    if (!term.argument.empty()) continue;
    if (!axioms.functions().contains(term.symbol))
      result += "(declare-fun " + term.symbol + " () " + term.sort + ")\n";
    if (axioms.has_unique_names(term.sort)) {
      constants[term.sort] += " " + term.symbol;
      ++count[term.sort];
    }
  }
  for (const auto& [sort, names] : constants)
    if (count[sort] > 1) result += "(assert (distinct" + names + "))\n";
  return result + assertions + "(check-sat)\n";
}

}  // namespace asterism
