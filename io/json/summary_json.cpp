#include "io/json/summary_json.hpp"

#include <fmt/format.h>

#include <array>

#include "io/json/assumption_json.hpp"
#include "io/json/json_writer.hpp"

namespace asterism {
namespace {

/// For people too: 0.0001 and 100000, where the shortest are 1e-04 and 1e+05.
JsonValue plain(double number) { return {JsonValue::Real{number, fmt::format("{}", number)}}; }

void write_model(JsonWriter& json, const RunReport::Model& model) {
  const RankedMap& ranked = model.ranked;
  json.object([&] {
    json.member("plausible", ranked.is_plausible, "paths", ranked.map.paths.size(), "places",
                ranked.map.places.size(), "chi_squared", plain(ranked.misfit.chi_squared),
                "degrees_of_freedom", ranked.misfit.degrees_of_freedom, "tail_probability",
                plain(ranked.misfit.tail_probability), "log_likelihood",
                plain(ranked.log_likelihood));
    json.line().member("visits", ranked.map.visits);
    if (!ranked.shared_spots.empty())
      json.line().key("shared_spots").array([&] {
        for (const SharedSpot& spot : ranked.shared_spots)
          json.object("places", std::array{spot.one, spot.other}, "distance_m",
                      plain(spot.distance_m));
      });
  });
}

void write_spread(JsonWriter& json, const SpreadSummary& spread) {
  json.object("mean", plain(spread.mean), "standard_deviation", plain(spread.standard_deviation));
}

}  // namespace

std::string run_summary_json(const RunReport& report, bool complete) {
  JsonWriter json;
  json.object([&] {
    const std::size_t visits = report.trace.visits.size();
    json.line().member("scans", report.scans, "visits", visits, "explained_visits",
                       report.unexplained ? report.unexplained->visits : visits, "consistent",
                       report.consistent, "complete", complete);
    if (!report.theory.assumptions.empty())
      write_assumptions(json.line(), report.theory.assumptions);
    if (report.unexplained) json.line().member("why", report.unexplained->why);
    if (report.unexplained && !report.models.empty())
      json.line().member("parts", pieces_of(report.models.front().ranked.map));
    if (!report.remarks.empty()) json.line().member("remarks", report.remarks);
    json.line().key("models").array([&] {
      for (const RunReport::Model& model : report.models) write_model(json.line(), model);
      json.line();
    });
    json.line();
  });
  return json.take() + '\n';
}

std::string relation_errors_json(std::size_t relations, std::size_t matched,
                                 const SpreadSummary& translation_m,
                                 const SpreadSummary& rotation_rad) {
  JsonWriter json;
  json.object([&] {
    json.member("relations", relations, "matched", matched);
    write_spread(json.line().key("translation_m"), translation_m);
    write_spread(json.line().key("rotation_rad"), rotation_rad);
  });
  return json.take() + '\n';
}

std::string reference_errors_json(std::size_t poses, std::size_t matched, double position_rmse_m,
                                  double heading_rmse_rad, const Pose2& reference_from_layout) {
  const auto& [x_m, y_m, heading_rad] = reference_from_layout;
  JsonWriter json;
  json.object([&] {
    json.member("poses", poses, "matched", matched);
    json.line().member("position_rmse_m", plain(position_rmse_m), "heading_rmse_rad",
                       plain(heading_rmse_rad));
    json.line().member("reference_from_layout",
                       std::array{plain(x_m), plain(y_m), plain(heading_rad)});
  });
  return json.take() + '\n';
}

}  // namespace asterism
