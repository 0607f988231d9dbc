#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "io/picture/layout_picture.hpp"
#include "io/picture/map_legend.hpp"
#include "io/picture/report_sections.hpp"
#include "io/picture/report_text.hpp"
#include "io/picture/svg.hpp"

namespace asterism {
namespace {

constexpr PictureSize card_size{520, 460};

std::string size_text(const TopologicalMap& map) {
  return counted(map.paths.size(), "path") + " and " + counted(map.places.size(), "place");
}

std::string tail_text(const RankedMap& ranked) {
  return "tail probability " + probability_text(ranked.misfit.tail_probability);
}

std::pair<std::size_t, std::size_t> size_of(const TopologicalMap& map) {
  return {map.paths.size(), map.places.size()};
}

bool is_in_pieces(const RunReport& report) {
  return !report.models.empty() && pieces_of(report.models.front().ranked.map).size() > 1;
}

/// How many maps there are, and of what.
std::string counts_clause(const RunReport& report) {
  const std::string visits = counted(report.trace.visits.size(), "visit");
  const std::string kind = report.theory.planar ? "planar " : "";
  if (report.unexplained && !report.consistent) {
    return fmt::format("The maps of the first {} of {} are known{}",
                       count_text(report.unexplained->visits), visits,
                       report.unexplained->why.empty() ? "" : "; " + report.unexplained->why);
  }
  if (report.unexplained) {
    std::string text =
        fmt::format("No {}map explains all {}: the first {} can be explained, the next cannot{}",
                    kind, visits, count_text(report.unexplained->visits),
                    report.unexplained->why.empty() ? "" : ", " + report.unexplained->why);
    if (is_in_pieces(report))
      text += "; cut as few times as can be, the trace is explained in " +
              pieces_text(report.models.front().ranked.map);
    return text;
  }
  if (!report.consistent) return "The maps of " + visits + " were not all counted";
  const std::string explain = *report.consistent == 1 ? "explains" : "explain";
  return fmt::format("{} {} the {}", counted(*report.consistent, kind + "map"), explain, visits);
}

/// How the best stands against the next: the first difference in the order of ranking decides.
std::string lead_clause(const RankedMap& best, const RankedMap& next) {
  if (best.is_plausible && !next.is_plausible) return "the next is not plausible";
  if (size_of(best.map) < size_of(next.map))
    return "it is simpler than the next, which has " + size_text(next.map);
  if (size_of(next.map) < size_of(best.map))
    return "the next, which has " + size_text(next.map) + ", fits worse what was measured";
  const double lead = best.log_likelihood - next.log_likelihood;
  if (lead < 0.05) return "the next is as likely";
  return "it is " + times_text(lead) + " times as likely as the next";
}

std::string best_clause(const RunReport& report) {
  if (report.models.empty()) return "none was laid out";
  const RankedMap& best = report.models.front().ranked;
  const std::string why = best.shared_spots.empty()
                              ? " (" + tail_text(best) + ")"
                              : ", since " + shared_spot_text(best.shared_spots.front());
  std::string text =
      fmt::format("the best {}has {} and is {}plausible{}", report.unexplained ? "of these " : "",
                  size_text(best.map), best.is_plausible ? "" : "not ", why);
  if (report.models.size() > 1) text += "; " + lead_clause(best, report.models[1].ranked);
  return text;
}

std::string figures(const RankedMap& ranked, const RankedMap& best) {
  const Misfit& misfit = ranked.misfit;
  std::string text = "<dl class=\"figures\">\n";
  text += figure("paths, places",
                 fmt::format("{}, {}", ranked.map.paths.size(), ranked.map.places.size()));
  text += figure("χ² / degrees of freedom", fmt::format("{} / {}", decimals(misfit.chi_squared, 1),
                                                        misfit.degrees_of_freedom));
  text += figure("tail probability", probability_text(misfit.tail_probability));
  text += figure("log-likelihood", decimals(ranked.log_likelihood, 1));
  if (&ranked != &best) {
    const double lead = ranked.log_likelihood - best.log_likelihood;
    text += figure("against rank 1", (lead > 0 ? "+" : "") + decimals(lead, 1));
  }
  return text + "</dl>\n";
}

/// The place of each visit: returns are filled; what differs from the best, in the place or the arm
/// entered by, is framed.
std::string visits_row(const TopologicalMap& map, const TopologicalMap& best) {
  std::string text = "<ol class=\"row\" start=\"0\">\n";
  for (std::size_t k = 0; k < map.visits.size(); ++k) {
    const std::size_t place = map.visits[k].index();
    const bool is_return = map.places[place].first_visit.index() != k;
    const bool differs = k < best.visits.size() &&
                         (best.visits[k] != map.visits[k] || best.entered[k] != map.entered[k]);
    text += fmt::format("<li class=\"{}{}\"><i>{}</i>{}</li>\n", is_return ? "back" : "new",
                        differs ? " other" : "", k, place);
  }
  return text + "</ol>\n";
}

/// What speaks against a map though all its measures fit, each pair with a picture.
std::string shared_spots(const RunReport& report, const RankedMap& ranked) {
  constexpr std::size_t most = 6;
  const std::size_t told = std::min(most, ranked.shared_spots.size());
  std::string text;
  std::string pictures;
  for (const SharedSpot& spot : std::span(ranked.shared_spots).first(told)) {
    const std::string what = shared_spot_text(spot);
    text += fmt::format("<p class=\"warning\">{}: {} (tail probability {}).</p>\n", what,
                        ought_to_be_one_text(ranked.map, spot),
                        probability_text(spot.misfit.tail_probability));
    pictures += fmt::format(
        "<figure>{}<figcaption>gateways of place {} orange, of place {} blue, drawn shorter"
        "</figcaption></figure>\n",
        shared_spot_svg(report, ranked, spot, what), spot.one.index(), spot.other.index());
  }
  if (const std::size_t more = ranked.shared_spots.size() - told; more > 0)
    text += fmt::format("<p class=\"warning\">{} of places more.</p>\n", counted(more, "pair"));
  return pictures.empty() ? text : text + "<div class=\"tiles\">\n" + pictures + "</div>\n";
}

std::string card(const RunReport& report, std::size_t index) {
  const RunReport::Model& model = report.models[index];
  const RankedMap& best = report.models.front().ranked;
  const std::size_t rank = index + 1;
  std::string text = fmt::format(
      "<article class=\"card{0}\" id=\"rank-{1}\">\n<h3>Rank {1} <span class=\"{2}\">{3}</span>"
      "</h3>\n",
      index == 0 ? " best" : "", rank, model.ranked.is_plausible ? "good" : "bad",
      model.ranked.is_plausible ? "plausible" : "not plausible");
  text += figures(model.ranked, best);
  text += shared_spots(report, model.ranked);
  text += visits_row(model.ranked.map, best.map);
  text += fmt::format("<figure>{}</figure>\n",
                      layout_svg(model, report.trace, card_size, false,
                                 fmt::format("layout and map of rank {}", rank)));
  if (!model.drawing_svg.empty()) {
    // As an image it keeps to itself, whatever it holds.
    text += fmt::format("<figure><img alt=\"topological map of rank {}\" src=\"{}\"/></figure>\n",
                        rank, data_uri("image/svg+xml", model.drawing_svg));
  }
  return text + path_list(model.ranked.map) + "</article>\n";
}

/// A piece of a path's line.
std::string path_sign(std::size_t path) {
  constexpr double line_width = 6;
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"sign\" viewBox=\"0 0 26 8\"><path d=\"M0 "
      "4h26\" stroke=\"{}\" "
      "stroke-width=\"{}\"/>",
      path_colour(path), line_width);
  if (const std::string stripe = path_stripe(path, line_width); !stripe.empty())
    text += "<path d=\"M0 4h26\" " + stripe + "/>";
  return text + "</svg>";
}

}  // namespace

std::string path_list(const TopologicalMap& map) {
  std::string text = "<ul class=\"paths\">\n";
  for (std::size_t i = 0; i < map.paths.size(); ++i) {
    std::string places;
    for (const PlaceId place : map.paths[i].places) {
      places += (places.empty() ? "" : " – ") + std::to_string(place.index());
    }
    text += fmt::format("<li>{}path {}: {}{}</li>\n", path_sign(i), i, places,
                        map.paths[i].ends.empty() ? " – closed" : "");
  }
  return text + "</ul>\n";
}

std::string verdict_sentence(const RunReport& report) {
  return xml_text(counts_clause(report) + "; " + best_clause(report) + ".");
}

std::string models_section(const RunReport& report) {
  if (report.models.empty()) return {};
  std::string text =
      "<section>\n<h2>Ranked models</h2>\n<p class=\"note\">Plausible ones first, then those with "
      "fewer paths, then fewer places, then the likelier. Boxes: each visit, small, and its place; "
      "filled where it came back to a place, framed where place or arm differ from rank 1. Last, "
      "the map without its metres: dashed arms are gateways not yet travelled, a bar ends a path, "
      "the arrow is the robot.</p>\n"
      "<div class=\"cards\">\n";
  for (std::size_t i = 0; i < report.models.size(); ++i) text += card(report, i);
  return text + "</div>\n</section>\n";
}

}  // namespace asterism
