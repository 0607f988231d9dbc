#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/id.hpp"
#include "core/stop.hpp"
#include "engine/tree/map_tree.hpp"
#include "engine/tree/preorder.hpp"

namespace asterism {

/// The tree of hypotheses, of either kind of trace: level k is visit k, or view k of the basic SSH.
/// Branches that died out are forgotten.
///
/// An engine says which children a hypothesis has. It follows one hypothesis at a time:
///   reset(stop)                   begins again with the empty one
///   for_each_child(k, f)          calls f(choice, step) for each way to explain level k
///   step(k, choice)               how level k is explained by a choice that is known to do so
///   enter(k, choice, step), leave(k, choice, step)   goes on to that child, and back
///   follow(k, choice, step)       how far no choice is left from there
///   arrived(k)                    what level k was explained by, where it left no choice
///   children_between_questions    so many take it some milliseconds
/// For one thread at a time.
///
/// @tparam Choice  what a level chooses: the arm entered by, the dstate
template <class Choice>
class GrowingTree {
 public:
  /// Grows the tree up to so many levels, in one pass. Where growth stops early, the tree is left
  /// as it was.
  /// @param most  hypotheses that a level may hold
  /// @param stop  told of the level in work and the hypotheses found so far on it
  /// @param told  told.child(k, choice, step) of each child of the hypothesis followed, and
  ///              told.leaf(k, choice, step) of each that reaches the last level, in order
  template <class E, class Told>
  MapTree::Growth grow(E& engine, std::size_t levels, std::uint64_t most, const Stop& stop,
                       Told& told) {
    return Pass<E, Told>(*this, engine, levels, most, stop, told).run();
  }

  const Preorder<Choice>& nodes() const { return nodes_; }
  std::size_t levels() const { return per_level_.size(); }
  /// How many hypotheses explained each level.
  std::span<const std::uint64_t> per_level() const { return per_level_; }

 private:
  template <class E, class Told>
  class Pass;

  Preorder<Choice> nodes_;
  std::vector<std::uint64_t> per_level_;
};

/// Walks the tree depth first with an engine that follows each step, and at each leaf goes on into
/// the new levels. What does not reach the last of them is taken back.
template <class Choice>
template <class E, class Told>
class GrowingTree<Choice>::Pass {
 public:
  Pass(GrowingTree& growing, E& engine, std::size_t levels, std::uint64_t most, const Stop& stop,
       Told& told)
      : growing_(growing),
        engine_(engine),
        stop_(stop),
        told_(told),
        old_(growing.nodes_.nodes()),
        levels_before_(growing.levels()),
        levels_(levels),
        most_(most),
        per_level_(growing.per_level_) {
    per_level_.resize(levels_, 0);
  }

  MapTree::Growth run() {
    engine_.reset(stop_);
    if (levels_before_ == 0)
      grow(VisitId(0));
    else if (!old_.empty())
      replay(VisitId(0));
    if (growth_ == Growth::complete && has_too_many()) growth_ = Growth::too_many;
    if (growth_ != Growth::complete) return growth_;
    next_.shrink();
    growing_.nodes_ = std::move(next_);
    growing_.per_level_ = std::move(per_level_);
    return growth_;
  }

 private:
  using Growth = MapTree::Growth;
  using Tree = Preorder<Choice>;

  bool replay(VisitId k) {
    typename Tree::Siblings siblings(next_, levels_);
    for (bool more = true; more && growth_ == Growth::complete;) {
      const typename Tree::Node node = old_[at_++];
      more = node.has_next_sibling();
      const auto step = engine_.step(k, node.choice());
      siblings.begin(node.choice());
      engine_.enter(k, node.choice(), step);
      const bool lives = k.index() + 1 < levels_before_ ? replay(k.next()) : grow(k.next());
      engine_.leave(k, node.choice(), step);
      lives ? siblings.keep() : siblings.take_back();
    }
    return siblings.any();
  }

  bool grow(VisitId k) {
    if (k.index() + 1 == levels_) return grow_leaves(k);
    typename Tree::Siblings siblings(next_, levels_);
    engine_.for_each_child(k, [&](Choice choice, auto step) {
      if (growth_ != Growth::complete) return;
      if (--until_question_ == 0) ask(k);
      const auto [end, lives] = engine_.follow(k, choice, step);
      told_.child(k, choice, step);
      for (const VisitId level : IdRange(k, end)) ++per_level_[level.index()];
      if (!lives) return;
      siblings.begin(choice);
      for (const VisitId level : IdRange(k.next(), end)) siblings.add_below(engine_.arrived(level));
      if (end.index() == levels_) {
        told_.leaf(k, choice, step);
        return siblings.keep();
      }
      engine_.enter(k, choice, step);
      const bool any = grow(end);
      engine_.leave(k, choice, step);
      any ? siblings.keep() : siblings.take_back();
    });
    return siblings.any();
  }

  /// The last level, which nothing follows: the one with most hypotheses, so made short.
  bool grow_leaves(VisitId k) {
    if (--until_question_ == 0) ask(k);
    std::uint64_t leaves = 0;
    engine_.for_each_child(k, [&](Choice choice, auto step) {
      next_.add_leaf(choice);
      told_.child(k, choice, step);
      told_.leaf(k, choice, step);
      ++leaves;
    });
    if (leaves == 0) return false;
    next_.end_leaves();
    per_level_[k.index()] += leaves;
    return true;
  }

  bool has_too_many() const {
    return std::ranges::any_of(per_level_, [&](auto n) { return n > most_; });
  }

  /// Is it to go on?
  void ask(VisitId level) {
    until_question_ = E::children_between_questions;
    if (has_too_many())
      growth_ = Growth::too_many;
    else if (stop_.is_due({.visit = level.index(), .maps = per_level_[level.index()]}))
      growth_ = Growth::stopped;
  }

  GrowingTree& growing_;
  E& engine_;
  const Stop& stop_;
  Told& told_;
  std::span<const typename Tree::Node> old_;
  std::size_t at_ = 0;  ///< in old_
  std::size_t levels_before_;
  std::size_t levels_;
  std::uint64_t most_;
  std::uint64_t until_question_ = E::children_between_questions;
  Growth growth_ = Growth::complete;

  Tree next_;
  std::vector<std::uint64_t> per_level_;
};

}  // namespace asterism
