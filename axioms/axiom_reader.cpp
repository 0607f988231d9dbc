#include "axioms/axiom_reader.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

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

/// Keeps labels apart from the names of relations; not part of an axiom's name.
constexpr std::string_view label_prefix = "axiom.";

const std::set<std::string> extents{"path", "place", "segment"};
constexpr std::size_t max_arguments = 8;

std::string arguments_text(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " argument" : " arguments");
}

}  // namespace

void AxiomReader::fail(const SExpr& at, const std::string& expected) const {
  std::string found = at.text();
  if (found.size() > 60) found = found.substr(0, 57) + "...";
  throw InputError(file_ + ":" + std::to_string(at.line), found, expected);
}

AxiomSet AxiomReader::read(const std::map<std::string, std::string>& files,
                           const std::string& where) {
  std::vector<std::pair<std::string, std::vector<SExpr>>> parsed;
  for (const auto& [file, text] : files) parsed.emplace_back(file, parse_sexprs(text, file));

  // Sorts before functions before assertions, since files may use what a later one declares.
  for (const std::string stage : {"declare-sort", "declare", "assert"}) {
    for (const auto& [file, forms] : parsed) {
      file_ = file;
      for (const SExpr& form : forms) {
        const bool sort = form.calls("declare-sort");
        const bool function = form.calls("declare-fun") || form.calls("declare-const");
        if (!sort && !function && !form.calls("assert") && !form.calls("set-info"))
          fail(form, "declare-sort, declare-const, declare-fun, assert or set-info");
        if ((stage == "declare-sort" && sort) || (stage == "declare" && function)) declare(form);
        if (stage != "assert") continue;
        if (form.calls("set-info")) set_preference(form);
        if (form.calls("assert")) {
          add(assertion(form), form);
        } else if (const auto title = heading(form.comment); title && function) {
          Axiom axiom;
          axiom.name = title->name;
          axiom.by_signature = true;
          axiom.function = form.list[1].symbol;
          document(axiom, form);
          add(std::move(axiom), form);
        }
      }
    }
  }
  if (contents_.preference.empty()) contents_.preference = {"path", "place"};
  AxiomSet set(std::make_shared<const AxiomSet::Contents>(std::move(contents_)));
  require_vocabulary(set, where);
  return set;
}

void AxiomReader::add(Axiom axiom, const SExpr& form) {
  if (std::ranges::find(contents_.axioms, axiom.name, &Axiom::name) != contents_.axioms.end())
    fail(form, "one axiom named " + axiom.name);
  contents_.axioms.push_back(std::move(axiom));
}

void AxiomReader::declare(const SExpr& form) {
  const auto& parts = form.list;
  if (form.calls("declare-sort")) {
    if (parts.size() != 3 || !parts[2].is("0")) fail(form, "(declare-sort NAME 0)");
    require_name(parts[1]);
    if (std::count(contents_.sorts.begin(), contents_.sorts.end(), parts[1].symbol) != 0)
      fail(form, "each sort once");
    contents_.sorts.push_back(parts[1].symbol);
  } else if (form.calls("declare-const")) {
    if (parts.size() != 3) fail(form, "(declare-const NAME SORT)");
    require_sort(parts[2]);
    declare_function(parts[1], SExpr{}, parts[2]);
  } else {
    if (parts.size() != 4) fail(form, "(declare-fun NAME (SORT ...) SORT)");
    if (!parts[2].is_list()) fail(parts[2], "a list of sorts");
    declare_function(parts[1], parts[2], parts[3]);
  }
}

void AxiomReader::declare_function(const SExpr& name, const SExpr& arguments, const SExpr& result) {
  require_name(name);
  if (is_name_of_fact(name.symbol))
    fail(name, "a name not like those of dstates, views and actions");
  AxiomSet::Function function;
  for (const SExpr& argument : arguments.list) {
    require_sort(argument);
    function.arguments.push_back(argument.symbol);
  }
  if (!result.is("Bool")) require_sort(result);
  function.result = result.symbol;
  if (function.result != "Bool" && function.arguments.size() > 1)
    fail(name, "a relation, or a function of at most one argument");
  if (function.arguments.size() > max_arguments)
    fail(name, "a relation of at most " + std::to_string(max_arguments) + " arguments");
  if (!contents_.functions.emplace(name.symbol, function).second)
    fail(name, "a name declared once");
}

void AxiomReader::require_sort(const SExpr& sort) const {
  if (std::count(contents_.sorts.begin(), contents_.sorts.end(), sort.symbol) == 0)
    fail(sort, "a declared sort");
}

void AxiomReader::require_name(const SExpr& name) const {
  if (const auto fault = fault_of_name(name.symbol)) fail(name, *fault);
}

void AxiomReader::set_preference(const SExpr& form) {
  const auto& parts = form.list;
  if (parts.size() != 3 || !parts[1].is(":minimise") || !parts[2].is_list())
    fail(form, "(set-info :minimise (path place))");
  if (!contents_.preference.empty()) fail(form, "one preference");
  for (const SExpr& extent : parts[2].list) {
    if (!extents.contains(extent.symbol)) fail(extent, "path, place or segment");
    if (std::count(contents_.preference.begin(), contents_.preference.end(), extent.symbol) != 0)
      fail(extent, "each extent once");
    contents_.preference.push_back(extent.symbol);
  }
}

Axiom AxiomReader::assertion(const SExpr& form) const {
  const std::string expected =
      "(assert (! (forall ((x SORT) ...) (=> PREMISE CONCLUSION)) :named NAME))";
  const auto& outer = form.list;
  if (outer.size() != 2 || !outer[1].calls("!") || outer[1].list.size() != 4) fail(form, expected);
  const auto& named = outer[1].list;
  if (!named[2].is(":named")) fail(named[2], ":named NAME");
  SExpr label = named[3];
  if (label.symbol.starts_with(label_prefix)) label.symbol.erase(0, label_prefix.size());
  require_name(label);
  const SExpr& quantified = named[1];
  if (!quantified.calls("forall") || quantified.list.size() != 3 || !quantified.list[1].is_list())
    fail(quantified, "(forall ((x SORT) ...) (=> PREMISE CONCLUSION))");
  const SExpr& implication = quantified.list[2];
  if (!implication.calls("=>") || implication.list.size() != 3)
    fail(implication, "(=> PREMISE CONCLUSION)");

  Axiom axiom;
  axiom.name = label.symbol;
  document(axiom, form);
  for (const SExpr& variable : quantified.list[1].list) {
    if (variable.list.size() != 2) fail(variable, "(NAME SORT)");
    require_name(variable.list[0]);
    require_sort(variable.list[1]);
    const std::string& name = variable.list[0].symbol;
    if (contents_.functions.contains(name) ||
        std::any_of(axiom.variables.begin(), axiom.variables.end(),
                    [&](const auto& other) { return other.name == name; }))
      fail(variable, "a name not in use");
    axiom.variables.push_back({name, variable.list[1].symbol});
  }
  const SExpr& premise = implication.list[1];
  if (premise.calls("and")) {
    for (std::size_t i = 1; i < premise.list.size(); ++i)
      axiom.premise.push_back(formula(premise.list[i], axiom));
  } else {
    axiom.premise.push_back(formula(premise, axiom));
  }
  axiom.conclusion = formula(implication.list[2], axiom);
  require_safe(axiom, implication);
  return axiom;
}

void AxiomReader::document(Axiom& axiom, const SExpr& form) const {
  axiom.file = file_;
  axiom.line = form.line;
  const auto title = heading(form.comment);
  if (!title) return;
  if (title->name != axiom.name) fail(form, "the name of the comment above it, " + title->name);
  axiom.source = title->source;
  std::istringstream lines(form.comment);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    const std::size_t indent = line.find_first_not_of(' ');
    if (indent == std::string::npos) continue;
    std::string& text = indent >= 3 ? axiom.formula : axiom.words;
    text += (text.empty() ? "" : " ") + line.substr(indent);
  }
}

/// Only then are the instances that matter those whose premises are derived.       [DESIGN §8]
void AxiomReader::require_safe(const Axiom& axiom, const SExpr& form) const {
  std::vector<bool> bound(axiom.variables.size(), false);
  for (const Formula& part : axiom.premise) {
    const Formula& atom = part.kind == Formula::Kind::negation ? part.parts.front() : part;
    if (atom.kind != Formula::Kind::relation && atom.kind != Formula::Kind::equality)
      fail(form, "a premise of atoms, equalities and their negations");
    if (part.kind != Formula::Kind::relation) continue;
    for (const Term& term : part.terms)
      if (term.kind == Term::Kind::variable) bound[term.variable] = true;
  }
  for (std::size_t i = 0; i < bound.size(); ++i)
    if (!bound[i])
      fail(form, "variable " + axiom.variables[i].name + " in a positive atom of the premise");
}

Formula AxiomReader::formula(const SExpr& form, const Axiom& axiom) const {
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
    for (const SExpr& argument : arguments) result.parts.push_back(formula(argument, axiom));
    return result;
  }
  const auto relation = contents_.functions.find(head);
  if (head != "=" && (relation == contents_.functions.end() || relation->second.result != "Bool"))
    fail(form, "and, or, not, = or a declared relation");
  for (const SExpr& argument : arguments) result.terms.push_back(term(argument, axiom));
  if (head == "=") {
    if (arguments.size() != 2) fail(form, "two sides");
    if (sort_of(result.terms[0], axiom) != sort_of(result.terms[1], axiom))
      fail(form, "two sides of one sort");
    result.kind = Formula::Kind::equality;
    return result;
  }
  if (relation->second.arguments.size() != arguments.size())
    fail(form, arguments_text(relation->second.arguments.size()));
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (sort_of(result.terms[i], axiom) != relation->second.arguments[i])
      fail(arguments[i], "a term of sort " + relation->second.arguments[i]);
  result.kind = Formula::Kind::relation;
  result.relation = head;
  return result;
}

Term AxiomReader::term(const SExpr& form, const Axiom& axiom) const {
  Term result;
  if (!form.is_list()) {
    for (std::size_t i = 0; i < axiom.variables.size(); ++i)
      if (axiom.variables[i].name == form.symbol) {
        result.kind = Term::Kind::variable;
        result.variable = i;
        return result;
      }
  }
  const SExpr& head = form.is_list() ? form.list.front() : form;
  const auto function = contents_.functions.find(head.symbol);
  const std::size_t arguments = form.is_list() ? form.list.size() - 1 : 0;
  if (function == contents_.functions.end() || function->second.result == "Bool")
    fail(form, "a variable, a declared constant or function");
  if (function->second.arguments.size() != arguments)
    fail(form, arguments_text(function->second.arguments.size()));
  result.symbol = head.symbol;
  if (arguments == 1) {
    result.kind = Term::Kind::application;
    result.argument.push_back(term(form.list[1], axiom));
    if (sort_of(result.argument.front(), axiom) != function->second.arguments.front())
      fail(form.list[1], "a term of sort " + function->second.arguments.front());
  }
  return result;
}

std::string AxiomReader::sort_of(const Term& term, const Axiom& axiom) const {
  return term.kind == Term::Kind::variable ? axiom.variables[term.variable].sort
                                           : contents_.functions.at(term.symbol).result;
}

}  // namespace asterism
