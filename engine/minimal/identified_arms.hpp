#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/id.hpp"
#include "core/id_vector.hpp"
#include "engine/arm_table.hpp"
#include "engine/bits.hpp"

namespace asterism {

/// Which arms of a trace's visits are one, which may be, and where travels lead from them.
///
/// At first each visit has a place of its own. To *unite* two arms makes the places of their visits
/// one, star on star: one visit then stands for all that were there, and its arms for theirs
/// (union-find, whose links carry how far one star is turned against the other). All that was done
/// is undone in reverse order.
class IdentifiedArms {
 public:
  using Mark = std::size_t;

  explicit IdentifiedArms(const ArmTable& table) : table_(table), words_(words_for(table.size())) {}

  /// Begins again: no two arms are one, those may be that look alike, and no travel is known.
  void reset();
  /// What could not be one in a shorter trace, told by its arms, cannot be one here.
  void know(const IdentifiedArms& shorter);
  /// A travel leads from one arm to another, as far as none is known there yet. Not to be undone.
  void join(ArmId from, ArmId to) { across_[from] = to; }
  /// Star on star, no arms of these two visits that are so aligned are one. Not to be undone.
  void forbid(ArmId x, ArmId y);
  /// What was done until now stays: there is nothing to undo.
  void keep();

  /// The place of y becomes that of x. Calls follows(a, b) for arms that travels from the united
  /// place lead to, which are therefore one as well.
  /// @pre both are representatives, of different visits
  template <class F>
  void unite(ArmId x, ArmId y, F&& follows);

  Mark mark() const { return done_.size(); }
  /// @return whether there was anything to undo
  bool undo(Mark mark);

  /// The arm that stands for all that are one with this.
  ArmId representative(ArmId arm) const {
    for (VisitId visit = table_.visit_of(arm); above_[visit] != no_arm;
         visit = table_.visit_of(arm))
      arm = table_.clockwise(above_[visit], table_.position(arm));
    return arm;
  }
  /// The visit that stands for all that were at its place.
  VisitId representative(VisitId visit) const {
    while (above_[visit] != no_arm) visit = table_.visit_of(above_[visit]);
    return visit;
  }
  /// Whether this visit stands for all that were at its place.
  bool represents(VisitId visit) const { return above_[visit] == no_arm; }
  /// Number of visits known to be at the place of a representative.
  std::uint32_t visits_there(VisitId visit) const { return visits_there_[visit]; }

  /// The arm across the travel from a representative's arm.
  OptionalArm across(ArmId arm) const {
    return across_[arm] == no_arm ? no_arm : representative(across_[arm]);
  }

  /// Whether nothing known forbids that two representatives' arms are one.
  bool may_be_one(ArmId x, ArmId y) const { return allows(x, y) && allows(y, x); }
  /// Half of that: what is known of x, and of all that it stands for.
  bool allows(ArmId x, ArmId y) const { return (row(x)[word_of(y)] & bit_of(y)) != 0; }
  /// Calls f(y) for each of a set of representatives' arms that may be one with x, until it returns
  /// false.
  template <class F>
  void for_each_that_may_be(ArmId x, std::span<const std::uint64_t> arms, F&& f) const;

  /// Words of a set of arms, a bit an arm.
  std::size_t words() const { return words_; }
  /// Bytes held, but for those that a trace of this length always takes.
  std::size_t memory_bytes() const;

 private:
  struct Done {
    enum class Kind : std::uint32_t { united, joined, narrowed } kind;
    ArmId arm;    ///< united: an arm of the visit that is now under another's
    ArmId other;  ///< united: an arm of the visit above
  };

  std::uint64_t* row(ArmId arm) { return &may_be_[arm.index() * words_]; }
  const std::uint64_t* row(ArmId arm) const { return &may_be_[arm.index() * words_]; }
  /// `arm` stands for `other` too, and may be one with no more than both may be.
  void narrow(ArmId arm, ArmId other);

  const ArmTable& table_;
  std::size_t words_;
  IdVector<VisitId, ArmId> above_;  ///< what its arm 0 was identified with, of another visit
  IdVector<VisitId, std::uint32_t> visits_there_;
  IdVector<ArmId, ArmId> across_;      ///< some arm at the other end of the travel
  std::vector<std::uint64_t> may_be_;  ///< of each arm: those it may be one with
  std::vector<Done> done_;
  std::vector<std::uint64_t> narrowed_;  ///< what rows of may_be_ were, a row each time
};

template <class F>
void IdentifiedArms::unite(ArmId x, ArmId y, F&& follows) {
  const VisitId stays = table_.visit_of(x);
  const VisitId goes = table_.visit_of(y);
  const std::uint32_t size = table_.star_size(goes);
  const ArmId above = table_.clockwise(x, (size - table_.position(y)) % size);
  above_[goes] = above;
  visits_there_[stays] += visits_there_[goes];
  done_.push_back({Done::Kind::united, y, x});
  for (std::uint32_t step = 0; step < size; ++step) {
    const ArmId a = table_.clockwise(above, step);
    const ArmId b = table_.arm(goes, step);
    narrow(a, b);
    if (across_[b] == no_arm) continue;
    if (across_[a] == no_arm) {
      across_[a] = across_[b];
      done_.push_back({Done::Kind::joined, a, no_arm});
    } else {
      follows(across_[a], across_[b]);
    }
  }
}

template <class F>
void IdentifiedArms::for_each_that_may_be(ArmId x, std::span<const std::uint64_t> arms,
                                          F&& f) const {
  const std::uint64_t* const may_be = row(x);
  for (std::size_t w = 0; w < words_; ++w)
    for (const ArmId y : IdsInWord<ArmId>(w, may_be[w] & arms[w]))
      if (allows(y, x) && !f(y)) return;
}

}  // namespace asterism
