#include "axioms/formula_reader.hpp"

#include <algorithm>
#include <span>
#include <sstream>

#include "axioms/vocabulary.hpp"
#include "core/error.hpp"

namespace asterism {
namespace {

/// "name   [source] [source]" in the first line of a comment.
struct Heading {
  std::string name;
  std::string source;
};

std::optional<Heading> heading(const std::string& comment) {
  const std::string line = comment.substr(0, comment.find('\n'));
  const std::size_t bracket = line.find('[');
  if (bracket == std::string::npos) return std::nullopt;
  std::istringstream words(line.substr(0, bracket));
  std::string name, more;
  if (!(words >> name) || (words >> more)) return std::nullopt;
  return Heading{name, line.substr(bracket)};
}

std::string arguments_text(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " argument" : " arguments");
}

}  // namespace

std::optional<std::string> documented_name(const std::string& comment) {
  const auto title = heading(comment);
  return title ? std::optional(title->name) : std::nullopt;
}

void FormulaReader::fail(const SExpr& at, const std::string& expected) const {
  std::string found = at.text();
  if (found.size() > 60) found = found.substr(0, 57) + "...";
  throw InputError(file_ + ":" + std::to_string(at.line), found, expected);
}

void FormulaReader::require_name(const SExpr& name) const {
  if (const auto fault = fault_of_name(name.symbol)) fail(name, *fault);
}

void FormulaReader::require_sort(const SExpr& sort) const {
  if (std::count(sorts_.begin(), sorts_.end(), sort.symbol) == 0) fail(sort, "a declared sort");
}

FormulaReader::Variables FormulaReader::variables(const SExpr& list) const {
  Variables result;
  for (const SExpr& variable : list.list) {
    if (variable.list.size() != 2) fail(variable, "(NAME SORT)");
    require_name(variable.list[0]);
    require_sort(variable.list[1]);
    const std::string& name = variable.list[0].symbol;
    if (functions_.contains(name) ||
        std::ranges::find(result, name, &Axiom::Variable::name) != result.end())
      fail(variable, "a name not in use");
    result.push_back({name, variable.list[1].symbol});
  }
  return result;
}

std::vector<Formula> FormulaReader::premise(const SExpr& form, const Variables& variables) const {
  std::vector<Formula> result;
  if (form.calls("and"))
    for (std::size_t i = 1; i < form.list.size(); ++i)
      result.push_back(formula(form.list[i], variables));
  else
    result.push_back(formula(form, variables));
  return result;
}

void FormulaReader::require_literals(const std::vector<Formula>& premise,
                                     const SExpr& within) const {
  for (const Formula& part : premise) {
    const Formula& atom = part.kind == Formula::Kind::negation ? part.parts.front() : part;
    if (atom.kind != Formula::Kind::relation && atom.kind != Formula::Kind::equality)
      fail(within, "a premise of atoms, equalities and their negations");
  }
}

Formula FormulaReader::formula(const SExpr& form, const Variables& variables) const {
  Formula result;
  if (form.is("true")) return result;
  if (form.is("false")) {
    result.kind = Formula::Kind::falsity;
    return result;
  }
  if (!form.is_list() || form.list.front().is_list()) fail(form, "a formula");
  const std::string& head = form.list.front().symbol;
  const std::span<const SExpr> arguments = std::span(form.list).subspan(1);
  const bool connective = head == "and" || head == "or" || head == "not";
  if (connective) {
    if (arguments.empty() || (head == "not" && arguments.size() != 1)) fail(form, "its arguments");
    result.kind = head == "and"  ? Formula::Kind::conjunction
                  : head == "or" ? Formula::Kind::disjunction
                                 : Formula::Kind::negation;
    for (const SExpr& argument : arguments) result.parts.push_back(formula(argument, variables));
    return result;
  }
  const auto relation = functions_.find(head);
  if (head != "=" && (relation == functions_.end() || relation->second.result != "Bool"))
    fail(form, "and, or, not, = or a declared relation");
  for (const SExpr& argument : arguments) result.terms.push_back(term(argument, variables));
  if (head == "=") {
    if (arguments.size() != 2) fail(form, "two sides");
    if (sort_of(result.terms[0], variables) != sort_of(result.terms[1], variables))
      fail(form, "two sides of one sort");
    result.kind = Formula::Kind::equality;
    return result;
  }
  if (relation->second.arguments.size() != arguments.size())
    fail(form, arguments_text(relation->second.arguments.size()));
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (sort_of(result.terms[i], variables) != relation->second.arguments[i])
      fail(arguments[i], "a term of sort " + relation->second.arguments[i]);
  result.kind = Formula::Kind::relation;
  result.relation = head;
  return result;
}

Term FormulaReader::term(const SExpr& form, const Variables& variables) const {
  Term result;
  if (!form.is_list()) {
    for (std::size_t i = 0; i < variables.size(); ++i)
      if (variables[i].name == form.symbol) {
        result.kind = Term::Kind::variable;
        result.variable = i;
        return result;
      }
  }
  const SExpr& head = form.is_list() ? form.list.front() : form;
  const auto function = functions_.find(head.symbol);
  const std::size_t arguments = form.is_list() ? form.list.size() - 1 : 0;
  if (function == functions_.end() || function->second.result == "Bool")
    fail(form, "a variable, a declared constant or function");
  if (function->second.arguments.size() != arguments)
    fail(form, arguments_text(function->second.arguments.size()));
  result.symbol = head.symbol;
  if (arguments == 1) {
    result.kind = Term::Kind::application;
    result.argument.push_back(term(form.list[1], variables));
    if (sort_of(result.argument.front(), variables) != function->second.arguments.front())
      fail(form.list[1], "a term of sort " + function->second.arguments.front());
  }
  return result;
}

std::string FormulaReader::sort_of(const Term& term, const Variables& variables) const {
  return term.kind == Term::Kind::variable ? variables[term.variable].sort
                                           : functions_.at(term.symbol).result;
}

Documentation FormulaReader::documentation(const SExpr& form, const std::string& name) const {
  const auto title = heading(form.comment);
  if (!title) return {};
  if (title->name != name) fail(form, "the name of the comment above it, " + title->name);
  Documentation result{title->source, {}, {}};
  std::istringstream lines(form.comment);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    const std::size_t indent = line.find_first_not_of(' ');
    if (indent == std::string::npos) continue;
    std::string& text = indent >= 3 ? result.formula : result.words;
    text += (text.empty() ? "" : " ") + line.substr(indent);
  }
  return result;
}

}  // namespace asterism
