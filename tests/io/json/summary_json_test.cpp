#include "io/json/summary_json.hpp"

#include "tests/support/catch.hpp"

using namespace asterism;

TEST_CASE("errors are printed for programs with numbers as people write them", "[io]") {
  CHECK(relation_errors_json(3, 2, {0.0001, 100000}, {1e-9, 0.25}) ==
        R"json({ "relations": 3, "matched": 2,
  "translation_m": { "mean": 0.0001, "standard_deviation": 100000 },
  "rotation_rad": { "mean": 1e-09, "standard_deviation": 0.25 } }
)json");
  CHECK(reference_errors_json(5, 4, 0.5, 0.0625, {1, -2, 0.5}) ==
        R"json({ "poses": 5, "matched": 4,
  "position_rmse_m": 0.5, "heading_rmse_rad": 0.0625,
  "reference_from_layout": [1, -2, 0.5] }
)json");
}

TEST_CASE("the summary of a run tells each model in two lines", "[io]") {
  RunReport report;
  report.scans = 7;
  report.trace.visits.push_back({.star = Star::parse("a+1 a-1")});
  CHECK(run_summary_json(report, true) == R"json({
  "scans": 7, "visits": 1, "explained_visits": 1, "consistent": null, "complete": true,
  "models": [
  ]
}
)json");

  report.consistent = 2;
  report.theory.assumptions = {{Assumption::Kind::same, VisitId(0), VisitId(1)}};
  report.unexplained = {1, "the next is not"};
  RunReport::Model model;
  model.ranked.map.visits = {PlaceId(0), PlaceId(1)};
  model.ranked.map.left = {std::nullopt, std::nullopt};
  model.ranked.log_likelihood = -1.5;
  report.models = {model, model};
  CHECK(run_summary_json(report, false) == R"json({
  "scans": 7, "visits": 1, "explained_visits": 1, "consistent": 2, "complete": false,
  "assumptions": ["same(0, 1)"],
  "why": "the next is not",
  "parts": [[0, 0], [1, 1]],
  "models": [
    { "plausible": true, "paths": 0, "places": 0, "chi_squared": 0, "degrees_of_freedom": 0, "tail_probability": 1, "log_likelihood": -1.5,
      "visits": [0, 1] },
    { "plausible": true, "paths": 0, "places": 0, "chi_squared": 0, "degrees_of_freedom": 0, "tail_probability": 1, "log_likelihood": -1.5,
      "visits": [0, 1] }
  ]
}
)json");
}
