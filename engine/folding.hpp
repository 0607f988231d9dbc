#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/assumption.hpp"
#include "core/verdict.hpp"
#include "engine/arm_table.hpp"
#include "engine/native.hpp"

namespace asterism {

/// A trace as one big map, folded wherever two of its visits turn out to have been to one place.
///
/// Begins with a place for each visit, each joined to the next. To *identify* two arms makes their
/// places one, star on star, and what follows: a gateway that both places left leads to one arm, so
/// those two are identified as well, however much later in the trace they were seen (deterministic,
/// reversible). Where that meets a contradiction, no map has the two arms one.
///
/// A *settled* place differs from all others that are settled; a map is a folding all of whose
/// places are settled. Every step is undone in reverse order.
class Folding {
 public:
  static constexpr ArmIndex none = std::numeric_limits<ArmIndex>::max();
  using Mark = std::size_t;

  /// @param axioms  which of those that are optional hold, and whether maps are planar
  Folding(const ArmTable& table, NativeEngine::Options axioms);

  /// Folds the trace as its travels alone demand, and finds for every two visits and arms whether
  /// they can be one.
  /// @param before  of fewer visits of the trace and no more assumptions, nothing settled: what is
  ///                known from there; may be null
  /// @param go_on   asked every few milliseconds
  /// @return inconsistent if the trace, or what is assumed, contradicts itself; undecided if
  ///         `go_on` said no: to be begun again
  Verdict begin(std::span<const Assumption> assumptions, const Folding* before,
                const std::function<bool()>& go_on);

  /// @return false at a contradiction; what was done until then is to be undone
  bool identify(ArmIndex x, ArmIndex y);
  /// The place of this arm differs from all that are settled.
  /// @return false at a contradiction, also if it is settled
  bool settle(ArmIndex arm);

  Mark mark() const { return done_.size(); }
  void undo(Mark mark);

  /// The arm that stands for all that are identified with this one.
  ArmIndex representative(ArmIndex arm) const {
    for (ArmIndex visit = table_.visit_of(arm); above_[visit] != none; visit = table_.visit_of(arm))
      arm = table_.clockwise(above_[visit], arm - table_.first_arm(visit));
    return arm;
  }
  /// The visit that stands for all that were at its place.
  ArmIndex representative_visit(ArmIndex visit) const {
    while (above_[visit] != none) visit = table_.visit_of(above_[visit]);
    return visit;
  }
  bool represents(ArmIndex visit) const { return above_[visit] == none; }
  bool is_settled(ArmIndex visit) const { return settled_[visit]; }
  /// The visits that stand for the settled places, in the order of settling.
  std::span<const ArmIndex> settled() const { return settled_list_; }
  /// Visits known to be at the place of a representative.
  ArmIndex visits_there(ArmIndex visit) const { return visits_there_[visit]; }

  /// The arm across the travel from a representative's arm, or none.
  ArmIndex across(ArmIndex arm) const {
    return across_[arm] == none ? none : representative(across_[arm]);
  }

  /// Whether nothing known forbids that two representatives' arms are one.
  bool may_be_one(ArmIndex x, ArmIndex y) const { return has(x, y) && has(y, x); }
  /// Calls f(y) for each arm y of settled places that may be one with x; f returns whether to go
  /// on.
  template <class F>
  void for_each_settled(ArmIndex x, F&& f) const {
    const std::uint64_t* const row = &may_be_[x * words_];
    for (std::size_t w = 0; w < words_; ++w)
      for (std::uint64_t arms = row[w] & settled_arms_[w]; arms != 0; arms &= arms - 1) {
        const auto y =
            static_cast<ArmIndex>(w * 64 + static_cast<unsigned>(std::countr_zero(arms)));
        if (has(y, x) && !f(y)) return;
      }
  }
  /// Planar maps alone: numbers the faces between settled places, for the two questions below.
  void number_faces();
  /// Whether the place of x, joined to settled places, can be that of y without crossing a segment
  /// of settled places.
  bool may_stand_at(ArmIndex x, ArmIndex y) const;
  /// ... or be another than all that are settled.
  bool may_stand_apart(ArmIndex x) const;
  /// Whether some of the arms in a set, of places not settled, may be one with x, of a settled one.
  bool may_be_any(ArmIndex x, std::span<const std::uint64_t> arms) const {
    const std::uint64_t* const row = &may_be_[x * words_];
    for (std::size_t w = 0; w < words_; ++w)
      for (std::uint64_t rest = row[w] & arms[w]; rest != 0; rest &= rest - 1) {
        const auto y =
            static_cast<ArmIndex>(w * 64 + static_cast<unsigned>(std::countr_zero(rest)));
        if (has(y, x) && may_stand_at(y, x)) return true;
      }
    return false;
  }
  std::size_t words() const { return words_; }

  /// The data association, once all places are settled: the arm by which visit k was entered, as
  /// an arm of the place's first visit.
  std::vector<ArmIndex> named() const;

  std::size_t memory_bytes() const;

 private:
  struct Done {
    enum class Kind : std::uint32_t { united, joined, narrowed, settled } kind;
    ArmIndex arm;    ///< or visit, of what is one of another's, or settled
    ArmIndex other;  ///< united: the visit above
  };

  bool has(ArmIndex x, ArmIndex y) const {
    return (may_be_[x * words_ + y / 64] >> (y % 64) & 1) != 0;
  }
  bool contradicts(ArmIndex x, ArmIndex y) const;
  bool go_on_identifying();
  void unite(ArmIndex x, ArmIndex y);
  void forbid(ArmIndex x, ArmIndex y);
  bool join(ArmIndex x, ArmIndex y);
  void know(const Folding& before);
  bool differ_as_assumed() const;
  bool paths_are_lines(ArmIndex visit);
  bool is_line(ArmIndex arm);
  bool settled_places_agree();
  bool settled_places_are_planar();
  bool settled_places_are_joined_once() const;
  bool settled_paths_cross_once();
  ArmIndex across_settled(ArmIndex arm) const {
    const ArmIndex to = across(arm);
    return to == none || !settled_[table_.visit_of(to)] ? none : to;
  }
  std::uint32_t new_stamp();

  const ArmTable& table_;
  NativeEngine::Options axioms_;
  std::vector<std::pair<ArmIndex, ArmIndex>> same_;    ///< visits assumed to be at one place
  std::vector<std::pair<ArmIndex, ArmIndex>> differ_;  ///< ... at two
  std::size_t words_;                                  ///< of a set of arms
  std::vector<ArmIndex> above_;  ///< of a visit: what its arm 0 was identified with, of another
  std::vector<ArmIndex> visits_there_;
  std::vector<ArmIndex> across_;       ///< some arm at the other end of the travel
  std::vector<std::uint64_t> may_be_;  ///< of each arm: those it may be one with
  std::vector<bool> settled_;
  std::vector<ArmIndex> settled_list_;
  std::vector<std::uint64_t> settled_arms_;
  std::vector<Done> done_;
  std::vector<std::uint64_t> narrowed_;  ///< what rows of may_be_ were, a row each time

  std::vector<std::pair<ArmIndex, ArmIndex>> to_identify_;
  std::vector<ArmIndex> changed_;    ///< visits, by what was identified last
  std::uint64_t united_ = 0;         ///< so often places became one, undone or not
  std::vector<std::uint32_t> seen_;  ///< of visits and of arms: the stamp of a pass
  std::uint32_t stamp_ = 0;
  std::vector<std::uint32_t> face_;  ///< of a settled place's gateway without settled end: where
  std::vector<std::uint32_t> part_;  ///< of a settled place: what is connected
  std::uint32_t faces_ = 0;
  bool faces_are_numbered_ = false;
};

}  // namespace asterism
