#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "axioms/fact.hpp"
#include "core/verdict.hpp"

namespace asterism {

/// The shipped axioms written out in C++ as Horn clauses, and run until nothing is new: judges the
/// axiom files and all that reads them.                                         [theory §5]
///
/// What is said of paths (travel, turn_around, on, order_on) derives equalities of directed paths
/// and atoms of `on`, from which nothing else follows, so it is left out.
class ForwardChaining {
 public:
  explicit ForwardChaining(std::span<const Fact> facts);
  Verdict verdict();

 private:
  using DState = std::string;

  bool derive();
  bool is_contradictory() const;
  DState place(DState dstate) const;
  std::size_t size() const {
    return leads_.size() + opposite_.size() + order_.size() + places_.size();
  }

  std::set<std::tuple<DState, std::string, DState>> leads_;
  std::set<std::pair<DState, std::string>> sees_;
  std::set<std::string> turns_;
  std::set<std::pair<DState, DState>> next_;
  std::set<std::pair<DState, DState>> opposite_;
  std::set<std::pair<DState, DState>> order_;
  std::set<DState> ends_;
  std::map<DState, DState> places_;  ///< a dstate at the same place, towards the one that names it
};

}  // namespace asterism
