#include "axioms/axiom_reader.hpp"

#include <algorithm>
#include <memory>
#include <span>
#include <utility>

#include "axioms/extent_reader.hpp"
#include "axioms/least_closure.hpp"
#include "axioms/vocabulary.hpp"
#include "core/error.hpp"

namespace asterism {
namespace {

/// Keeps labels apart from the names of relations; not part of an axiom's name.
constexpr std::string_view label_prefix = "axiom.";

constexpr std::size_t max_arguments = 8;

bool has(std::span<const ExtentDeclaration> extents, std::string_view name) {
  return std::ranges::find(extents, name, &ExtentDeclaration::name) != extents.end();
}

bool tells(const SExpr& info, std::string_view keyword) {
  return info.calls("set-info") && info.list.size() > 1 && info.list[1].is(keyword);
}

/// @throws InputError if an extent is to be minimised that cannot be counted
void require_countable(const AxiomSet& axioms) {
  if (!axioms.minimises_own() || LeastClosure::exists(axioms)) return;
  for (const ExtentDeclaration& extent : axioms.minimised())
    if (!extent.known)
      throw InputError(extent.file + ":" + std::to_string(extent.line),
                       "extent " + extent.name + " minimised, where an axiom leaves a choice",
                       "path, place or segment as shipped, since no other can be counted there");
}

/// Whether two declarations count the same, whatever their comments and the names of variables.
bool same_extent(const ExtentDeclaration& a, const ExtentDeclaration& b) {
  return a.name == b.name && same_sorts(a.variables, b.variables) && a.premise == b.premise &&
         a.terms == b.terms;
}

}  // namespace

AxiomSet AxiomReader::read(const std::map<std::string, std::string>& files,
                           const std::string& where) {
  const std::vector<ExtentDeclaration>& shipped = shipped_extents();
  read_forms(files, where);
  settle(shipped);
  AxiomSet set(std::make_shared<const AxiomSet::Contents>(std::move(contents_)));
  require_countable(set);
  return set;
}

/// Read from the built-in files, by Extent.
const std::vector<ExtentDeclaration>& AxiomReader::shipped_extents() {
  static const std::vector<ExtentDeclaration> extents = [] {
    std::map<std::string, std::string> files;
    for (const auto& [name, text] : AxiomSet::built_in_files())
      if (!name.starts_with("optional/")) files[name] = text;
    AxiomReader reader;
    reader.read_forms(files, "the axioms built in");
    std::vector<ExtentDeclaration> result;
    for (const Extent extent : all_extents)
      result.push_back(
          *std::ranges::find(reader.contents_.extents, name_of(extent), &ExtentDeclaration::name));
    return result;
  }();
  return extents;
}

void AxiomReader::read_forms(const std::map<std::string, std::string>& files,
                             const std::string& where) {
  std::vector<std::pair<std::string, std::vector<SExpr>>> parsed;
  for (const auto& [file, text] : files) parsed.emplace_back(file, parse_sexprs(text, file));

  // Sorts before functions before what is said in them, since files may use what a later one
  // declares; likewise extents before which of them are minimised.
  for (const std::string stage : {"declare-sort", "declare", "assert", "extent", "minimise"}) {
    if (stage == "extent") require_vocabulary(contents_.functions, where);
    for (const auto& [file, forms] : parsed) {
      words_.set_file(file);
      for (const SExpr& form : forms) {
        const bool sort = form.calls("declare-sort");
        const bool function = form.calls("declare-fun") || form.calls("declare-const");
        if (!sort && !function && !form.calls("assert") && !form.calls("set-info"))
          words_.fail(form, "declare-sort, declare-const, declare-fun, assert or set-info");
        if ((stage == "declare-sort" && sort) || (stage == "declare" && function)) declare(form);
        if (stage == "assert") say(form);
        if (stage == "extent" && form.calls("set-info")) add_extent(form);
        if (stage == "minimise" && tells(form, ":minimise")) set_preference(form);
      }
    }
  }
}

/// An axiom, asserted or said by the signature.
void AxiomReader::say(const SExpr& form) {
  if (form.calls("assert")) return add(assertion(form), form);
  const auto name = documented_name(form.comment);
  if (!name || form.calls("declare-sort") || form.calls("set-info")) return;
  Axiom axiom;
  axiom.name = *name;
  axiom.by_signature = true;
  axiom.function = form.list[1].symbol;
  document(axiom, form);
  add(std::move(axiom), form);
}

void AxiomReader::add(Axiom axiom, const SExpr& form) {
  if (std::ranges::find(contents_.axioms, axiom.name, &Axiom::name) != contents_.axioms.end())
    words_.fail(form, "one axiom named " + axiom.name);
  contents_.axioms.push_back(std::move(axiom));
}

void AxiomReader::declare(const SExpr& form) {
  const auto& parts = form.list;
  if (form.calls("declare-sort")) {
    if (parts.size() != 3 || !parts[2].is("0")) words_.fail(form, "(declare-sort NAME 0)");
    words_.require_name(parts[1]);
    if (std::count(contents_.sorts.begin(), contents_.sorts.end(), parts[1].symbol) != 0)
      words_.fail(form, "each sort once");
    contents_.sorts.push_back(parts[1].symbol);
  } else if (form.calls("declare-const")) {
    if (parts.size() != 3) words_.fail(form, "(declare-const NAME SORT)");
    words_.require_sort(parts[2]);
    declare_function(parts[1], SExpr{}, parts[2]);
  } else {
    if (parts.size() != 4) words_.fail(form, "(declare-fun NAME (SORT ...) SORT)");
    if (!parts[2].is_list()) words_.fail(parts[2], "a list of sorts");
    declare_function(parts[1], parts[2], parts[3]);
  }
}

void AxiomReader::declare_function(const SExpr& name, const SExpr& arguments, const SExpr& result) {
  words_.require_name(name);
  if (is_name_of_fact(name.symbol))
    words_.fail(name, "a name not like those of dstates, views and actions");
  AxiomSet::Function function;
  for (const SExpr& argument : arguments.list) {
    words_.require_sort(argument);
    function.arguments.push_back(argument.symbol);
  }
  if (!result.is("Bool")) words_.require_sort(result);
  function.result = result.symbol;
  if (function.result != "Bool" && function.arguments.size() > 1)
    words_.fail(name, "a relation, or a function of at most one argument");
  if (function.arguments.size() > max_arguments)
    words_.fail(name, "a relation of at most " + std::to_string(max_arguments) + " arguments");
  if (!contents_.functions.emplace(name.symbol, function).second)
    words_.fail(name, "a name declared once");
}

Axiom AxiomReader::assertion(const SExpr& form) const {
  const std::string expected =
      "(assert (! (forall ((x SORT) ...) (=> PREMISE CONCLUSION)) :named NAME))";
  const auto& outer = form.list;
  if (outer.size() != 2 || !outer[1].calls("!") || outer[1].list.size() != 4)
    words_.fail(form, expected);
  const auto& named = outer[1].list;
  if (!named[2].is(":named")) words_.fail(named[2], ":named NAME");
  SExpr label = named[3];
  if (label.symbol.starts_with(label_prefix)) label.symbol.erase(0, label_prefix.size());
  words_.require_name(label);
  const SExpr& quantified = named[1];
  if (!quantified.calls("forall") || quantified.list.size() != 3 || !quantified.list[1].is_list())
    words_.fail(quantified, "(forall ((x SORT) ...) (=> PREMISE CONCLUSION))");
  const SExpr& implication = quantified.list[2];
  if (!implication.calls("=>") || implication.list.size() != 3)
    words_.fail(implication, "(=> PREMISE CONCLUSION)");

  Axiom axiom;
  axiom.name = label.symbol;
  document(axiom, form);
  axiom.variables = words_.variables(quantified.list[1]);
  axiom.premise = words_.premise(implication.list[1], axiom.variables);
  axiom.conclusion = words_.formula(implication.list[2], axiom.variables);
  require_safe(axiom, implication);
  return axiom;
}

void AxiomReader::document(Axiom& axiom, const SExpr& form) const {
  const Documentation said = words_.documentation(form, axiom.name);
  axiom.file = words_.file();
  axiom.line = form.line;
  axiom.source = said.source;
  axiom.words = said.words;
  axiom.formula = said.formula;
}

/// An extent, if the form declares one.
void AxiomReader::add_extent(const SExpr& form) {
  if (tells(form, ":minimise")) return;
  if (!tells(form, ":extent"))
    words_.fail(form, "(set-info :extent (NAME ...)) or (set-info :minimise (NAME ...))");
  ExtentDeclaration extent = read_extent(form, words_);
  if (has(contents_.extents, extent.name)) words_.fail(form, "one extent named " + extent.name);
  contents_.extents.push_back(std::move(extent));
}

void AxiomReader::set_preference(const SExpr& form) {
  const auto& parts = form.list;
  if (parts.size() != 3 || !parts[2].is_list())
    words_.fail(form, "(set-info :minimise (path place))");
  if (!minimised_.empty()) words_.fail(form, "one preference");
  for (const SExpr& name : parts[2].list) {
    if (!has(contents_.extents, name.symbol) && !extent_named(name.symbol))
      words_.fail(name, "path, place, segment or an extent declared");
    if (std::ranges::count(minimised_, name.symbol) != 0) words_.fail(name, "each extent once");
    minimised_.push_back(name.symbol);
  }
}

/// Which extents there are, and which of them the program knows.
void AxiomReader::settle(const std::vector<ExtentDeclaration>& shipped) {
  std::vector<ExtentDeclaration>& extents = contents_.extents;
  const auto opp = contents_.functions.find("opp");
  const bool has_opp = opp != contents_.functions.end() &&
                       opp->second == AxiomSet::Function{{"DirectedPath"}, "DirectedPath"};
  for (ExtentDeclaration extent : shipped) {
    extent.known = extent_named(extent.name);
    if (!has_opp)  // each directed path is then one of its own
      std::erase_if(extent.terms, [](const Term& term) { return term.symbol == "opp"; });
    const auto declared = std::ranges::find(extents, extent.name, &ExtentDeclaration::name);
    if (declared == extents.end())
      extents.push_back(extent);
    else if (same_extent(*declared, extent))
      declared->known = extent.known;
    contents_.shipped_extents.push_back(std::move(extent));
  }

  if (minimised_.empty()) minimised_ = {"path", "place"};
  for (const std::string& name : minimised_)
    contents_.minimised.push_back(*std::ranges::find(extents, name, &ExtentDeclaration::name));
  if (!std::ranges::all_of(contents_.minimised, [](const auto& e) { return e.known.has_value(); }))
    return;
  contents_.preference.emplace();
  for (const ExtentDeclaration& extent : contents_.minimised)
    contents_.preference->push_back(*extent.known);
}

/// Only then are the instances that matter those whose premises are derived.       [theory §8]
void AxiomReader::require_safe(const Axiom& axiom, const SExpr& form) const {
  words_.require_literals(axiom.premise, form);
  std::vector<bool> bound(axiom.variables.size(), false);
  for (const Formula& part : axiom.premise) {
    if (part.kind != Formula::Kind::relation) continue;
    for (const Term& term : part.terms)
      if (term.kind == Term::Kind::variable) bound[term.variable] = true;
  }
  for (std::size_t i = 0; i < bound.size(); ++i)
    if (!bound[i])
      words_.fail(form,
                  "variable " + axiom.variables[i].name + " in a positive atom of the premise");
}

}  // namespace asterism
