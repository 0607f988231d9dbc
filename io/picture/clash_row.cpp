#include "io/picture/clash_row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace asterism {
namespace {

constexpr std::size_t max_columns = 7;
constexpr double pitch = 150;  ///< from one visit to the next
constexpr double disc = 16;    ///< radii, from a star's centre
constexpr double stem = 33;    ///< ... to where an arm ends, or its corridor opens
constexpr double reach = 45;   ///< ... to where travels begin and end
constexpr double lane = 62;    ///< above and below a star, for travels that go round it
constexpr double label = 74;   ///< above a star, baseline of "visit 8"
constexpr double arcs = 92;    ///< above a star, where claims begin
constexpr double level_height = 26;
constexpr double row_gap = 26;  ///< between rows; the travel to the next row runs in it
constexpr std::size_t max_named_arms = 6;
constexpr std::size_t max_name_length = 5;

const char* const arm_ink = "#777777";
const char* const dark = "fill=\"#222222\" stroke=\"#ffffff\" stroke-width=\"1.5\"";
const char* const claim_ink = "#c00000";

SvgPoint direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Where an arm points: clockwise in the picture, too, where y is down. The robot comes from the
/// left.
SvgPoint direction(const Visit& visit, std::size_t arm) {
  const auto turn = [&](std::size_t from) {
    return 2 * std::numbers::pi * (static_cast<double>(arm) - static_cast<double>(from)) /
           static_cast<double>(visit.star.size());
  };
  if (visit.entered_by) return direction(std::numbers::pi + turn(*visit.entered_by));
  if (visit.left_by) return direction(turn(*visit.left_by));
  return direction(-std::numbers::pi / 2 + turn(0));
}

void draw_arm(SvgPen& pen, const Visit& visit, std::size_t arm, SvgPoint centre) {
  const SvgPoint along = direction(visit, arm);
  const SvgPoint aside{-along.y, along.x};
  const std::string ink = fmt::format("stroke=\"{}\" ", arm_ink);
  const SvgPoint end = centre + stem * along;
  pen.line(centre, end, ink + "stroke-width=\"5\"");
  if (visit.star.has_gateway(arm)) {
    for (const double side : {-1.0, 1.0})  // the mouth of a corridor
      pen.line(end + (2.5 * side) * aside, centre + reach * along + (8 * side) * aside,
               ink + "stroke-width=\"2.5\"");
  } else {
    pen.line(end + 8.0 * aside, end - 8.0 * aside, ink + "stroke-width=\"5\"");
  }
  if (arm == visit.entered_by) pen.arrow(centre + disc * along, -1.0 * along, 13, 5.5, dark);
  if (arm == visit.left_by) pen.arrow(centre + (reach - 3) * along, along, 13, 5.5, dark);
  const std::string name = visit.star.name(arm);
  if (visit.star.size() > max_named_arms || name.size() > max_name_length) return;
  const SvgPoint at = centre + (stem - 2) * along + 15.0 * aside;
  pen.text({at.x, at.y + 3.5}, name, "text-anchor=\"middle\" font-size=\"10\" fill=\"#777777\"");
}

}  // namespace

ClashRow::ClashRow(const Trace& trace, const ClashPicture& picture) : trace_(trace) {
  const std::set<VisitId> part(picture.visits.begin(), picture.visits.end());
  std::set<VisitId> claimed;
  for (const auto& [one, other, are_same] : picture.claimed) claimed.insert({one, other});
  std::set<VisitId> all = part;
  all.insert(claimed.begin(), claimed.end());
  for (const VisitId visit : all)
    cells_.push_back({visit, part.contains(visit), claimed.contains(visit)});

  const std::size_t rows =
      std::max<std::size_t>(1, (cells_.size() + max_columns - 1) / max_columns);
  columns_ = (cells_.size() + rows - 1) / rows;
  levels_.assign(rows, 0);
  std::vector<Arc> wanted;
  for (const auto& [one, other, are_same] : picture.claimed) {
    const auto [from, to] = std::minmax({cell_of(one), cell_of(other)});
    if (from == to) continue;
    if (row_of(from) == row_of(to)) {
      wanted.push_back({from, to, {}, are_same});
    } else {
      wanted.push_back({from, from, cells_[to].visit, are_same});
      wanted.push_back({to, to, cells_[from].visit, are_same});
    }
  }
  // Short ones below.
  std::ranges::stable_sort(wanted, {}, [](const Arc& arc) { return arc.to - arc.from; });
  for (const Arc& arc : wanted) add_arc(arc);
}

std::size_t ClashRow::cell_of(VisitId visit) const {
  return static_cast<std::size_t>(std::ranges::find(cells_, visit, &Cell::visit) - cells_.begin());
}

/// The words of a half are wider than its cell.
bool ClashRow::has_room(const Arc& arc) const {
  const auto keep_apart = [&](const Arc& other) {
    const std::size_t wide = arc.elsewhere || other.elsewhere ? 1 : 0;
    return arc.to + wide < other.from || other.to + wide < arc.from;
  };
  return std::ranges::all_of(arcs_, [&](const Arc& other) {
    return row_of(other.from) != row_of(arc.from) || other.level != arc.level || keep_apart(other);
  });
}

void ClashRow::add_arc(Arc arc) {
  while (!has_room(arc)) ++arc.level;
  std::size_t& levels = levels_[row_of(arc.from)];
  levels = std::max(levels, arc.level + 1);
  arcs_.push_back(arc);
}

double ClashRow::width() const { return pitch * static_cast<double>(columns_); }

double ClashRow::height() const {
  double height = row_gap * static_cast<double>(levels_.size() - 1);
  for (const std::size_t levels : levels_)
    height += level_height * static_cast<double>(levels) + arcs + lane;
  return height;
}

SvgPoint ClashRow::centre(std::size_t cell) const {
  const std::size_t row = row_of(cell);
  double y = corner_.y;
  for (std::size_t r = 0; r <= row; ++r)
    y += level_height * static_cast<double>(levels_[r]) + arcs + (r == 0 ? 0 : lane + row_gap);
  return {corner_.x + pitch * (static_cast<double>(cell % columns_) + 0.5), y};
}

bool ClashRow::is_followed(std::size_t cell) const {
  return cell + 1 < cells_.size() && cells_[cell].takes_part && cells_[cell + 1].takes_part &&
         cells_[cell + 1].visit.index() == cells_[cell].visit.index() + 1;
}

void ClashRow::draw(SvgPen& pen, SvgPoint corner) {
  corner_ = corner;
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    if (is_followed(cell))
      draw_travel(pen, cell);
    else if (cell + 1 < cells_.size() &&
             cells_[cell + 1].visit.index() > cells_[cell].visit.index() + 1)
      pen.text(centre(cell) + SvgPoint{pitch / 2, 4}, "\u2026",
               "text-anchor=\"middle\" font-size=\"22\" fill=\"#777777\"");
  }
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) draw_cell(pen, cell);
  for (const Arc& arc : arcs_) draw_arc(pen, arc);
}

/// Out along the arm left by, round the star to the middle between the two, in from the left.
void ClashRow::draw_travel(SvgPen& pen, std::size_t cell) const {
  const Visit& visit = trace_.visits[cells_[cell].visit.index()];
  const SvgPoint from = centre(cell);
  const SvgPoint to = centre(cell + 1);
  const SvgPoint along = direction(visit, *visit.left_by);
  const double middle = from.x + pitch / 2;
  const bool is_wrapped = row_of(cell) != row_of(cell + 1);
  const double between = from.y + lane + row_gap / 2;  // the rows

  std::vector<SvgPoint> line{from + reach * along};
  if (visit.left_by == visit.entered_by) line.front().y += 7;  // beside where it came in
  const bool is_below = is_wrapped && along.x <= 0.3 && along.y >= -0.01;
  if (is_below) {
    line.push_back({line.front().x, between});
  } else {
    if (along.x <= 0.3) line.push_back({line.front().x, from.y + (along.y < -0.01 ? -lane : lane)});
    line.push_back({middle, line.back().y});
    if (is_wrapped) line.push_back({middle, between});
  }
  if (is_wrapped) line.push_back({to.x - pitch / 2, between});
  line.push_back({line.back().x, to.y});
  line.push_back({to.x - reach, to.y});
  // Points met twice in a row have no direction.
  const auto is_near = [](SvgPoint a, SvgPoint b) { return length(b - a) < 0.01; };
  line.erase(std::unique(line.begin(), line.end(), is_near), line.end());
  pen.path(rounded(line, 10), "fill=\"none\" stroke=\"#222222\" stroke-width=\"2\"");
}

void ClashRow::draw_cell(SvgPen& pen, std::size_t cell) const {
  const auto& [id, takes_part, is_claimed] = cells_[cell];
  const Visit& visit = trace_.visits[id.index()];
  const SvgPoint at = centre(cell);
  if (takes_part)
    for (std::size_t arm = 0; arm < visit.star.size(); ++arm) draw_arm(pen, visit, arm, at);
  pen.circle(
      at, disc,
      fmt::format("fill=\"#ffffff\" stroke=\"{}\" stroke-width=\"2\"{}",
                  takes_part ? "#222222" : arm_ink, takes_part ? "" : " stroke-dasharray=\"4 3\""));
  pen.text({at.x, at.y + 4.5}, std::to_string(id.index()), "text-anchor=\"middle\"");
  pen.text({at.x, at.y - label}, fmt::format("visit {}", id.index()),
           fmt::format("text-anchor=\"middle\" font-weight=\"bold\"{}",
                       is_claimed ? fmt::format(" fill=\"{}\"", claim_ink) : ""));
}

/// How far from the middle of its visit an arc ends: of several, the highest nearest to it, so that
/// they do not cross.
double ClashRow::port(const Arc& arc, std::size_t Arc::*end) const {
  const auto outer = std::ranges::count_if(arcs_, [&](const Arc& other) {
    return !other.elsewhere && other.*end == arc.*end && other.level > arc.level;
  });
  return 4 + 6 * static_cast<double>(outer);
}

void ClashRow::draw_arc(SvgPen& pen, const Arc& arc) const {
  const double foot = centre(arc.from).y - arcs;
  const double y = foot - 8 - level_height * static_cast<double>(arc.level);
  const std::string ink = fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"2.5\"{}",
                                      claim_ink, arc.are_same ? "" : " stroke-dasharray=\"6 4\"");
  std::string words = arc.are_same ? "same place" : "different places";
  double middle = centre(arc.from).x;
  if (arc.elsewhere) {
    words += fmt::format(" {} visit {}", arc.are_same ? "as" : "than", arc.elsewhere->index());
    pen.line({middle, foot}, {middle, y}, ink);
  } else {
    const double left = centre(arc.from).x + port(arc, &Arc::from);
    const double right = centre(arc.to).x - port(arc, &Arc::to);
    pen.path(rounded({{left, foot}, {left, y}, {right, y}, {right, foot}}, 10), ink);
    middle = (left + right) / 2;
  }
  pen.text({middle, y - 6}, words,
           fmt::format("text-anchor=\"middle\" fill=\"{}\" stroke=\"#ffffff\" stroke-width=\"3\" "
                       "paint-order=\"stroke\"",
                       claim_ink));
}

}  // namespace asterism
