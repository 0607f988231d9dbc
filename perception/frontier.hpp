#pragma once

#include <optional>

#include "perception/free_space.hpp"
#include "perception/sight_lines.hpp"

namespace asterism {

/// Where free space meets the unknown: free cells beside an unknown one, in 8-connected pieces.
class Frontier {
 public:
  explicit Frontier(const FreeSpace& space);

  /// What an end of the skeleton faces: the longest run of directions in which the first cell that
  /// is not free is unknown, and near.
  struct Opening {
    double width_m = 0;
    std::optional<std::size_t> piece = {};  ///< of the frontier; nothing: grazes the unknown
  };
  Opening opening_at(Cell end, double reach_m) const;

  const Pieces& pieces() const noexcept { return pieces_; }

 private:
  const FreeSpace& space_;
  SightLines sight_lines_;
  BitRows cells_;
  Pieces pieces_;
};

}  // namespace asterism
