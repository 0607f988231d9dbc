#include "axioms/axiom_solver.hpp"

#include <set>

#include "axioms/z3_vocabulary.hpp"
#include "core/error.hpp"

namespace asterism {
namespace {

Verdict verdict(z3::check_result result) {
  switch (result) {
    case z3::sat:
      return Verdict::consistent;
    case z3::unsat:
      return Verdict::inconsistent;
    case z3::unknown:
      break;
  }
  return Verdict::undecided;
}

}  // namespace

struct AxiomSolver::State {
  State(const AxiomSet& axioms, unsigned timeout_ms)
      : solver(simple_solver(context)), grounder(axioms), vocabulary(context, grounder) {
    set_timeout(solver, timeout_ms);
  }

  z3::context context;
  z3::solver solver;
  Grounder grounder;
  Z3Vocabulary vocabulary;
};

AxiomSolver::AxiomSolver(const AxiomSet& axioms, unsigned timeout_ms)
    : state_(guarded_z3([&] { return std::make_unique<State>(axioms, timeout_ms); })) {}
AxiomSolver::~AxiomSolver() = default;
AxiomSolver::AxiomSolver(AxiomSolver&&) noexcept = default;
AxiomSolver& AxiomSolver::operator=(AxiomSolver&&) noexcept = default;

void AxiomSolver::push() {
  guarded_z3([&] { state_->solver.push(); });
  state_->grounder.push();
}

void AxiomSolver::pop() {
  state_->grounder.pop();
  guarded_z3([&] { state_->solver.pop(); });
}

void AxiomSolver::add(std::span<const Fact> facts) {
  guarded_z3([&] {
    for (const Fact& fact : facts) {
      state_->solver.add(state_->vocabulary.atom(state_->grounder.atom(fact)));
      state_->grounder.add(fact, [&](const Grounder::Instance& instance) {
        state_->solver.add(state_->vocabulary.instance(instance));
      });
    }
  });
}

Verdict AxiomSolver::check() {
  return guarded_z3([&] { return verdict(state_->solver.check()); });
}

namespace {

/// Facts and all the instances they lead to, each behind a guard of its own.
class GuardedProblem {
 public:
  GuardedProblem(const AxiomSet& axioms, std::span<const Fact> facts)
      : grounder_(axioms), vocabulary_(context_, grounder_) {
    for (const Fact& fact : facts) {
      formulas_.push_back(vocabulary_.atom(grounder_.atom(fact)));
      instances_.push_back(std::nullopt);
    }
    for (const Fact& fact : facts)
      grounder_.add(fact, [&](const Grounder::Instance& instance) {
        formulas_.push_back(vocabulary_.instance(instance));
        instances_.push_back(instance);
      });
  }

  std::size_t size() const { return formulas_.size(); }
  const std::optional<Grounder::Instance>& instance(std::size_t i) const { return instances_[i]; }
  const Grounder& grounder() const { return grounder_; }

  /// Those of `members` that cannot be satisfied together, minimised; nothing if they can be.
  std::optional<std::vector<std::size_t>> core(std::span<const std::size_t> members,
                                               unsigned timeout_ms) {
    z3::solver solver = simple_solver(context_);
    set_timeout(solver, timeout_ms);
    z3::params parameters(context_);
    parameters.set("core.minimize", true);
    solver.set(parameters);
    z3::expr_vector guards(context_);
    for (const std::size_t i : members) {
      const z3::expr guard = context_.bool_const(("guard_" + std::to_string(i)).c_str());
      solver.add(z3::implies(guard, formulas_[i]));
      guards.push_back(guard);
    }
    if (solver.check(guards) != z3::unsat) return std::nullopt;
    const z3::expr_vector core = solver.unsat_core();
    std::set<std::string> names;
    for (unsigned i = 0; i < core.size(); ++i) names.insert(core[static_cast<int>(i)].to_string());
    std::vector<std::size_t> result;
    for (const std::size_t i : members)
      if (names.contains("guard_" + std::to_string(i))) result.push_back(i);
    return result;
  }

  bool is_refuted(std::span<const std::size_t> members, unsigned timeout_ms) {
    return core(members, timeout_ms).has_value();
  }

 private:
  z3::context context_;
  Grounder grounder_;
  Z3Vocabulary vocabulary_;
  std::vector<z3::expr> formulas_;
  std::vector<std::optional<Grounder::Instance>> instances_;
};

std::string text(const Grounder& grounder, Grounder::TermId id) {
  const auto& term = grounder.term(id);
  if (term.argument.empty()) return term.symbol;
  return "(" + term.symbol + " " + text(grounder, term.argument.front()) + ")";
}

std::string text(Grounder& grounder, const Formula& formula, const Grounder::Instance& instance) {
  const auto list = [&](const std::string& head) {
    std::string result = "(" + head;
    for (const Term& term : formula.terms)
      result += " " + text(grounder, grounder.bind(term, instance.binding));
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
    premise += " (= " + text(grounder, a) + " " + text(grounder, b) + ")";
  for (const Formula& part : instance.axiom->premise)
    premise += " " + text(grounder, part, instance);
  return "(=> " + premise + ") " + text(grounder, instance.axiom->conclusion, instance) + ")";
}

}  // namespace

std::optional<Clash> find_clash(const AxiomSet& axioms, std::span<const Fact> facts,
                                std::size_t background, unsigned timeout_ms) {
  return guarded_z3([&]() -> std::optional<Clash> {
    GuardedProblem problem(axioms, facts);
    std::vector<std::size_t> members(problem.size());
    for (std::size_t i = 0; i < members.size(); ++i) members[i] = i;
    auto core = problem.core(members, timeout_ms);
    if (!core) return std::nullopt;
    // Z3's minimisation may leave members that can be spared: drop them one by one.
    for (std::size_t i = 0; i < core->size();) {
      std::vector<std::size_t> without = *core;
      without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
      if (problem.is_refuted(without, timeout_ms))
        core = std::move(without);
      else
        ++i;
    }
    if (GuardedProblem fresh(axioms, facts); !fresh.is_refuted(*core, timeout_ms))
      throw SolverError("z3: a core did not stand a second check");

    Clash clash;
    for (const std::size_t i : *core) {
      if (const auto& instance = problem.instance(i)) {
        Clash::Step step{instance->axiom->name, {}};
        for (std::size_t v = 0; v < instance->binding.size(); ++v)
          step.binding.emplace_back(instance->axiom->variables[v].name,
                                    text(problem.grounder(), instance->binding[v]));
        clash.steps.push_back(std::move(step));
      } else if (i >= background) {
        clash.facts.push_back(facts[i]);
      }
    }
    return clash;
  });
}

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
