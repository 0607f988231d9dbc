#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "axioms/theory.hpp"
#include "core/extents.hpp"
#include "core/stop.hpp"
#include "engine/arm_table.hpp"
#include "engine/bits.hpp"
#include "engine/tree/forced_run.hpp"
#include "planarity/face_lists.hpp"

namespace asterism {

/// How a visit is explained: by the segment travelled before, by a new segment to a place known, or
/// by a new segment to a new place.                                            [BMK10, Fig. 5]
enum class Step { known, closure, new_place };
/// A step known when compiling: the tree's loop is compiled for each apart.
template <Step step>
using StepConstant = std::integral_constant<Step, step>;

/// The axioms as incremental bookkeeping: one hypothesis at a time, grown and shrunk by a visit.
///
/// Holds for the shipped axioms and the optional ones, and for these alone. What each keeps:
///   reversible, deterministic: `linked_`, a matching of gateways, both ways
///   view, star, star_binding:  the view numbers of the arm table
///   path_end:                  only open gateways are ever listed as candidates
///   (3)-(10), irreflexive:     an unfinished path is known at both its ends, with the set of its
///                              places; a travel that joins two paths with a place in common would
///                              order that place before itself
/// Every step is undone by putting back what it unlinked; nothing is copied.
class NativeEngine {
 public:
  using Choice = ArmId;
  static constexpr std::uint64_t children_between_questions = 1 << 16;

  /// What it keeps beside the axioms that are always there.
  struct Rules {
    bool faces = false;  ///< every closure within one face: planarity
    bool one_segment = false;
    bool one_crossing = false;
  };

  /// @pre  the axioms are the shipped ones
  static Rules rules_of(const Theory& theory) {
    return {.faces = theory.planar,
            .one_segment = theory.axioms.contains("one_segment"),
            .one_crossing = theory.axioms.contains("one_crossing")};
  }

  NativeEngine(const ArmTable& table, Rules rules) : table_(table), rules_(rules) {}
  NativeEngine(const ArmTable& table, const Theory& theory)
      : NativeEngine(table, rules_of(theory)) {}

  /// Begins again with the empty hypothesis, and room for all visits of the arm table.
  void reset();
  void reset(const Stop&) { reset(); }  // as engines do that may be kept waiting

  /// Calls f(arm, step) for each way in which the hypothesis can explain visit k.  [BMK10, Fig. 5]
  /// Closures come in the order of arms (of the face, where planar), the new place last.
  /// @pre the hypothesis explains the visits before k
  template <class F>
  void for_each_child(VisitId k, F&& f) {
    if (is_first(k)) return f(table_.entered(k), StepConstant<Step::new_place>{});
    const ArmId x = left_[k.previous()];
    const ViewId seen = table_.seen(k);
    if (const ArmId to = linked_[x]; to != no_arm) {
      if (table_.view(to) == seen) f(to, StepConstant<Step::known>{});
      return;
    }
    if (rules_.faces) {
      for (ArmId y = faces_.next(x); y != x; y = faces_.next(y))
        if (table_.view(y) == seen && can_link(x, y)) f(y, StepConstant<Step::closure>{});
    } else {
      const std::uint64_t* const alike = &alike_[seen.index() * open_.size()];
      for (std::size_t w = 0; w < open_.size(); ++w)
        for (const ArmId y : IdsInWord<ArmId>(w, open_[w] & alike[w]))
          if (can_link(x, y)) f(y, StepConstant<Step::closure>{});
    }
    f(table_.entered(k), StepConstant<Step::new_place>{});
  }

  /// The gateway at the other end of the segment that begins in x, if there is one.
  std::optional<ArmId> across(ArmId x) const {
    return linked_[x] == no_arm ? std::nullopt : std::optional(linked_[x]);
  }
  /// Calls f(y) for each gateway of a place known to which a new segment from x may lead.
  /// @pre x is open
  template <class F>
  void for_each_closure(ArmId x, F&& f) const {
    if (rules_.faces) {
      for (ArmId y = faces_.next(x); y != x; y = faces_.next(y))
        if (can_link(x, y)) f(y);
      return;
    }
    for (std::size_t w = 0; w < open_.size(); ++w)
      for (const ArmId y : IdsInWord<ArmId>(w, open_[w]))
        if (can_link(x, y)) f(y);
  }

  /// Answers the solver owed: it asks none.
  std::uint64_t undecided() const { return 0; }

  /// How visit k is explained by coming in by `arm`.
  Step step(VisitId k, ArmId arm) const {
    if (table_.visit_of(arm) == k) return Step::new_place;
    return linked_[left_[k.previous()]] != no_arm ? Step::known : Step::closure;
  }

  /// Coming in by `arm` at visit k leaves no choice while the travels that follow are along known
  /// segments: up to visit `end`, by arms arrived(k) to arrived(end - 1). Such a travel may lead to
  /// what does not look like the visit `end`: nothing else ends a branch, since a new place is
  /// always possible.  Looks before enter(k, arm, step).
  [[gnu::always_inline]] ForcedRun follow(VisitId k, ArmId arm, Step step) {
    // The segment between x and y is one that enter() will make.
    const ArmId x = step == Step::known || is_first(k) ? no_arm : left_[k.previous()];
    const ArmId y = x == no_arm ? no_arm : arm;
    while (true) {
      arrived_[k] = arm;
      const ArmId left = left_[k] = table_.left(k, arm);
      k = k.next();
      if (k.index() == arrived_.size()) return {k, true};
      const ArmId to = left == x ? y : left == y ? x : linked_[left];
      if (to == no_arm) return {k, true};
      if (table_.view(to) != table_.seen(k)) return {k, false};
      arm = to;
    }
  }
  ArmId arrived(VisitId k) const { return arrived_[k]; }

  /// Visit k was entered by `arm`.
  [[gnu::always_inline]] void enter(VisitId k, ArmId arm, Step step) {
    left_[k] = table_.left(k, arm);
    if (step == Step::new_place) open_place(k);
    if (step == Step::known || is_first(k)) return;
    const ArmId x = left_[k.previous()];
    if (rules_.faces) {
      if (step == Step::new_place)
        faces_.replace(x, table_.gateways_after_entered(k));
      else
        faces_.close(x, arm);
    }
    link(x, arm);
  }

  /// Undoes enter(k, arm, step).
  [[gnu::always_inline]] void leave(VisitId k, ArmId arm, Step step) {
    if (step == Step::known) return;
    if (!is_first(k)) {
      const ArmId x = left_[k.previous()];
      unlink(x, arm);
      if (rules_.faces) {
        if (step == Step::new_place)
          faces_.undo_replace(x);
        else
          faces_.undo_close(x, arm);
      }
    }
    if (step == Step::new_place) close_place(k);
  }

  /// What the extents are after enter(k, arm, step).
  Extents extents_after(VisitId k, ArmId, Step step) const {
    Extents after = extents_;
    if (step == Step::new_place) ++after.places, after.paths += table_.star_size(k) / 2;
    if (step != Step::known && !is_first(k)) ++after.segments, --after.paths;
    return after;
  }

 private:
  static bool is_first(VisitId k) { return k.index() == 0; }
  bool can_link(ArmId x, ArmId y) const {
    if (words_ == 1) {
      if (places_[x.index()] & places_[y.index()]) return false;
    } else if (have_common_place(x, y)) {
      return false;
    }
    return !(rules_.one_segment && joined(table_.visit_of(x), table_.visit_of(y))) &&
           !(rules_.one_crossing && crossed(x, y));
  }
  bool have_common_place(ArmId x, ArmId y) const {
    for (std::size_t w = 0; w < words_; ++w)
      if (places(x)[w] & places(y)[w]) return true;
    return false;
  }
  bool joined(VisitId place, VisitId other_place) const;
  bool crossed(ArmId x, ArmId y) const;
  template <class F>
  void for_each_crossing(ArmId end, F&& f) const;
  ArmId end_of_path(ArmId arm) const;

  // A new place: every local-path is a path of its own, as reset() left it, every gateway open.
  void open_place(VisitId k) {
    if (!rules_.faces)
      for (std::size_t i = first_part_[k]; i < first_part_[k.next()]; ++i)
        open_[parts_[i].word] |= parts_[i].gateways;
    else if (is_first(k))
      faces_.open(table_.gateways(k));
    ++extents_.places;
    extents_.paths += table_.star_size(k) / 2;
  }
  void close_place(VisitId k) {
    if (!rules_.faces)
      for (std::size_t i = first_part_[k]; i < first_part_[k.next()]; ++i)
        open_[parts_[i].word] &= ~parts_[i].gateways;
    --extents_.places;
    extents_.paths -= table_.star_size(k) / 2;
  }
  void mark_open(ArmId gateway) { open_[word_of(gateway)] |= bit_of(gateway); }
  void mark_closed(ArmId gateway) { open_[word_of(gateway)] &= ~bit_of(gateway); }

  std::uint64_t* places(ArmId end) { return &places_[end.index() * words_]; }
  const std::uint64_t* places(ArmId end) const { return &places_[end.index() * words_]; }

  // A segment joins the paths that end in x and in y into one, ending at their far ends.
  void link(ArmId x, ArmId y) {
    linked_[x] = y;
    linked_[y] = x;
    if (!rules_.faces) {
      mark_closed(x);
      mark_closed(y);
    }
    const ArmId a = far_end_[x];
    const ArmId b = far_end_[y];
    far_end_[a] = b;
    far_end_[b] = a;
    if (words_ == 1) {
      places_[a.index()] = places_[b.index()] = places_[x.index()] | places_[y.index()];
    } else {
      for (std::size_t w = 0; w < words_; ++w)
        places(a)[w] = places(b)[w] = places(x)[w] | places(y)[w];
    }
    --extents_.paths;
    ++extents_.segments;
  }
  // x and y still know the paths that ended in them.
  void unlink(ArmId x, ArmId y) {
    linked_[x] = linked_[y] = no_arm;
    if (!rules_.faces) {
      mark_open(x);
      mark_open(y);
    }
    const ArmId a = far_end_[x];
    const ArmId b = far_end_[y];
    far_end_[a] = x;
    far_end_[b] = y;
    if (words_ == 1) {
      places_[a.index()] = places_[x.index()];
      places_[b.index()] = places_[y.index()];
    } else {
      for (std::size_t w = 0; w < words_; ++w) {
        places(a)[w] = places(x)[w];
        places(b)[w] = places(y)[w];
      }
    }
    ++extents_.paths;
    --extents_.segments;
  }

  /// The gateways of one place that share a word of `open_`.
  struct Part {
    std::size_t word;
    std::uint64_t gateways;
  };

  const ArmTable& table_;
  Rules rules_;
  Extents extents_;
  std::size_t words_ = 1;              ///< of a set of places, a bit a visit
  IdVector<VisitId, ArmId> arrived_;   ///< arm by which it was entered, in the run followed last
  IdVector<VisitId, ArmId> left_;      ///< arm by which it was left
  IdVector<ArmId, ArmId> linked_;      ///< gateway at the other end of the segment
  IdVector<ArmId, ArmId> far_end_;     ///< of an end of a path: its other end
  std::vector<std::uint64_t> places_;  ///< of an end of a path: the places of the path
  std::vector<std::uint64_t> open_;    ///< gateways without a segment, a bit an arm; not if planar
  std::vector<Part> parts_;            ///< of the places of all visits
  IdVector<VisitId, std::size_t> first_part_;  ///< of a visit; one more at the end
  std::vector<std::uint64_t> alike_;           ///< for each view, the arms that show it
  FaceLists<ArmId> faces_;
};

}  // namespace asterism
