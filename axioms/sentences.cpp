#include "axioms/sentences.hpp"

namespace asterism {
namespace {

Term variable(std::size_t number) {
  return {.kind = Term::Kind::variable, .variable = number, .symbol = "", .argument = {}};
}

Term constant(const std::string& name) { return {.symbol = name, .argument = {}}; }

Term apply(const std::string& function, Term argument) {
  return {.kind = Term::Kind::application, .symbol = function, .argument = {std::move(argument)}};
}

Formula relation(const std::string& name, std::vector<Term> terms) {
  return {
      .kind = Formula::Kind::relation, .relation = name, .terms = std::move(terms), .parts = {}};
}

Formula equal(Term one, Term other) {
  return {.kind = Formula::Kind::equality,
          .relation = "",
          .terms = {std::move(one), std::move(other)},
          .parts = {}};
}

Formula negated(Formula formula) {
  return {
      .kind = Formula::Kind::negation, .relation = "", .terms = {}, .parts = {std::move(formula)}};
}

Formula both(Formula one, Formula other) {
  return {.kind = Formula::Kind::conjunction,
          .relation = "",
          .terms = {},
          .parts = {std::move(one), std::move(other)}};
}

Axiom sentence(const std::string& name, std::vector<Axiom::Variable> variables,
               std::vector<Formula> premise, Formula conclusion) {
  Axiom result;
  result.name = name;
  result.variables = std::move(variables);
  result.premise = std::move(premise);
  result.conclusion = std::move(conclusion);
  return result;
}

}  // namespace

Axiom turns_are_turns() {
  return sentence("turns", {}, {},
                  both(relation("is_turn", {constant("turn_around")}),
                       relation("is_turn", {constant("turn_clockwise")})));
}

Axiom no_travel_between_places() {
  return sentence("no_travel", {{"q", "DState"}, {"r", "DState"}},
                  {relation("leads", {variable(0), constant("travel"), variable(1)})},
                  equal(apply("place", variable(0)), apply("place", variable(1))));
}

std::vector<Axiom> usual_sentences(const AxiomSet& axioms) {
  std::vector<Axiom> result{
      sentence("elsewhere", {{"q", "DState"}, {"a", "Action"}, {"r", "DState"}},
               {relation("leads", {variable(0), variable(1), variable(2)})},
               negated(equal(variable(0), variable(2)))),
      sentence("travel_is_no_turn", {}, {}, negated(relation("is_turn", {constant("travel")})))};
  for (const char* const name : {"next", "opposite"})
    result.push_back(sentence(name + std::string("_elsewhere"), {{"q", "DState"}, {"r", "DState"}},
                              {relation(name, {variable(0), variable(1)})},
                              negated(equal(variable(0), variable(1)))));
  const auto opp = axioms.functions().find("opp");
  if (opp != axioms.functions().end() && opp->second.arguments.size() == 1 &&
      opp->second.result == opp->second.arguments.front()) {
    const Term other = apply("opp", variable(0));
    result.push_back(sentence(
        "two_directions", {{"d", opp->second.result}}, {},
        both(equal(apply("opp", other), variable(0)), negated(equal(other, variable(0))))));
  }
  return result;
}

}  // namespace asterism
