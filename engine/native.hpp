#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include "axioms/axiom_set.hpp"
#include "engine/arm_table.hpp"
#include "planarity/face_lists.hpp"

namespace asterism {

/// Sizes of the extents that a preference may minimise.                           [DESIGN §6]
struct Extents {
  std::uint32_t paths = 0;
  std::uint32_t places = 0;
  std::uint32_t segments = 0;
};

/// ... of a map written out, as counted.
inline Extents extents_of(const TopologicalMap& map) {
  const auto size = [](const auto& list) { return static_cast<std::uint32_t>(list.size()); };
  return {.paths = size(map.paths), .places = size(map.places), .segments = size(map.segments)};
}

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
  struct Options {
    bool planar = false;
    bool one_segment = false;
    bool one_crossing = false;
  };

  /// ... for the axioms switched on among these.
  static Options options(const AxiomSet& axioms, bool planar) {
    return {.planar = planar,
            .one_segment = axioms.contains("one_segment"),
            .one_crossing = axioms.contains("one_crossing")};
  }

  NativeEngine(const ArmTable& table, Options options) : table_(table), options_(options) {}

  /// Begins again with the empty hypothesis, and room for all visits of the arm table.
  void reset();

  /// Calls f(arm, step) for each way in which the hypothesis can explain visit k.  [BMK10, Fig. 5]
  /// Closures come in the order of arms (of the face, where planar), the new place last.
  /// @pre the hypothesis explains the visits before k
  template <class F>
  void for_each_child(std::size_t k, F&& f) {
    if (k == 0) return f(table_.entered(0), StepConstant<Step::new_place>{});
    const ArmIndex x = left_[k - 1];
    const ArmIndex seen = table_.seen(k);
    if (const ArmIndex to = linked_[x]; to != none) {
      if (table_.view(to) == seen) f(to, StepConstant<Step::known>{});
      return;
    }
    if (options_.planar) {
      for (ArmIndex y = faces_.next(x); y != x; y = faces_.next(y))
        if (table_.view(y) == seen && can_link(x, y)) f(y, StepConstant<Step::closure>{});
    } else {
      const std::uint64_t* const alike = &alike_[seen * open_.size()];
      for (std::size_t w = 0; w < open_.size(); ++w)
        for (std::uint64_t open = open_[w] & alike[w]; open != 0; open &= open - 1) {
          const auto y =
              static_cast<ArmIndex>(w * 64 + static_cast<unsigned>(std::countr_zero(open)));
          if (can_link(x, y)) f(y, StepConstant<Step::closure>{});
        }
    }
    f(table_.entered(k), StepConstant<Step::new_place>{});
  }

  /// The gateway at the other end of the segment that begins in x, if there is one.
  std::optional<ArmIndex> across(ArmIndex x) const {
    return linked_[x] == none ? std::nullopt : std::optional(linked_[x]);
  }
  /// Calls f(y) for each gateway of a place known to which a new segment from x may lead.
  /// @pre x is open
  template <class F>
  void for_each_closure(ArmIndex x, F&& f) const {
    if (options_.planar) {
      for (ArmIndex y = faces_.next(x); y != x; y = faces_.next(y))
        if (can_link(x, y)) f(y);
      return;
    }
    for (std::size_t w = 0; w < open_.size(); ++w)
      for (std::uint64_t open = open_[w]; open != 0; open &= open - 1) {
        const auto y =
            static_cast<ArmIndex>(w * 64 + static_cast<unsigned>(std::countr_zero(open)));
        if (can_link(x, y)) f(y);
      }
  }

  /// How visit k is explained by coming in by `arm`.
  Step step(std::size_t k, ArmIndex arm) const {
    if (table_.visit_of(arm) == k) return Step::new_place;
    return linked_[left_[k - 1]] != none ? Step::known : Step::closure;
  }

  /// Coming in by `arm` at visit k leaves no choice while the travels that follow are along known
  /// segments: up to visit `end`, by arms arrived(k) to arrived(end - 1). Such a travel may lead to
  /// what does not look like the visit `end`: nothing else ends a branch, since a new place is
  /// always possible.  Looks before enter(k, arm, step).
  struct Run {
    std::size_t end;
    bool lives;
  };
  [[gnu::always_inline]] Run follow(std::size_t k, ArmIndex arm, Step step) {
    // The segment between x and y is one that enter() will make.
    const ArmIndex x = step == Step::known || k == 0 ? none : left_[k - 1];
    const ArmIndex y = x == none ? none : arm;
    while (true) {
      arrived_[k] = arm;
      const ArmIndex left = left_[k] = table_.left(k, arm);
      if (++k == arrived_.size()) return {k, true};
      const ArmIndex to = left == x ? y : left == y ? x : linked_[left];
      if (to == none) return {k, true};
      if (table_.view(to) != table_.seen(k)) return {k, false};
      arm = to;
    }
  }
  ArmIndex arrived(std::size_t k) const { return arrived_[k]; }

  /// Visit k was entered by `arm`.
  [[gnu::always_inline]] void enter(std::size_t k, ArmIndex arm, Step step) {
    left_[k] = table_.left(k, arm);
    if (step == Step::new_place) open_place(k);
    if (step == Step::known || k == 0) return;
    const ArmIndex x = left_[k - 1];
    if (options_.planar) {
      if (step == Step::new_place)
        faces_.replace(x, table_.gateways_after_entered(k));
      else
        faces_.close(x, arm);
    }
    link(x, arm);
  }

  /// Undoes enter(k, arm, step).
  [[gnu::always_inline]] void leave(std::size_t k, ArmIndex arm, Step step) {
    if (step == Step::known) return;
    if (k > 0) {
      const ArmIndex x = left_[k - 1];
      unlink(x, arm);
      if (options_.planar) {
        if (step == Step::new_place)
          faces_.undo_replace(x);
        else
          faces_.undo_close(x, arm);
      }
    }
    if (step == Step::new_place) close_place(k);
  }

  /// What the extents are after enter(k, arm, step).
  Extents extents_after(std::size_t k, ArmIndex, Step step) const {
    Extents after = extents_;
    if (step == Step::new_place) ++after.places, after.paths += table_.star_size(k) / 2;
    if (step != Step::known && k > 0) ++after.segments, --after.paths;
    return after;
  }

 private:
  static constexpr ArmIndex none = std::numeric_limits<ArmIndex>::max();

  bool can_link(ArmIndex x, ArmIndex y) const {
    if (words_ == 1) {
      if (places_[x] & places_[y]) return false;
    } else {
      for (std::size_t w = 0; w < words_; ++w)
        if (places_[x * words_ + w] & places_[y * words_ + w]) return false;
    }
    return !(options_.one_segment && joined(table_.visit_of(x), table_.visit_of(y))) &&
           !(options_.one_crossing && crossed(x, y));
  }
  bool joined(ArmIndex place, ArmIndex other_place) const;
  bool crossed(ArmIndex x, ArmIndex y) const;
  template <class F>
  void for_each_crossing(ArmIndex end, F&& f) const;
  ArmIndex end_of_path(ArmIndex arm) const;

  // A new place: every local-path is a path of its own, as reset() left it, every gateway open.
  void open_place(std::size_t k) {
    if (!options_.planar)
      for (std::size_t i = first_part_[k]; i < first_part_[k + 1]; ++i)
        open_[parts_[i].word] |= parts_[i].gateways;
    else if (k == 0)
      faces_.open(table_.gateways(0));
    ++extents_.places;
    extents_.paths += table_.star_size(k) / 2;
  }
  void close_place(std::size_t k) {
    if (!options_.planar)
      for (std::size_t i = first_part_[k]; i < first_part_[k + 1]; ++i)
        open_[parts_[i].word] &= ~parts_[i].gateways;
    --extents_.places;
    extents_.paths -= table_.star_size(k) / 2;
  }
  void mark_open(ArmIndex gateway) { open_[gateway / 64] |= std::uint64_t{1} << (gateway % 64); }
  void mark_closed(ArmIndex gateway) {
    open_[gateway / 64] &= ~(std::uint64_t{1} << (gateway % 64));
  }

  // A segment joins the paths that end in x and in y into one, ending at their far ends.
  void link(ArmIndex x, ArmIndex y) {
    linked_[x] = y;
    linked_[y] = x;
    if (!options_.planar) {
      mark_closed(x);
      mark_closed(y);
    }
    const ArmIndex a = far_end_[x];
    const ArmIndex b = far_end_[y];
    far_end_[a] = b;
    far_end_[b] = a;
    if (words_ == 1) {
      places_[a] = places_[b] = places_[x] | places_[y];
    } else {
      for (std::size_t w = 0; w < words_; ++w)
        places_[a * words_ + w] = places_[b * words_ + w] =
            places_[x * words_ + w] | places_[y * words_ + w];
    }
    --extents_.paths;
    ++extents_.segments;
  }
  // x and y still know the paths that ended in them.
  void unlink(ArmIndex x, ArmIndex y) {
    linked_[x] = linked_[y] = none;
    if (!options_.planar) {
      mark_open(x);
      mark_open(y);
    }
    const ArmIndex a = far_end_[x];
    const ArmIndex b = far_end_[y];
    far_end_[a] = x;
    far_end_[b] = y;
    if (words_ == 1) {
      places_[a] = places_[x];
      places_[b] = places_[y];
    } else {
      for (std::size_t w = 0; w < words_; ++w) {
        places_[a * words_ + w] = places_[x * words_ + w];
        places_[b * words_ + w] = places_[y * words_ + w];
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
  Options options_;
  Extents extents_;
  std::size_t words_ = 1;          ///< of a set of places, a bit a visit
  std::vector<ArmIndex> arrived_;  ///< arm by which visit k was entered, in the run followed last
  std::vector<ArmIndex> left_;     ///< arm by which visit k was left
  std::vector<ArmIndex> linked_;   ///< gateway at the other end of the segment
  std::vector<ArmIndex> far_end_;  ///< of an end of a path: its other end
  std::vector<std::uint64_t> places_;  ///< of an end of a path: the places of the path
  std::vector<std::uint64_t> open_;    ///< gateways without a segment, a bit an arm; not if planar
  std::vector<Part> parts_;            ///< of the places of all visits
  std::vector<std::size_t> first_part_;  ///< of visit k; one more at the end
  std::vector<std::uint64_t> alike_;     ///< for each view, the arms that show it
  FaceLists faces_;
};

}  // namespace asterism
