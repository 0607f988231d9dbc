#include "io/picture/report_page.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "io/picture/chart_svg.hpp"
#include "io/picture/layout_picture.hpp"
#include "io/picture/report_sections.hpp"
#include "io/picture/report_text.hpp"
#include "io/picture/svg.hpp"

namespace asterism {
namespace {

constexpr PictureSize main_size{780, 900};
constexpr PictureSize wide_size{1190, 1300};
constexpr std::size_t many_places = 15;  ///< these need the page's whole width
constexpr PictureSize beside_size{390, 640};

void require_fit(const RunReport& report) {
  for (std::size_t i = 0; i < report.models.size(); ++i) {
    const RankedMap& ranked = report.models[i].ranked;
    const std::size_t poses = ranked.layout.layout_from_place.size();
    if (ranked.map.places.empty() || poses != ranked.map.places.size())
      throw std::invalid_argument(
          fmt::format("/models/{}: found {} poses; expected {}, one a place", i, poses,
                      ranked.map.places.size()));
    if (ranked.map.visits.size() > report.trace.visits.size())
      throw std::invalid_argument(fmt::format("/models/{}: found {} visits; expected at most {}", i,
                                              ranked.map.visits.size(),
                                              report.trace.visits.size()));
  }
}

std::string figures(const RunReport& report) {
  std::string text = "<dl class=\"figures\">\n";
  text += figure("scans", count_text(report.scans));
  text += figure("duration", duration_text(report.duration_s));
  text += figure("driven", decimals(report.driven_m, 0) + " m");
  text += figure("visits", count_text(report.trace.visits.size()));
  if (!report.theory.assumptions.empty())
    text += figure("assumed", xml_text(text_of(report.theory.assumptions)));
  if (report.consistent)
    text +=
        figure(report.theory.planar ? "planar maps that explain them" : "maps that explain them",
               count_text(*report.consistent));
  if (report.minimal) {
    text += figure("minimal models", fmt::format("{} ({}, {}{})", report.minimal->count,
                                                 counted(report.minimal->paths, "path"),
                                                 counted(report.minimal->places, "place"),
                                                 report.minimal->certified ? "; certified" : ""));
  }
  return text + "</dl>\n";
}

std::string header(const RunReport& report) {
  std::string text = fmt::format(
      "<header>\n<p class=\"kind\">asterism · report of a run</p>\n<h1>{}</h1>\n"
      "<p class=\"verdict\">{}</p>\n{}</header>\n",
      xml_text(report.log), verdict_sentence(report), figures(report));
  if (report.minimal && report.minimal->certified)
    text +=
        "<p class=\"note\">Minimal models are the simplest maps that explain the trace; certified "
        "means that the solver has proved that none is simpler. Simplest is not yet true.</p>\n";
  if (report.models.empty()) {
    // There is nothing whose reach has to be told.
  } else if (const TopologicalMap& map = report.models.front().ranked.map;
             pieces_of(map).size() > 1) {
    text += "<p class=\"warning\">The models are in " + pieces_text(map) +
            ": each is a map for itself, and lies as was measured on the way from the one before. "
            "A place of the building may be in several pieces.</p>\n";
  } else if (report.unexplained) {
    text += fmt::format(
        "<p class=\"warning\">The models explain the first {} of {} only; what was driven after "
        "them is appended as measured on the way.</p>\n",
        report.unexplained->visits, counted(report.trace.visits.size(), "visit"));
  }
  for (const std::string& remark : report.remarks)
    text += "<p class=\"warning\">" + xml_text(remark) + ".</p>\n";
  return text;
}

std::string maps_section(const RunReport& report) {
  std::string map;
  std::string beside;
  bool is_wide = false;
  if (!report.models.empty()) {
    const RunReport::Model& best = report.models.front();
    is_wide = best.ranked.map.places.size() > many_places;
    map = fmt::format("<figure>{}</figure>\n",
                      layout_svg(best, report.trace, is_wide ? wide_size : main_size, true,
                                 "global map with the layout of rank 1"));
    beside = fmt::format(
        "<div class=\"legend\">\n<h3>Rank 1</h3>\n{}<p class=\"note\">Numbered discs are places, "
        "coloured lines the segments of their paths, bars gateways with the names of their arms; "
        "dashed, a gateway not yet travelled; a crossbar at a disc ends a path. The thin line is "
        "the robot’s way, from the dot to the arrowhead. Orange ellipses, where larger than the "
        "discs, hold a place with a probability of 95 %.</p></div>\n",
        path_list(best.ranked.map));
  }
  if (report.odometry_map) {
    beside += fmt::format(
        "<figure>{}<figcaption>Raw odometry: the same scans, drawn where the wheels say the robot "
        "was.</figcaption></figure>\n",
        grid_svg(*report.odometry_map, beside_size, "map by raw odometry"));
  }
  if (map.empty() && beside.empty()) return {};
  return fmt::format(
      "<section>\n<h2>Map</h2>\n<div class=\"{}\">\n{}<div{}>\n{}</div>\n</div>\n</section>\n",
      is_wide ? "stacked" : "maps", map, is_wide ? " class=\"pair\"" : "", beside);
}

std::string chart(const RunReport& report) {
  if (report.all_per_visit.empty() && report.planar_per_visit.empty()) return {};
  const std::string svg =
      hypotheses_chart_svg(report.log, report.all_per_visit, report.planar_per_visit);
  return fmt::format(
      "<figure class=\"chart\"><img alt=\"maps that explain the visits so far, visit by visit\" "
      "src=\"{}\"/></figure>\n",
      data_uri("image/svg+xml", svg));
}

std::string decisions(const RunReport& report) {
  if (report.decided.empty()) return {};
  std::vector<std::vector<std::string>> rows;
  for (const RunReport::Decision& decision : report.decided) {
    rows.push_back({"<b>" + xml_text(decision.what) + "</b>", xml_text(decision.how),
                    decision.count ? count_text(*decision.count) : "–"});
  }
  return "<div class=\"wrap\"><h3>What was decided by what</h3>\n" +
         table({{"by"}, {"how"}, {"ruled out or put behind", true}}, rows) + "</div>\n";
}

std::string tree_section(const RunReport& report) {
  const std::string text = chart(report) + decisions(report);
  if (text.empty()) return text;
  return "<section>\n<h2>From visits to maps</h2>\n<div class=\"pair\">\n" + text +
         "</div>\n</section>\n";
}

}  // namespace

std::string run_report_html(const RunReport& report) {
  require_fit(report);
  return fmt::format(
      "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n"
      "<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<title>{}: report of a run</title>\n<style>{}</style>\n</head>\n<body>\n{}<main>\n{}{}{}{}{}"
      "</main>\n</body>\n</html>\n",
      xml_text(report.log), report_style(), header(report), maps_section(report),
      tree_section(report), models_section(report), visits_section(report),
      measures_section(report));
}

}  // namespace asterism
