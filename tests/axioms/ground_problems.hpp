#pragma once

#include <string>
#include <vector>

namespace asterism {

/// A few facts, separated by commas, that are refuted; or from which a goal follows.
struct GroundProblem {
  std::string facts;
  std::string goal = "";  ///< a formula about q and r; empty: the facts are to be refuted
  std::string q = "q";    ///< the dstates that the goal means
  std::string r = "r";
};

/// A problem that is decided with this axiom, and not with all others.
/// @throws std::out_of_range if there is none for it
GroundProblem only_decided_by(const std::string& axiom);

/// An axiom that says less.
struct Weakening {
  std::string axiom;
  std::string lost;       ///< what it no longer says
  std::string formula;    ///< says the rest
  GroundProblem problem;  ///< decided in full, and not without what was lost
  /// Where the others imply what was lost: the premise as facts about q, r, s, t, and the two of
  /// these that are then equal. There is no problem then.
  std::string premise = "";
  std::string equal = "";
};

const std::vector<Weakening>& weakenings();

/// The premise of a weakening that is implied holds, and what was lost does not: once for each way
/// to bind q, r, s, t to dstates.
std::vector<GroundProblem> ways_to_fail(const Weakening& weakening);

}  // namespace asterism
