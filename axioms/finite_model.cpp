#include "axioms/finite_model.hpp"

#include <algorithm>

namespace asterism {
namespace {

void collect(const Term& term, const AxiomSet& axioms, std::vector<const Term*>& terms) {
  if (term.kind == Term::Kind::variable) return;
  for (const Term& argument : term.argument) collect(argument, axioms, terms);
  if (term.kind == Term::Kind::constant &&
      axioms.has_unique_names(axioms.functions().at(term.symbol).result))
    return;
  const bool is_known =
      std::any_of(terms.begin(), terms.end(), [&](const Term* other) { return *other == term; });
  if (!is_known) terms.push_back(&term);
}

void collect(const Formula& formula, const AxiomSet& axioms, std::vector<const Term*>& terms) {
  for (const Term& term : formula.terms) collect(term, axioms, terms);
  for (const Formula& part : formula.parts) collect(part, axioms, terms);
}

/// One axiom on one model, its variables bound to elements.
class Evaluation {
 public:
  Evaluation(const Axiom& axiom, const AxiomSet& axioms, const FiniteModel& model,
             std::span<const std::size_t> binding)
      : axiom_(axiom),
        model_(model),
        binding_(binding),
        terms_(terms_with_values(axiom, axioms)),
        values_(terms_.size()) {}

  /// Whether the axiom holds, whatever values terms have from number `first` on.
  bool holds(std::size_t first = 0) {
    if (first == terms_.size()) return !premise_holds() || holds(axiom_.conclusion);
    const Term& term = *terms_[first];
    const std::size_t argument = term.argument.empty() ? 0 : element(term.argument.front());
    for (const std::size_t value : model_.functions.at(term.symbol).at(argument)) {
      values_[first] = value;
      if (!holds(first + 1)) return false;
    }
    return true;
  }

 private:
  bool premise_holds() const {
    return std::all_of(axiom_.premise.begin(), axiom_.premise.end(),
                       [&](const Formula& part) { return holds(part); });
  }

  std::size_t element(const Term& term) const {
    if (term.kind == Term::Kind::variable) return binding_[term.variable];
    for (std::size_t i = 0; i < terms_.size(); ++i)
      if (*terms_[i] == term) return values_[i];
    return model_.functions.at(term.symbol).front().front();  // a constant named apart
  }

  bool holds(const Formula& formula) const {
    const auto part_holds = [&](const Formula& part) { return holds(part); };
    switch (formula.kind) {
      case Formula::Kind::truth:
        return true;
      case Formula::Kind::falsity:
        return false;
      case Formula::Kind::equality:
        return element(formula.terms[0]) == element(formula.terms[1]);
      case Formula::Kind::negation:
        return !holds(formula.parts.front());
      case Formula::Kind::conjunction:
        return std::all_of(formula.parts.begin(), formula.parts.end(), part_holds);
      case Formula::Kind::disjunction:
        return std::any_of(formula.parts.begin(), formula.parts.end(), part_holds);
      case Formula::Kind::relation:
        break;
    }
    std::vector<std::size_t> tuple;
    for (const Term& term : formula.terms) tuple.push_back(element(term));
    const auto relation = model_.relations.find(formula.relation);
    return relation != model_.relations.end() && relation->second.contains(tuple);
  }

  const Axiom& axiom_;
  const FiniteModel& model_;
  std::span<const std::size_t> binding_;
  std::vector<const Term*> terms_;
  std::vector<std::size_t> values_;
};

std::string function_text(const AxiomSet::Function& function, const FiniteModel& model,
                          const std::vector<std::vector<std::size_t>>& values) {
  std::string result;
  for (std::size_t argument = 0; argument < values.size(); ++argument) {
    if (!result.empty()) result += ", ";
    if (!function.arguments.empty())
      result += model.elements.at(function.arguments.front())[argument] + " → ";
    if (values[argument].empty()) result += "nothing";
    for (std::size_t i = 0; i < values[argument].size(); ++i)
      result += (i == 0 ? "" : " and ") + model.elements.at(function.result)[values[argument][i]];
  }
  return result;
}

std::string relation_text(const AxiomSet::Function& relation, const FiniteModel& model,
                          const std::set<std::vector<std::size_t>>& tuples) {
  std::string result;
  for (const auto& tuple : tuples) {
    if (!result.empty()) result += ", ";
    for (std::size_t i = 0; i < tuple.size(); ++i)
      result += (i == 0 ? "" : " ") + model.elements.at(relation.arguments[i])[tuple[i]];
    if (tuple.empty()) result += "true";
  }
  return result;
}

}  // namespace

std::vector<const Term*> terms_with_values(const Axiom& axiom, const AxiomSet& axioms) {
  std::vector<const Term*> terms;
  for (const Formula& part : axiom.premise) collect(part, axioms, terms);
  collect(axiom.conclusion, axioms, terms);
  return terms;
}

std::optional<std::vector<std::size_t>> failure_of(const Axiom& axiom, const AxiomSet& axioms,
                                                   const FiniteModel& model) {
  std::vector<std::size_t> binding(axiom.variables.size(), 0);
  std::size_t at = 0;
  do {
    if (!Evaluation(axiom, axioms, model, binding).holds()) return binding;
    // Counts on, the last variable fastest.
    for (at = binding.size(); at > 0; --at) {
      if (++binding[at - 1] < model.elements.at(axiom.variables[at - 1].sort).size()) break;
      binding[at - 1] = 0;
    }
  } while (at > 0);
  return std::nullopt;
}

std::optional<std::size_t> failure_of_function(const std::string& function,
                                               const FiniteModel& model) {
  const auto& values = model.functions.at(function);
  for (std::size_t argument = 0; argument < values.size(); ++argument)
    if (values[argument].size() != 1) return argument;
  return std::nullopt;
}

bool is_own_name(const std::string& function, const FiniteModel& model) {
  const AxiomSet::Function& signature = model.signature.at(function);
  return signature.arguments.empty() &&
         model.elements.at(signature.result)[model.functions.at(function).front().front()] ==
             function;
}

std::string model_text(const FiniteModel& model) {
  std::string result;
  const auto add = [&](const std::string& name, const std::string& text) {
    if (!text.empty()) result += (result.empty() ? "" : "; ") + name + ": " + text;
  };
  for (const auto& [name, values] : model.functions)
    if (!is_own_name(name, model))
      add(name, function_text(model.signature.at(name), model, values));
  for (const auto& [name, tuples] : model.relations)
    add(name, relation_text(model.signature.at(name), model, tuples));
  return result;
}

}  // namespace asterism
