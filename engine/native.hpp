#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "engine/arm_table.hpp"
#include "planarity/face_lists.hpp"

namespace asterism {

/// Sizes of the extents that a preference may minimise.                           [DESIGN §6]
struct Extents {
  std::uint32_t paths = 0;
  std::uint32_t places = 0;
  std::uint32_t segments = 0;
};

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

  NativeEngine(const ArmTable& table, Options options) : table_(table), options_(options) {}

  /// Begins again with the empty hypothesis, and room for all visits of the arm table.
  void reset();

  /// Calls f(arm) for each way in which the hypothesis can explain visit k.  [BMK10, Fig. 5]
  /// Closures come in the order of arms (of the face, where planar), the new place last.
  /// @pre the hypothesis explains the visits before k
  template <class F>
  void for_each_child(std::size_t k, F&& f) {
    if (k == 0) return f(table_.entered(0));
    const ArmIndex x = left_[k - 1];
    if (linked_[x] != none) {
      if (table_.view(linked_[x]) == table_.seen(k)) f(linked_[x]);
      return;
    }
    if (options_.planar) {
      for (ArmIndex y = faces_.next(x); y != x; y = faces_.next(y))
        if (table_.view(y) == table_.seen(k) && can_link(x, y)) f(y);
    } else {
      for (ArmIndex y = open_next_[head(table_.seen(k))]; y < table_.size(); y = open_next_[y])
        if (can_link(x, y)) f(y);
    }
    f(table_.entered(k));
  }

  /// Visit k was entered by `arm`.
  void enter(std::size_t k, ArmIndex arm);
  /// Undoes enter(k, arm).
  void leave(std::size_t k, ArmIndex arm);

  Extents extents() const { return extents_; }
  /// What extents() would be after enter(k, arm).
  Extents extents_after(std::size_t k, ArmIndex arm) const {
    Extents after = extents_;
    if (k > 0 && linked_[left_[k - 1]] != none) return after;
    if (k > 0) ++after.segments, --after.paths;
    if (table_.visit_of(arm) == k) ++after.places, after.paths += table_.star_size(k) / 2;
    return after;
  }

 private:
  static constexpr ArmIndex none = std::numeric_limits<ArmIndex>::max();

  /// Open gateways are kept in one circular list a view, whose head follows the arms.
  ArmIndex head(ArmIndex view) const { return static_cast<ArmIndex>(table_.size()) + view; }

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

  void open_place(std::size_t k, ArmIndex entered);
  void close_place(std::size_t k);
  void link(ArmIndex x, ArmIndex y);
  void unlink(ArmIndex x, ArmIndex y);
  void list_last(ArmIndex gateway);
  void unlist(ArmIndex gateway) {
    open_next_[open_previous_[gateway]] = open_next_[gateway];
    open_previous_[open_next_[gateway]] = open_previous_[gateway];
  }
  void relist(ArmIndex gateway) {
    open_next_[open_previous_[gateway]] = gateway;
    open_previous_[open_next_[gateway]] = gateway;
  }

  const ArmTable& table_;
  Options options_;
  Extents extents_;
  std::size_t words_ = 1;                ///< of a set of places, a bit a visit
  std::vector<ArmIndex> left_;           ///< arm by which visit k was left
  std::vector<std::uint8_t> travelled_;  ///< whether visit k brought a new segment
  std::vector<ArmIndex> linked_;         ///< gateway at the other end of the segment
  std::vector<ArmIndex> far_end_;        ///< of an end of a path: its other end
  std::vector<std::uint64_t> places_;    ///< of an end of a path: the places of the path
  std::vector<ArmIndex> open_next_;
  std::vector<ArmIndex> open_previous_;
  FaceLists faces_;
  std::vector<ArmIndex> scratch_;
};

}  // namespace asterism
