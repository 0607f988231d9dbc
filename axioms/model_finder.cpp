#include "axioms/model_finder.hpp"

#include <algorithm>

#include "axioms/bench/formula.hpp"
#include "axioms/bench/z3.hpp"

namespace asterism {
namespace {

using Sizes = std::map<std::string, std::size_t>;

constexpr std::size_t max_instances = 200'000;  ///< of one axiom: some seconds of grounding

/// The axioms as propositions about finitely many elements.
class GroundModel {
 public:
  GroundModel(const AxiomSet& axioms, Sizes sizes)
      : axioms_(axioms),
        sizes_(std::move(sizes)),
        constants_(declared_constants(axioms)),
        solver_(context_, "QF_FD") {
    ignore_interrupts(solver_);
    for (const auto& [name, function] : axioms_.functions()) {
      std::size_t count = function.result == "Bool" ? 1 : size(function.result);
      for (const std::string& sort : function.arguments) count *= size(sort);
      auto& propositions = propositions_[name];
      for (std::size_t i = 0; i < count; ++i)
        propositions.push_back(context_.bool_const((name + "." + std::to_string(i)).c_str()));
    }
  }

  /// Whether there was not too much to ground.
  bool add(const ModelWanted& wanted) {
    for (const auto& [name, function] : axioms_.functions())
      if (function.result != "Bool") add_function(name, function, name == wanted.no_function);
    for (const std::string& relation : wanted.total) add_total(relation);
    for (const Axiom* axiom : wanted.hold)
      if (!for_each_instance(*axiom, [&](const z3::expr& failure) { solver_.add(!failure); }))
        return false;
    if (wanted.fails == nullptr) return true;
    z3::expr_vector failures(context_);
    const auto add_failure = [&](const z3::expr& failure) { failures.push_back(failure); };
    if (!for_each_instance(*wanted.fails, add_failure, true)) return false;
    solver_.add(z3::mk_or(failures));
    return true;
  }

  Verdict check(Deadline deadline) {
    if (is_over(deadline)) return Verdict::undecided;
    // A limit costs a thread for each of many short questions: none is set that would not matter.
    if (seconds_until(deadline) < 3600) set_timeout(solver_, milliseconds_until(deadline));
    return verdict_of(solver_.check());
  }

  /// Drops tuples one by one, as long as some model does without; the last check found one.
  void drop_tuples(Deadline deadline) {
    std::vector<z3::expr> holding;
    const auto keep_only_holding = [&](const z3::model& model, std::vector<z3::expr>& tuples) {
      std::erase_if(tuples, [&](const z3::expr& tuple) {
        const bool holds = model.eval(tuple, true).is_true();
        if (!holds) solver_.add(!tuple);
        return !holds;
      });
    };
    for (const auto& [name, function] : axioms_.functions())
      if (function.result == "Bool")
        holding.insert(holding.end(), propositions_.at(name).begin(), propositions_.at(name).end());
    keep_only_holding(solver_.get_model(), holding);
    while (!holding.empty()) {
      const z3::expr tuple = holding.back();
      holding.pop_back();
      solver_.push();
      solver_.add(!tuple);
      const bool can_do_without = check(deadline) == Verdict::consistent;
      if (can_do_without) {
        const z3::model model = solver_.get_model();
        solver_.pop();
        solver_.add(!tuple);
        keep_only_holding(model, holding);
      } else {
        solver_.pop();
        solver_.add(tuple);
      }
    }
    // What is left holds in a model, the last one found: ask for it again.
    check(deadline);
  }

  FiniteModel model() {
    const z3::model found = solver_.get_model();
    FiniteModel result;
    result.signature = axioms_.functions();
    for (const std::string& sort : axioms_.sorts()) result.elements[sort] = names(sort);
    for (const auto& [name, function] : axioms_.functions()) {
      const auto& propositions = propositions_.at(name);
      for (std::size_t i = 0; i < propositions.size(); ++i) {
        const bool holds = found.eval(propositions[i], true).is_true();
        if (function.result == "Bool") {
          if (holds) result.relations[name].insert(tuple(function, i));
          continue;
        }
        auto& values = result.functions[name];
        values.resize(propositions.size() / size(function.result));
        if (holds) values[i / size(function.result)].push_back(i % size(function.result));
      }
    }
    return result;
  }

 private:
  std::size_t size(const std::string& sort) const { return sizes_.at(sort); }

  std::vector<std::string> names(const std::string& sort) const {
    static const std::map<std::string, std::string> short_names{
        {"DState", "q"}, {"Action", "a"}, {"View", "v"}, {"Place", "p"}, {"DirectedPath", "π"}};
    const auto known = short_names.find(sort);
    std::vector<std::string> result;
    if (axioms_.has_unique_names(sort)) result = constants_.at(sort);
    for (std::size_t i = 0; result.size() < size(sort); ++i) {
      std::string name = (known == short_names.end() ? sort : known->second) + std::to_string(i);
      if (!axioms_.functions().contains(name)) result.push_back(std::move(name));
    }
    return result;
  }

  std::vector<std::size_t> tuple(const AxiomSet::Function& function, std::size_t number) const {
    std::vector<std::size_t> result(function.arguments.size());
    for (std::size_t i = result.size(); i > 0; number /= size(function.arguments[--i]))
      result[i - 1] = number % size(function.arguments[i - 1]);
    return result;
  }

  /// Whether its values can be numbered as they are met: nothing else has numbered them.
  bool numbers_its_values(const AxiomSet::Function& function) const {
    const auto makes_them = [&](const auto& other) {
      return other.second.result == function.result &&
             (other.second.arguments.empty() ||
              axioms_.has_unique_names(other.second.arguments.front()));
    };
    return std::count_if(axioms_.functions().begin(), axioms_.functions().end(), makes_them) == 1 &&
           !function.arguments.empty() && axioms_.has_unique_names(function.arguments.front());
  }

  void add_function(const std::string& name, const AxiomSet::Function& function, bool is_none) {
    const auto& propositions = propositions_.at(name);
    const std::size_t values = size(function.result);
    for (std::size_t begin = 0; begin < propositions.size(); begin += values) {
      z3::expr_vector one(context_);
      if (numbers_its_values(function) && !is_none)
        for (std::size_t value = begin / values + 1; value < values; ++value)
          solver_.add(!propositions[begin + value]);
      for (std::size_t value = 0; value < values; ++value)
        one.push_back(propositions[begin + value]);
      if (is_none && begin == 0) {
        solver_.add(z3::atleast(one, 2));
      } else if (function.arguments.empty() && axioms_.has_unique_names(function.result)) {
        const auto& all = constants_.at(function.result);
        const auto number = std::find(all.begin(), all.end(), name) - all.begin();
        for (std::size_t value = 0; value < values; ++value)
          solver_.add(value == static_cast<std::size_t>(number) ? propositions[value]
                                                                : !propositions[value]);
      } else {
        solver_.add(z3::mk_or(one));
        solver_.add(z3::atmost(one, 1));
      }
    }
  }

  void add_total(const std::string& relation) {
    const auto& propositions = propositions_.at(relation);
    const std::size_t elements = size(axioms_.functions().at(relation).arguments.front());
    const std::size_t rest = propositions.size() / elements;
    for (std::size_t begin = 0; begin < propositions.size(); begin += rest) {
      z3::expr_vector some(context_);
      for (std::size_t i = 0; i < rest; ++i) some.push_back(propositions[begin + i]);
      solver_.add(z3::mk_or(some));
    }
  }

  /// An axiom with its variables, and its terms, standing for elements.
  struct Instance {
    const Axiom& axiom;
    std::vector<const Term*> terms;
    std::vector<std::size_t> elements;  ///< of the variables, then of the terms
  };

  std::size_t element(const Instance& instance, const Term& term) const {
    if (term.kind == Term::Kind::variable) return instance.elements[term.variable];
    for (std::size_t i = 0; i < instance.terms.size(); ++i)
      if (*instance.terms[i] == term) return instance.elements[instance.axiom.variables.size() + i];
    const auto& all = constants_.at(axioms_.functions().at(term.symbol).result);
    return static_cast<std::size_t>(std::find(all.begin(), all.end(), term.symbol) - all.begin());
  }

  z3::expr atom(const Instance& instance, const Formula& formula) {
    if (formula.kind == Formula::Kind::equality)
      return context_.bool_val(element(instance, formula.terms[0]) ==
                               element(instance, formula.terms[1]));
    const auto& sorts = axioms_.functions().at(formula.relation).arguments;
    std::size_t number = 0;
    for (std::size_t i = 0; i < sorts.size(); ++i)
      number = number * size(sorts[i]) + element(instance, formula.terms[i]);
    return propositions_.at(formula.relation)[number];
  }

  /// Whether the elements that no constant names come in order, none before a smaller one: as well
  /// as any other order.
  bool is_in_order(const Instance& instance) const {
    std::map<std::string, std::size_t> met;
    for (std::size_t i = 0; i < instance.axiom.variables.size(); ++i) {
      const std::string& sort = instance.axiom.variables[i].sort;
      if (!axioms_.has_unique_names(sort) || !constants_.at(sort).empty()) continue;
      if (instance.elements[i] > met[sort]) return false;
      met[sort] = std::max(met[sort], instance.elements[i] + 1);
    }
    return true;
  }

  /// Calls f(that the axiom fails here) wherever it may.
  /// @return  whether there was not too much to ground
  template <class F>
  bool for_each_instance(const Axiom& axiom, F&& f, bool only_in_order = false) {
    Instance instance{axiom, terms_with_values(axiom, axioms_), {}};
    std::vector<std::size_t> sizes;
    for (const auto& variable : axiom.variables) sizes.push_back(size(variable.sort));
    for (const Term* term : instance.terms)
      sizes.push_back(size(axioms_.functions().at(term->symbol).result));
    std::size_t count = 1;
    for (const std::size_t choices : sizes)
      if ((count *= choices) > max_instances) return false;
    instance.elements.resize(sizes.size());
    for (std::size_t number = 0; number < count; ++number) {
      std::size_t rest = number;
      for (std::size_t i = sizes.size(); i > 0; rest /= sizes[--i])
        instance.elements[i - 1] = rest % sizes[i - 1];
      if (only_in_order && !is_in_order(instance)) continue;
      if (const auto failure = failure_at(instance)) f(*failure);
    }
    return true;
  }

  std::optional<z3::expr> failure_at(const Instance& instance) {
    const AtomForZ3 atom = [&](const Formula& formula) { return this->atom(instance, formula); };
    z3::expr_vector all(context_);
    for (const Formula& part : instance.axiom.premise) {
      const z3::expr holds = z3_formula(context_, part, atom);
      if (holds.is_false()) return std::nullopt;
      all.push_back(holds);
    }
    const std::size_t variables = instance.axiom.variables.size();
    for (std::size_t i = 0; i < instance.terms.size(); ++i) {
      const Term& term = *instance.terms[i];
      const std::size_t argument =
          term.argument.empty() ? 0 : element(instance, term.argument.front());
      const std::size_t values = size(axioms_.functions().at(term.symbol).result);
      all.push_back(
          propositions_.at(term.symbol)[argument * values + instance.elements[variables + i]]);
    }
    const z3::expr conclusion = z3_formula(context_, instance.axiom.conclusion, atom);
    if (conclusion.is_true()) return std::nullopt;
    all.push_back(!conclusion);
    return z3::mk_and(all);
  }

  const AxiomSet& axioms_;
  Sizes sizes_;
  std::map<std::string, std::vector<std::string>> constants_;
  z3::context context_;
  z3::solver solver_;
  std::map<std::string, std::vector<z3::expr>> propositions_;  ///< tuples, last place fastest
};

ModelFound find_of_sizes(const AxiomSet& axioms, const ModelWanted& wanted, const Sizes& sizes,
                         bool without_tuples, Deadline deadline) {
  if (is_over(deadline)) return {};
  return guarded_z3([&]() -> ModelFound {
    GroundModel ground(axioms, sizes);
    if (!ground.add(wanted)) return {};
    ModelFound result{ground.check(deadline), std::nullopt};
    if (result.verdict != Verdict::consistent || !without_tuples) return result;
    ground.drop_tuples(deadline);
    if (is_over(deadline)) return {};
    result.model = ground.model();
    return result;
  });
}

}  // namespace

std::map<std::string, std::vector<std::string>> declared_constants(const AxiomSet& axioms) {
  std::map<std::string, std::vector<std::string>> result;
  for (const std::string& sort : axioms.sorts()) result[sort];
  for (const auto& [name, function] : axioms.functions())
    if (function.arguments.empty() && function.result != "Bool")
      result[function.result].push_back(name);
  return result;
}

ModelFound find_model(const AxiomSet& axioms, const ModelWanted& wanted, Sizes sizes,
                      Deadline deadline) {
  ModelFound found = find_of_sizes(axioms, wanted, sizes, false, deadline);
  if (found.verdict != Verdict::consistent) return found;
  const auto constants = declared_constants(axioms);
  for (auto& [sort, size] : sizes) {
    const std::size_t least =
        axioms.has_unique_names(sort) ? std::max<std::size_t>(1, constants.at(sort).size()) : 1;
    while (size > least) {
      --size;
      if (find_of_sizes(axioms, wanted, sizes, false, deadline).verdict == Verdict::consistent)
        continue;
      ++size;
      break;
    }
  }
  return find_of_sizes(axioms, wanted, sizes, true, deadline);
}

}  // namespace asterism
