#include "axioms/ground_proof.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "axioms/model_finder.hpp"
#include "axioms/z3_vocabulary.hpp"

namespace asterism {
namespace {

constexpr std::size_t max_instances = 50'000;  ///< of all axioms
constexpr int max_functions = 2;               ///< in a term that a variable is bound to

struct GroundTerm {
  std::string text;
  z3::expr term;
};

struct Instance {
  Clash::Step step;
  z3::expr formula;
};

/// Axioms written out for the terms that can be made of a sentence's variables.
class WrittenOut {
 public:
  WrittenOut(const Axiom& sentence, const AxiomSet& vocabulary) : vocabulary_(vocabulary) {
    for (const auto& [name, function] : vocabulary.functions()) {
      z3::sort_vector arguments(context_);
      for (const std::string& sort : function.arguments) arguments.push_back(this->sort(sort));
      functions_.emplace(name,
                         context_.function(name.c_str(), arguments, this->sort(function.result)));
    }
    for (const auto& [sort, names] : declared_constants(vocabulary)) {
      z3::expr_vector apart(context_);
      for (const std::string& name : names) {
        terms_[sort].push_back({name, functions_.at(name)()});
        apart.push_back(terms_[sort].back().term);
      }
      if (vocabulary.has_unique_names(sort) && names.size() > 1)
        apart_.push_back(z3::distinct(apart));
    }
    std::vector<z3::expr> variables;
    for (const auto& [name, sort] : sentence.variables) {
      variables.push_back(context_.constant(name.c_str(), this->sort(sort)));
      terms_[sort].push_back({name, variables.back()});
    }
    add_applications();
    fails_.push_back(!implication(sentence, variables));
  }

  /// @return  whether they are not too many
  bool add(const Axiom& axiom) {
    std::vector<const GroundTerm*> bound;
    return add(axiom, bound);
  }

  /// Numbers of instances, of those given, that cannot be where the sentence fails.
  std::optional<std::vector<std::size_t>> refuted(std::span<const std::size_t> members,
                                                  unsigned timeout_ms) {
    z3::solver solver = simple_solver(context_);
    set_timeout(solver, timeout_ms);
    for (const z3::expr& formula : apart_) solver.add(formula);
    for (const z3::expr& formula : fails_) solver.add(formula);
    z3::expr_vector guards(context_);
    for (const std::size_t i : members) {
      const z3::expr guard = context_.bool_const(("instance." + std::to_string(i)).c_str());
      solver.add(z3::implies(guard, instances_[i].formula));
      guards.push_back(guard);
    }
    if (solver.check(guards) != z3::unsat) return std::nullopt;
    const z3::expr_vector core = solver.unsat_core();
    std::set<std::string> names;
    for (unsigned i = 0; i < core.size(); ++i)
      names.insert(core[static_cast<int>(i)].decl().name().str());
    std::vector<std::size_t> result;
    for (const std::size_t i : members)
      if (names.contains("instance." + std::to_string(i))) result.push_back(i);
    return result;
  }

  const std::vector<Instance>& instances() const { return instances_; }

 private:
  z3::sort sort(const std::string& name) {
    return name == "Bool" ? context_.bool_sort() : context_.uninterpreted_sort(name.c_str());
  }

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
      Clash::Step step{axiom.name, {}};
      std::vector<z3::expr> terms;
      for (std::size_t i = 0; i < bound.size(); ++i) {
        step.binding.emplace_back(axiom.variables[i].name, bound[i]->text);
        terms.push_back(bound[i]->term);
      }
      instances_.push_back({std::move(step), implication(axiom, terms)});
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

  z3::expr bind(const Formula& formula, std::span<const z3::expr> variables) {
    z3::expr_vector parts(context_);
    for (const Formula& part : formula.parts) parts.push_back(bind(part, variables));
    z3::expr_vector terms(context_);
    for (const Term& term : formula.terms) terms.push_back(bind(term, variables));
    switch (formula.kind) {
      case Formula::Kind::truth:
        return context_.bool_val(true);
      case Formula::Kind::falsity:
        return context_.bool_val(false);
      case Formula::Kind::equality:
        return terms[0] == terms[1];
      case Formula::Kind::negation:
        return !parts[0];
      case Formula::Kind::conjunction:
        return z3::mk_and(parts);
      case Formula::Kind::disjunction:
        return z3::mk_or(parts);
      case Formula::Kind::relation:
        break;
    }
    return functions_.at(formula.relation)(terms);
  }

  z3::expr implication(const Axiom& axiom, std::span<const z3::expr> variables) {
    z3::expr_vector premise(context_);
    for (const Formula& part : axiom.premise) premise.push_back(bind(part, variables));
    return z3::implies(z3::mk_and(premise), bind(axiom.conclusion, variables));
  }

  const AxiomSet& vocabulary_;
  z3::context context_;
  std::map<std::string, z3::func_decl> functions_;
  std::map<std::string, std::vector<GroundTerm>> terms_;  ///< by sort
  std::vector<z3::expr> apart_;                           ///< unique names
  std::vector<z3::expr> fails_;                           ///< the sentence does not hold
  std::vector<Instance> instances_;
};

}  // namespace

std::optional<std::vector<Clash::Step>> ground_proof(const Axiom& sentence,
                                                     const AxiomSet& vocabulary,
                                                     std::span<const Axiom* const> axioms,
                                                     unsigned timeout_ms) {
  return guarded_z3([&]() -> std::optional<std::vector<Clash::Step>> {
    const auto written_out = [&](WrittenOut& problem) {
      return std::all_of(axioms.begin(), axioms.end(),
                         [&](const Axiom* axiom) { return problem.add(*axiom); });
    };
    WrittenOut problem(sentence, vocabulary);
    if (!written_out(problem)) return std::nullopt;
    std::vector<std::size_t> all(problem.instances().size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    auto core = problem.refuted(all, timeout_ms);
    if (!core) return std::nullopt;
    for (std::size_t i = 0; i < core->size();) {
      std::vector<std::size_t> without = *core;
      without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
      if (problem.refuted(without, timeout_ms))
        core = std::move(without);
      else
        ++i;
    }
    WrittenOut fresh(sentence, vocabulary);
    if (!written_out(fresh) || !fresh.refuted(*core, timeout_ms))
      throw SolverError("z3: a proof did not stand a second check");
    std::vector<Clash::Step> proof;
    for (const std::size_t i : *core) proof.push_back(problem.instances()[i].step);
    return proof;
  });
}

}  // namespace asterism
