#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/trace.hpp"
#include "io/picture/clash_svg.hpp"
#include "io/picture/svg_pen.hpp"

namespace asterism {

/// The visits of a clash in a row, or in several of the same length: stars, travels and claims.
class ClashRow {
 public:
  /// @pre  the trace and the picture outlive the row
  ClashRow(const Trace& trace, const ClashPicture& picture);

  double width() const;
  double height() const;
  void draw(SvgPen& pen, SvgPoint corner);

 private:
  struct Cell {
    VisitId visit;
    bool takes_part = true;
    bool is_claimed = false;
  };
  /// A claim of two cells of one row, or half a claim of cells of two rows.
  struct Arc {
    std::size_t from, to;  ///< cells; the same for a half
    std::optional<VisitId> elsewhere;
    bool are_same;
    std::size_t level = 0;  ///< above its row
  };

  std::size_t cell_of(VisitId visit) const;
  std::size_t row_of(std::size_t cell) const { return cell / columns_; }
  bool has_room(const Arc& arc) const;
  void add_arc(Arc arc);
  SvgPoint centre(std::size_t cell) const;
  bool is_followed(std::size_t cell) const;
  void draw_travel(SvgPen& pen, std::size_t cell) const;
  void draw_cell(SvgPen& pen, std::size_t cell) const;
  double port(const Arc& arc, std::size_t Arc::*end) const;
  void draw_arc(SvgPen& pen, const Arc& arc) const;

  const Trace& trace_;
  std::vector<Cell> cells_;
  std::size_t columns_ = 0;
  std::vector<Arc> arcs_;
  std::vector<std::size_t> levels_;  ///< of arcs, for each row
  SvgPoint corner_;
};

}  // namespace asterism
