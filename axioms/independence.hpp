#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axioms/axiom_set.hpp"
#include "axioms/finite_model.hpp"
#include "axioms/ground_proof.hpp"
#include "core/stop.hpp"

namespace asterism {

/// Whether axioms leave it open that a sentence fails.
struct Independence {
  /// Whether the sentence can fail.
  enum class Kind { independent, implied, undecided };
  Kind kind = Kind::undecided;

  /// Where it is independent: a model of the others in which it fails.
  std::optional<FiniteModel> model = {};
  /// Where in the model it fails: an element for each of its variables.
  std::vector<std::string> failure = {};

  /// Where it is implied: instances of the others, of the terms that its variables name, that
  /// cannot hold together where it fails. None of them can be spared.
  std::vector<AxiomInstance> proof = {};
};

/// Whether one axiom of the set says what all the others do not.
///
/// First Z3 is asked for a proof, all axioms written out for the variables of this one as constants
/// that may be equal; then for a finite model. A model is checked again by plain evaluation, a
/// proof by a fresh solver. One of the two is found for axioms like the shipped: variables of
/// dstates, actions and views have no other instances. Both take it that turns are turns, as every
/// trace tells, and where there is a model of usual_sentences(), it is one.
///
/// An axiom said by the signature holds wherever the sort of model is right, so that the question
/// is put with its function read as a relation: the model has a dstate of two values. That of what
/// is no function of one argument is undecided.
///
/// @pre  the axiom is one of the set
Independence independence(const Axiom& axiom, const AxiomSet& axioms, Deadline deadline);

/// Whether the axioms leave it open that a sentence fails, which is none of them.
/// @param total     relations that are to hold of every dstate of the model, with something
/// @param dstates   of the model, where the sentence has fewer variables
Independence independence_from_all(const Axiom& sentence, const AxiomSet& axioms,
                                   const std::vector<std::string>& total, std::size_t dstates,
                                   Deadline deadline);

/// A model in which a travel leads from one place to another, as far as there can be each dstate
/// having its view, its next arm and its opposite; or the proof that there is none.
Independence model_with_travel(const AxiomSet& axioms, Deadline deadline);

}  // namespace asterism
