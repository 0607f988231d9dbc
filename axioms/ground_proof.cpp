#include "axioms/ground_proof.hpp"

#include <algorithm>
#include <map>

#include "axioms/bench/formula.hpp"
#include "axioms/bench/guarded.hpp"
#include "axioms/bench/z3.hpp"
#include "axioms/model_finder.hpp"

namespace asterism {
namespace {

constexpr std::size_t max_instances = 50'000;  ///< of all axioms
constexpr int max_functions = 2;               ///< in a term that a variable is bound to

struct GroundTerm {
  std::string text;
  z3::expr term;
};

/// Axioms written out for the terms that can be made of a sentence's variables.
class WrittenOut {
 public:
  WrittenOut(const Axiom& sentence, const AxiomSet& vocabulary)
      : vocabulary_(vocabulary),
        functions_(declare_functions(context_, vocabulary)),
        formulas_(context_) {
    for (const auto& [sort, names] : declared_constants(vocabulary)) {
      z3::expr_vector apart(context_);
      for (const std::string& name : names) {
        terms_[sort].push_back({name, functions_.at(name)()});
        apart.push_back(terms_[sort].back().term);
      }
      if (vocabulary.has_unique_names(sort) && names.size() > 1)
        formulas_.grant(z3::distinct(apart));
    }
    std::vector<z3::expr> variables;
    for (const auto& [name, sort] : sentence.variables) {
      variables.push_back(
          context_.constant(name.c_str(), context_.uninterpreted_sort(sort.c_str())));
      terms_[sort].push_back({name, variables.back()});
    }
    add_applications();
    formulas_.grant(!implication(sentence, variables));
  }

  /// @return  whether they are not too many
  bool add(const Axiom& axiom) {
    std::vector<const GroundTerm*> bound;
    return add(axiom, bound);
  }

  const GuardedFormulas& formulas() const { return formulas_; }
  const AxiomInstance& instance(std::size_t number) const { return instances_[number]; }

 private:
  void add_applications() {
    for (int depth = 0; depth < max_functions; ++depth) {
      const auto shallower = terms_;
      for (const auto& [name, function] : vocabulary_.functions()) {
        if (function.arguments.size() != 1 || function.result == "Bool") continue;
        const auto arguments = shallower.find(function.arguments.front());
        if (arguments == shallower.end()) continue;
        auto& terms = terms_[function.result];
        for (const GroundTerm& argument : arguments->second) {
          const std::string text = name + "(" + argument.text + ")";
          const bool is_known = std::any_of(terms.begin(), terms.end(),
                                            [&](const auto& term) { return term.text == text; });
          if (!is_known) terms.push_back({text, functions_.at(name)(argument.term)});
        }
      }
    }
  }

  bool add(const Axiom& axiom, std::vector<const GroundTerm*>& bound) {
    if (bound.size() == axiom.variables.size()) {
      if (instances_.size() == max_instances) return false;
      AxiomInstance instance{axiom.name, {}};
      std::vector<z3::expr> terms;
      for (std::size_t i = 0; i < bound.size(); ++i) {
        instance.binding.emplace_back(axiom.variables[i].name, bound[i]->text);
        terms.push_back(bound[i]->term);
      }
      instances_.push_back(std::move(instance));
      formulas_.add(implication(axiom, terms));
      return true;
    }
    const auto terms = terms_.find(axiom.variables[bound.size()].sort);
    if (terms == terms_.end()) return true;  // nothing of this sort is spoken of
    for (const GroundTerm& term : terms->second) {
      bound.push_back(&term);
      if (!add(axiom, bound)) return false;
      bound.pop_back();
    }
    return true;
  }

  z3::expr bind(const Term& term, std::span<const z3::expr> variables) {
    if (term.kind == Term::Kind::variable) return variables[term.variable];
    if (term.kind == Term::Kind::constant) return functions_.at(term.symbol)();
    return functions_.at(term.symbol)(bind(term.argument.front(), variables));
  }

  z3::expr implication(const Axiom& axiom, std::span<const z3::expr> variables) {
    return z3_implication(z3::expr_vector(context_), axiom, [&](const Formula& formula) {
      z3::expr_vector terms(context_);
      for (const Term& term : formula.terms) terms.push_back(bind(term, variables));
      if (formula.kind == Formula::Kind::equality) return terms[0] == terms[1];
      return functions_.at(formula.relation)(terms);
    });
  }

  const AxiomSet& vocabulary_;
  z3::context context_;
  std::map<std::string, z3::func_decl> functions_;
  std::map<std::string, std::vector<GroundTerm>> terms_;  ///< by sort
  GuardedFormulas formulas_;  ///< the instances; granted: unique names, and that the sentence fails
  std::vector<AxiomInstance> instances_;
};

}  // namespace

std::string instance_text(const AxiomInstance& instance) {
  std::string bound;
  for (const auto& [variable, term] : instance.binding) bound += (bound.empty() ? "" : ", ") + term;
  return bound.empty() ? instance.axiom : instance.axiom + "(" + bound + ")";
}

std::optional<std::vector<AxiomInstance>> ground_proof(const Axiom& sentence,
                                                       const AxiomSet& vocabulary,
                                                       std::span<const Axiom* const> axioms,
                                                       unsigned timeout_ms) {
  return guarded_z3([&]() -> std::optional<std::vector<AxiomInstance>> {
    const auto written_out = [&](WrittenOut& problem) {
      return std::all_of(axioms.begin(), axioms.end(),
                         [&](const Axiom* axiom) { return problem.add(*axiom); });
    };
    WrittenOut problem(sentence, vocabulary);
    if (!written_out(problem)) return std::nullopt;
    const auto core = problem.formulas().irredundant_core(timeout_ms);
    if (!core) return std::nullopt;
    WrittenOut fresh(sentence, vocabulary);
    if (!written_out(fresh)) return std::nullopt;
    fresh.formulas().confirm(*core, timeout_ms);
    std::vector<AxiomInstance> proof;
    for (const std::size_t i : *core) proof.push_back(problem.instance(i));
    return proof;
  });
}

}  // namespace asterism
