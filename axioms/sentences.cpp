#include "axioms/sentences.hpp"

#include "axioms/formula_reader.hpp"

namespace asterism {
namespace {

using Variables = FormulaReader::Variables;

/// @param premise     formulas, one after another: all of these
/// @param conclusion  one formula
Axiom sentence(const AxiomSet& axioms, const std::string& name, const Variables& variables,
               const std::string& premise, const std::string& conclusion) {
  const FormulaReader words(axioms.sorts(), axioms.functions());
  Axiom result;
  result.name = name;
  result.variables = variables;
  for (const SExpr& part : parse_sexprs(premise, name))
    result.premise.push_back(words.formula(part, variables));
  result.conclusion = words.formula(parse_sexprs(conclusion, name).front(), variables);
  return result;
}

}  // namespace

Axiom turns_are_turns(const AxiomSet& axioms) {
  return sentence(axioms, "turns", {}, "", "(and (is_turn turn_around) (is_turn turn_clockwise))");
}

Axiom no_travel_between_places(const AxiomSet& axioms) {
  return sentence(axioms, "no_travel", {{"q", "DState"}, {"r", "DState"}}, "(leads q travel r)",
                  "(= (place q) (place r))");
}

std::vector<Axiom> usual_sentences(const AxiomSet& axioms) {
  const Variables pair{{"q", "DState"}, {"r", "DState"}};
  std::vector<Axiom> result{
      sentence(axioms, "elsewhere", {{"q", "DState"}, {"a", "Action"}, {"r", "DState"}},
               "(leads q a r)", "(not (= q r))"),
      sentence(axioms, "travel_is_no_turn", {}, "", "(not (is_turn travel))"),
      sentence(axioms, "next_elsewhere", pair, "(next q r)", "(not (= q r))"),
      sentence(axioms, "opposite_elsewhere", pair, "(opposite q r)", "(not (= q r))")};
  const auto opp = axioms.functions().find("opp");
  if (opp != axioms.functions().end() && opp->second.arguments.size() == 1 &&
      opp->second.result == opp->second.arguments.front())
    result.push_back(sentence(axioms, "two_directions", {{"d", opp->second.result}}, "",
                              "(and (= (opp (opp d)) d) (not (= (opp d) d)))"));
  return result;
}

}  // namespace asterism
