#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "axioms/axiom_set.hpp"
#include "axioms/finite_model.hpp"
#include "core/stop.hpp"
#include "core/verdict.hpp"

namespace asterism {

/// What a model is to be like.
struct ModelWanted {
  std::vector<const Axiom*> hold;  ///< none of them said by the signature
  const Axiom* fails = nullptr;    ///< one more, not said by the signature either, or none
  /// A function that is to be a relation, of two values somewhere; empty: none.
  std::string no_function = {};
  /// Relations that hold of every element in their first place, with some others in the rest.
  std::vector<std::string> total = {};
};

/// The answer to a search for a model.
struct ModelFound {
  Verdict verdict = Verdict::undecided;  ///< whether there is a model of these sizes
  std::optional<FiniteModel> model;
};

/// A finite model, made as small as it can be from there: of no sort is there an element, of no
/// relation a tuple that could be left out alone. Z3 finds it, all being ground: one proposition a
/// tuple, and one a value of a function's argument.
///
/// Elements of a sort with unique names are called by the constants declared, then numbered.
///
/// @param sizes  elements of each sort to begin with: at least one, and one a constant named apart
/// @return  undecided past the deadline, or where there is too much to ground
ModelFound find_model(const AxiomSet& axioms, const ModelWanted& wanted,
                      std::map<std::string, std::size_t> sizes, Deadline deadline);

/// The constants of each sort that the set declares.
std::map<std::string, std::vector<std::string>> declared_constants(const AxiomSet& axioms);

}  // namespace asterism
