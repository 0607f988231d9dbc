#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "axioms/axiom_set.hpp"

namespace asterism {

/// A finite structure in the vocabulary of an axiom set: what there is of each sort, and what holds
/// of it. Elements are numbered from 0 within their sort.
struct FiniteModel {
  std::map<std::string, AxiomSet::Function> signature;       ///< of functions and relations
  std::map<std::string, std::vector<std::string>> elements;  ///< names, by sort
  /// Values by argument; a constant is a function of the one argument 0. Each is one value, but for
  /// a function that a model is to have as a mere relation.
  std::map<std::string, std::vector<std::vector<std::size_t>>> functions;
  std::map<std::string, std::set<std::vector<std::size_t>>> relations;  ///< tuples that hold
};

/// Where an axiom fails in a model: an element for each of its variables, in order; nothing if it
/// holds. Plain evaluation over all elements, with no solver.
///
/// A term f(t) means every value that f has there: with more than one, the axiom is to hold for
/// each, as if it said "for all x with f(t) = x". For functions that changes nothing.
///
/// @pre  the model has all that the axiom names, and the axiom is not said by the signature
std::optional<std::vector<std::size_t>> failure_of(const Axiom& axiom, const AxiomSet& axioms,
                                                   const FiniteModel& model);

/// An argument for which a function has not just one value; nothing if it is a function.
std::optional<std::size_t> failure_of_function(const std::string& function,
                                               const FiniteModel& model);

/// In one line: functions, then relations, without those that hold of nothing and the constants
/// that elements are called by.
///   "place: q0 → p0, q1 → p1; leads: q0 travel q1; order: q0 q1"
std::string model_text(const FiniteModel& model);

/// Whether this is a constant, and its element is called by it.
bool is_own_name(const std::string& function, const FiniteModel& model);

/// The distinct terms of an axiom that are no variables and stand for no constant named apart,
/// each after its argument.
std::vector<const Term*> terms_with_values(const Axiom& axiom, const AxiomSet& axioms);

}  // namespace asterism
