#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "perception/free_space.hpp"

namespace asterism {

/// Which branches of a skeleton are kept.
struct SkeletonOptions {
  double min_gateway_width_m = 0.95;  ///< narrower branches are cut
  double exit_reach_m = 0.5;  ///< a line stops short of the unknown by half its width and this
  double loop_m = 20;         ///< a way round that is shorter leads round furniture
  /// A branch seen to its end that is longer leads to a dead end; else it is a stub.
  double hallway_m = 8;
  double exit_share = 0.7;  ///< an exit opens to the unknown over this share of a gateway's width
};

/// Points next to one point of the skeleton: at most eight. Threads may read those that none
/// changes.
class Neighbours {
 public:
  /// @pre there are fewer than eight
  void add(std::size_t point) { points_[size_++] = static_cast<std::uint32_t>(point); }
  /// Whether a point is among them.
  bool has(std::size_t point) const { return std::find(begin(), end(), point) != end(); }
  std::size_t size() const noexcept { return size_; }  ///< how many there are
  bool empty() const noexcept { return size_ == 0; }   ///< whether there is none
  /// The one added so many after the first.   @pre i < size()
  std::size_t operator[](std::size_t i) const { return points_[i]; }
  const std::uint32_t* begin() const noexcept { return points_.data(); }  ///< in the order added
  const std::uint32_t* end() const noexcept { return points_.data() + size_; }  ///< past the last

 private:
  std::array<std::uint32_t, 8> points_{};
  std::uint32_t size_ = 0;
};

/// A point of the skeleton, where it can go, and how wide it is there.
struct SkeletonPoint {
  Cell cell = {};
  double radius_m = 0;      ///< r_p: clearance of the cell
  Neighbours neighbours{};  ///< in the full skeleton
  Neighbours critical{};    ///< those of them that the pruned skeleton keeps
};

/// The skeleton of the robot's component of free space, and the part of it that matters; see
/// perception/pruning.hpp.                                       [theory §11, 3-4] [BMK10, §5.1.1]
///
/// Cut first, thinned then: free space less than half a gateway's width from an obstacle belongs to
/// no branch a robot could take, and a picture so shrunk thins to few spurs.
struct Skeleton {
  std::vector<SkeletonPoint> points = {};   ///< row by row
  std::vector<std::size_t> exits = {};      ///< ends at unknown space or at the grid's edge
  std::vector<std::size_t> dead_ends = {};  ///< where branches stop that are kept all the same

  /// Whether a point lies on a branch that matters.
  bool is_critical(std::size_t point) const { return !points[point].critical.empty(); }
  /// Whether three or more branches that matter meet at a point.
  bool is_junction(std::size_t point) const { return points[point].critical.size() > 2; }
};

/// The skeleton of the free space that the robot is in.
///
/// @param robot   its cell, or one near a free one
/// @param driven  where the robot drove, in the grid's frame: no branch is cut there, however
/// narrow
Skeleton skeleton(const FreeSpace& space, Cell robot, const SkeletonOptions& options = {},
                  std::span<const Point2> driven = {});

}  // namespace asterism
