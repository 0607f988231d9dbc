#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "axioms/fact.hpp"
#include "core/experience.hpp"
#include "core/ssh_map.hpp"

namespace asterism {

/// An experience of the basic SSH in numbers, and as facts for the axioms.
///
/// Dstates of a hypothesis are numbered by first view. To the axioms the dstate first experienced
/// at view 3 is the constant d3_0, so that names stand for the same whatever comes later; v2 is the
/// view numbered 2, and a2 the first turn that is no turn-around.
class SshTable {
 public:
  using ActionNumber = std::uint32_t;
  static constexpr ActionNumber travel = 0;
  static constexpr ActionNumber turn_around = 1;

  /// @throws std::invalid_argument if the experience is not valid
  /// @throws Error                 if it has more views than the engine can hold
  explicit SshTable(Experience experience);

  const Experience& experience() const { return experience_; }
  std::size_t views() const { return views_.size(); }
  /// Number of view k: equal views have equal ones.
  std::uint32_t view(std::size_t k) const { return views_[k]; }
  /// Number of the action that leads from view k to the next.
  ActionNumber action(std::size_t k) const { return actions_[k]; }

  /// Which actions are turns.
  std::vector<Fact> general_facts() const;
  /// What the last of these views adds, if they were seen at these dstates: that it was seen there,
  /// and what the action before it led to.
  std::vector<Fact> step_facts(std::span<const DStateId> dstates) const;

  /// The view is seen at the dstate first experienced at view `first`.
  Fact sees(std::size_t first, std::size_t view) const;
  /// Action `k` leads from one dstate to another, told by where they were first experienced.
  Fact leads(std::size_t from, std::size_t k, std::size_t to) const;

 private:
  Experience experience_;
  std::vector<std::uint32_t> views_;
  std::vector<ActionNumber> actions_;
  std::size_t different_actions_ = 2;
};

/// The view at which each dstate was first experienced.
std::vector<std::size_t> first_views(std::span<const DStateId> dstates);

}  // namespace asterism
