#include "axioms/extent_reader.hpp"

#include <algorithm>
#include <span>

namespace asterism {
namespace {

constexpr std::size_t max_variables = 4;  // each may stand for any dstate

bool contains(const Term& term, std::size_t variable) {
  if (term.kind == Term::Kind::variable) return term.variable == variable;
  return std::ranges::any_of(term.argument,
                             [&](const Term& part) { return contains(part, variable); });
}

bool contains(const Formula& formula, std::size_t variable) {
  const auto has = [&](const auto& part) { return contains(part, variable); };
  return std::ranges::any_of(formula.terms, has) || std::ranges::any_of(formula.parts, has);
}

FormulaReader::Variables variables_of_dstates(const SExpr& list, const FormulaReader& words) {
  for (const SExpr& variable : list.list)
    if (variable.list.size() != 2 || !variable.list[1].is("DState"))
      words.fail(variable, "(NAME DState)");
  if (list.list.size() > max_variables)
    words.fail(list, "at most " + std::to_string(max_variables) + " variables");
  return words.variables(list);
}

}  // namespace

ExtentDeclaration read_extent(const SExpr& form, const FormulaReader& words) {
  const std::string expected =
      "(set-info :extent (NAME ((x DState) ...) TERM ...)), or :where PREMISE before the terms";
  if (form.list.size() != 3 || form.list[2].list.size() < 3) words.fail(form, expected);
  const SExpr& declared = form.list[2];
  std::span<const SExpr> terms = std::span(declared.list).subspan(2);
  words.require_name(declared.list[0]);
  if (!declared.list[1].is_list()) words.fail(declared.list[1], "((x DState) ...)");

  ExtentDeclaration extent;
  extent.name = declared.list[0].symbol;
  extent.file = words.file();
  extent.line = form.line;
  const Documentation said = words.documentation(form, extent.name);
  extent.source = said.source;
  extent.words = said.words;
  extent.formula = said.formula;
  extent.variables = variables_of_dstates(declared.list[1], words);
  if (terms.front().is(":where")) {
    if (terms.size() < 3) words.fail(form, expected);
    extent.premise = words.premise(terms[1], extent.variables);
    words.require_literals(extent.premise, terms[1]);
    terms = terms.subspan(2);
  }
  for (const SExpr& term : terms) {
    extent.terms.push_back(words.term(term, extent.variables));
    const std::string sort = words.sort_of(extent.terms.front(), extent.variables);
    if (words.sort_of(extent.terms.back(), extent.variables) != sort)
      words.fail(term, "a term of sort " + sort + ", as the first is");
  }
  for (std::size_t i = 0; i < extent.variables.size(); ++i) {
    const auto has = [&](const auto& part) { return contains(part, i); };
    if (std::ranges::none_of(extent.terms, has) && std::ranges::none_of(extent.premise, has))
      words.fail(form, "variable " + extent.variables[i].name + " in a term or in the premise");
  }
  return extent;
}

}  // namespace asterism
