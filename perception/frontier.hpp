#pragma once

#include <optional>

#include "perception/free_space.hpp"
#include "perception/sight_lines.hpp"

namespace asterism {

/// Where free space meets the unknown: free cells beside an unknown one, in 8-connected pieces.
/// Threads may ask one side by side.
class Frontier {
 public:
  /// @param space  must outlive this
  explicit Frontier(const FreeSpace& space);

  /// What an end of the skeleton faces: the longest run of directions in which the first cell that
  /// is not free is unknown, and near.
  struct Opening {
    double width_m = 0;
    std::optional<std::size_t> piece = {};  ///< of the frontier; nothing: grazes the unknown
  };
  /// What a cell at the end of a line faces, no farther away than this.
  Opening opening_at(Cell end, double reach_m) const;

  /// Its pieces, which openings name by number.
  const Pieces& pieces() const noexcept { return pieces_; }

 private:
  const FreeSpace& space_;
  SightLines sight_lines_;
  BitRows cells_;
  Pieces pieces_;
};

}  // namespace asterism
