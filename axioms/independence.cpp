#include "axioms/independence.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "axioms/model_finder.hpp"
#include "axioms/sentences.hpp"

namespace asterism {
namespace {

using Sizes = std::map<std::string, std::size_t>;

/// How many elements there may be of a sort that functions make: first few, then more.
constexpr std::size_t sizes_of_made_sorts[]{2, 4, 8};

/// All axioms but one that assertions say.
std::vector<const Axiom*> assertions_but(const Axiom* one, const AxiomSet& axioms) {
  std::vector<const Axiom*> result;
  for (const Axiom& axiom : axioms.axioms())
    if (&axiom != one && !axiom.by_signature) result.push_back(&axiom);
  return result;
}

/// Sizes that leave room for a sentence to fail: an element for each of its variables.
Sizes first_sizes(const AxiomSet& axioms, const Axiom& sentence, std::size_t dstates) {
  Sizes sizes;
  for (const auto& [sort, names] : declared_constants(axioms)) {
    const auto variables =
        std::count_if(sentence.variables.begin(), sentence.variables.end(),
                      [&, &sort = sort](const auto& variable) { return variable.sort == sort; });
    sizes[sort] = std::max<std::size_t>(1, names.size() + static_cast<std::size_t>(variables));
  }
  sizes["DState"] = std::max(sizes["DState"], dstates);
  return sizes;
}

/// A model is what it is said to be, by evaluation alone.
/// @throws std::logic_error if it is not
void check_model(const AxiomSet& axioms, const ModelWanted& wanted, const FiniteModel& model) {
  bool is_right = true;
  for (const Axiom* axiom : wanted.hold) is_right &= !failure_of(*axiom, axioms, model);
  if (wanted.fails != nullptr) is_right &= failure_of(*wanted.fails, axioms, model).has_value();
  for (const auto& [name, values] : model.functions)
    is_right &= failure_of_function(name, model).has_value() == (name == wanted.no_function);
  if (!is_right) throw std::logic_error("a model found by the solver does not stand evaluation");
}

/// The elements that the sentence's variables stand for where it fails.
std::vector<std::string> failure_text(const Axiom& sentence, const AxiomSet& axioms,
                                      const FiniteModel& model) {
  std::vector<std::string> result;
  if (sentence.by_signature) {
    const std::string& sort = axioms.functions().at(sentence.function).arguments.front();
    result.push_back(model.elements.at(sort)[*failure_of_function(sentence.function, model)]);
    return result;
  }
  const auto binding = failure_of(sentence, axioms, model).value();
  for (std::size_t i = 0; i < binding.size(); ++i)
    result.push_back(model.elements.at(sentence.variables[i].sort)[binding[i]]);
  return result;
}

/// As small as there is one, and if it can be, as usual_sentences() have it.
std::optional<FiniteModel> model_of(const Axiom& sentence, const AxiomSet& axioms,
                                    const ModelWanted& wanted, std::size_t dstates,
                                    Deadline deadline) {
  const std::vector<Axiom> usual = usual_sentences(axioms);
  ModelWanted usual_wanted = wanted;
  for (const Axiom& other : usual) usual_wanted.hold.push_back(&other);
  for (const ModelWanted* const kind : {&std::as_const(usual_wanted), &wanted}) {
    Sizes sizes = first_sizes(axioms, sentence, dstates);
    for (const std::size_t size : sizes_of_made_sorts) {
      for (auto& [sort, elements] : sizes)
        if (!axioms.has_unique_names(sort)) elements = std::max(elements, size);
      const ModelFound found = find_model(axioms, *kind, sizes, deadline);
      if (!found.model) continue;
      check_model(axioms, *kind, *found.model);
      return found.model;
    }
  }
  return std::nullopt;
}

Independence search(const Axiom& sentence, const AxiomSet& axioms, ModelWanted wanted,
                    std::size_t dstates, Deadline deadline) {
  const Axiom turns = turns_are_turns(axioms);
  wanted.hold.push_back(&turns);
  Independence result;
  if (is_over(deadline)) return result;
  if (!sentence.by_signature)
    if (auto proof = ground_proof(sentence, axioms, wanted.hold, milliseconds_until(deadline))) {
      result.kind = Independence::Kind::implied;
      result.proof = std::move(*proof);
      return result;
    }
  result.model = model_of(sentence, axioms, wanted, dstates, deadline);
  if (result.model) {
    result.kind = Independence::Kind::independent;
    result.failure = failure_text(sentence, axioms, *result.model);
  }
  return result;
}

}  // namespace

Independence independence(const Axiom& axiom, const AxiomSet& axioms, Deadline deadline) {
  ModelWanted wanted{.hold = assertions_but(&axiom, axioms)};
  if (!axiom.by_signature) {
    wanted.fails = &axiom;
  } else {
    const auto& function = axioms.functions().at(axiom.function);
    if (function.arguments.size() != 1 || function.result == "Bool") return {};
    wanted.no_function = axiom.function;
  }
  return search(axiom, axioms, std::move(wanted), 0, deadline);
}

Independence independence_from_all(const Axiom& sentence, const AxiomSet& axioms,
                                   const std::vector<std::string>& total, std::size_t dstates,
                                   Deadline deadline) {
  return search(sentence, axioms,
                {.hold = assertions_but(nullptr, axioms), .fails = &sentence, .total = total},
                dstates, deadline);
}

Independence model_with_travel(const AxiomSet& axioms, Deadline deadline) {
  const Axiom no_travel = no_travel_between_places(axioms);
  // Two dead ends with a travel between them have four arms.
  const Independence full =
      independence_from_all(no_travel, axioms, {"sees", "next", "opposite"}, 4, deadline);
  if (full.kind != Independence::Kind::undecided) return full;
  return independence_from_all(no_travel, axioms, {}, 2, deadline);
}

}  // namespace asterism
