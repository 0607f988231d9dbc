#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "io/picture/layout_picture.hpp"
#include "io/picture/report_sections.hpp"
#include "io/picture/report_text.hpp"
#include "io/picture/svg.hpp"

namespace asterism {
namespace {

constexpr std::size_t most_rows_open = 25;  ///< longer tables are folded at first
constexpr const char* none = "–";

std::string arm_text(const Visit& visit, const std::optional<std::size_t>& arm) {
  return arm ? xml_text(visit.star.name(*arm)) : none;
}

std::string share_text(double share) { return decimals(100 * share, 0) + " %"; }

std::string visits_of(const TopologicalMap& map, std::size_t place) {
  std::string text;
  for (std::size_t k = 0; k < map.visits.size(); ++k) {
    if (map.visits[k].index() == place) text += fmt::format("{}{}", text.empty() ? "" : ", ", k);
  }
  return text;
}

std::string places_table(const RankedMap& ranked) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t p = 0; p < ranked.map.places.size(); ++p) {
    const bool is_uncertain = p < ranked.layout.covariances.size();
    const auto deviation = [&](std::size_t i, double unit, int digits) {
      return is_uncertain
                 ? decimals(unit * std::sqrt(std::max(0.0, ranked.layout.covariances[p][4 * i])),
                            digits)
                 : none;
    };
    rows.push_back({std::to_string(p), visits_of(ranked.map, p),
                    xml_text(ranked.map.places[p].star.text()),
                    pose_text(ranked.layout.layout_from_place[p]), deviation(0, 1, 2),
                    deviation(1, 1, 2), deviation(2, 180 / std::numbers::pi, 2)});
  }
  return table({{"place", true},
                {"visits"},
                {"star, clockwise"},
                {"laid out: x, y, heading", true},
                {"± ahead, m", true},
                {"± left, m", true},
                {"± heading, °", true}},
               rows);
}

std::string alignments_table(const RankedMap& ranked) {
  std::vector<std::vector<std::string>> rows;
  for (const Alignment& alignment : ranked.alignments) {
    rows.push_back({std::to_string(alignment.visit.index()),
                    std::to_string(alignment.place.index()), pose_text(alignment.place_from_visit),
                    fmt::format("{} / {}", decimals(alignment.misfit.chi_squared, 1),
                                alignment.misfit.degrees_of_freedom),
                    probability_text(alignment.misfit.tail_probability),
                    share_text(alignment.matched_walls)});
  }
  return table({{"visit", true},
                {"place", true},
                {"offset: x, y, turn", true},
                {"χ² / degrees of freedom", true},
                {"tail probability", true},
                {"matched walls", true}},
               rows);
}

std::string displacements_table(const RankedMap& ranked) {
  const std::vector<Pose2>& poses = ranked.layout.layout_from_place;
  std::vector<std::vector<std::string>> rows;
  for (std::size_t k = 0; k < ranked.displacements.size(); ++k) {
    const PlaceDisplacement& travel = ranked.displacements[k];
    const Pose2 measured{travel.displacement.x_m, travel.displacement.y_m,
                         travel.displacement.heading_rad};
    const Pose2 laid_out = inverse(poses.at(travel.from.index())) * poses.at(travel.to.index());
    rows.push_back(
        {std::to_string(k), fmt::format("{} → {}", travel.from.index(), travel.to.index()),
         pose_text(measured), pose_text(laid_out), pose_text(inverse(measured) * laid_out)});
  }
  return table({{"travel", true},
                {"places"},
                {"measured: x, y, turn", true},
                {"laid out", true},
                {"residual", true}},
               rows);
}

std::string measures(const RankedMap& ranked) {
  std::string text = "<h3>Places</h3>\n" + places_table(ranked);
  if (!ranked.alignments.empty()) {
    text += "<h3>Alignments: where returns to a place were in its frame</h3>\n" +
            alignments_table(ranked);
  }
  if (!ranked.displacements.empty()) {
    text += "<h3>Displacements: the place reached as seen from the place left</h3>\n" +
            displacements_table(ranked);
  }
  return text;
}

std::string visits_table(const RunReport& report, const std::vector<std::string>& pictures) {
  const std::vector<PlaceId> none_placed;
  const std::vector<PlaceId>& places =
      report.models.empty() ? none_placed : report.models.front().ranked.map.visits;
  std::vector<std::vector<std::string>> rows;
  for (std::size_t k = 0; k < report.trace.visits.size(); ++k) {
    const Visit& visit = report.trace.visits[k];
    rows.push_back(
        {pictures[k].empty() ? std::to_string(k) : fmt::format("<a href=\"#visit-{0}\">{0}</a>", k),
         k < places.size() ? std::to_string(places[k].index()) : none, xml_text(visit.star.text()),
         arm_text(visit, visit.entered_by), arm_text(visit, visit.left_by),
         visit.scans ? fmt::format("{} – {}", (*visit.scans)[0], (*visit.scans)[1]) : none,
         visit.stamps_s ? decimals((*visit.stamps_s)[1] - (*visit.stamps_s)[0], 1) : none});
  }
  return table({{"visit", true},
                {"place", true},
                {"star, clockwise"},
                {"entered by"},
                {"left by"},
                {"scans", true},
                {"stay, s", true}},
               rows);
}

/// Pictures of the visits to one place stand together.
std::string place_maps(const RunReport& report, const std::vector<std::string>& pictures) {
  std::vector<std::vector<std::size_t>> groups;
  const bool is_placed = !report.models.empty();
  if (is_placed) groups.resize(report.models.front().ranked.map.places.size());
  groups.emplace_back();
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    if (pictures[k].empty()) continue;
    const bool has_place = is_placed && k < report.models.front().ranked.map.visits.size();
    groups[has_place ? report.models.front().ranked.map.visits[k].index() : groups.size() - 1]
        .push_back(k);
  }
  std::string text;
  for (std::size_t p = 0; p < groups.size(); ++p) {
    for (const std::size_t k : groups[p]) {
      const std::string place =
          p + 1 < groups.size() ? fmt::format("<b>place {}</b> · ", p) : std::string();
      text += fmt::format(
          "<figure id=\"visit-{0}\">{1}<figcaption>{2}visit {0}<br/>{3}</figcaption></figure>\n", k,
          pictures[k], place, xml_text(report.trace.visits[k].star.text()));
    }
  }
  if (text.empty()) return text;
  const std::string turned =
      is_placed ? ", ordered by places, turned and coloured as in the map above" : "";
  return fmt::format(
      "<h3>Place maps{}</h3>\n<p class=\"note\">Bars are gateways, with the names of their arms in "
      "that visit's star; the robot came in by <b>in</b> and left by <b>out</b>.</p>\n"
      "<div class=\"tiles\">\n{}</div>\n",
      turned, text);
}

}  // namespace

std::string visits_section(const RunReport& report) {
  const PlaceMaps maps(report);
  std::vector<std::string> pictures;
  for (std::size_t k = 0; k < report.trace.visits.size(); ++k) {
    pictures.push_back(maps.svg(VisitId(k)));
  }
  return fmt::format("<section class=\"visits\">\n<h2>Visits</h2>\n{}{}</section>\n",
                     folding(counted(pictures.size(), "visit") + ", as perceived",
                             visits_table(report, pictures), pictures.size() <= most_rows_open),
                     place_maps(report, pictures));
}

std::string measures_section(const RunReport& report) {
  std::string text;
  for (std::size_t i = 0; i < report.models.size(); ++i) {
    const RankedMap& ranked = report.models[i].ranked;
    text += folding(fmt::format("Rank {}", i + 1), measures(ranked),
                    i == 0 && ranked.displacements.size() <= most_rows_open);
  }
  if (text.empty()) return text;
  return "<section>\n<h2>Measures</h2>\n"
         "<p class=\"note\">Poses are x, y and heading: +x ahead, +y left, counter-clockwise. ± is "
         "one standard deviation; place 0 is where the layout hangs, so it is certain.</p>\n" +
         text + "</section>\n";
}

}  // namespace asterism
