#include "io/json/maps_file.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <sstream>

#include "core/error.hpp"
#include "core/random.hpp"
#include "io/json/trace_file.hpp"
#include "tests/io/corpus.hpp"
#include "tests/io/json/round_trip.hpp"
#include "tests/io/same.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

template <class Report>
std::string text_of(const Report& report) {
  std::ostringstream out;
  write_maps(out, report);
  return out.str();
}

//  0 ---- 1     the corner: out of 0 by a+, into 1 by c-, out by d+, into 2 by a+
//         |
//         2
MapReport corner() {
  const Trace trace = read_trace_file(std::string(ASTERISM_SOURCE_DIR) +
                                      "/tests/corpus/trace/good/corner.trace.json");
  const std::vector<Arrival> arrivals{
      {PlaceId(0), std::nullopt}, {PlaceId(1), 2U}, {PlaceId(2), 0U}};
  MapReport report;
  report.trace = trace.name;
  report.consistent = 1;
  report.per_visit = {1, 1, 1};
  report.minimal = {3, 3, 1, true};
  report.maps = {make_map(trace, arrivals)};
  return report;
}

PoseCovariance any_covariance(RandomEngine& random) {
  const double across = between(-0.9, 0.9, random);
  return {0.25, 0.05 * across, 0, 0.05 * across, 0.01, 0, 0, 0, uniform(random)};
}

Pose2 any_pose(RandomEngine& random) {
  return {normal(random), 100 * normal(random), between(-3, 3, random)};
}

Misfit any_misfit(RandomEngine& random) {
  if (chance(0.2, random)) return {};
  return {between(0, 30, random), 1 + below(9, random), uniform(random)};
}

/// A map with a layout as chance has it.
RankedMap ranked(const TopologicalMap& map, RandomEngine& random) {
  RankedMap result{map};
  for (std::size_t i = 0; i < map.places.size(); ++i) {
    result.layout.layout_from_place.push_back(any_pose(random));
    result.layout.covariances.push_back(i == 0 ? PoseCovariance{} : any_covariance(random));
  }
  for (std::size_t k = 0; k + 1 < map.visits.size(); ++k) {
    const Pose2 pose = any_pose(random);
    result.displacements.push_back(
        {map.visits[k], map.visits[k + 1], make_displacement(pose, any_covariance(random))});
  }
  for (std::size_t k = 0; k < map.visits.size(); ++k)
    if (map.places[map.visits[k].index()].first_visit.index() != k && chance(0.8, random))
      result.alignments.push_back({VisitId(k), map.visits[k], any_pose(random),
                                   any_covariance(random), any_misfit(random), uniform(random)});
  result.misfit = any_misfit(random);
  result.layout.chi_squared = result.misfit.chi_squared;
  result.log_likelihood = 20 * normal(random);
  result.is_plausible = chance(0.5, random);
  if (!result.is_plausible && map.places.size() > 1)
    for (std::size_t i = 0; i < below(3, random); ++i)
      result.shared_spots.push_back({PlaceId(0),
                                     PlaceId(1 + below(map.places.size() - 1, random)),
                                     uniform(random),
                                     {between(11, 30, random), 1, uniform(random)}});
  return result;
}

/// A walk among places that are joined as chance has it: no axiom is asked, so that paths may meet
/// a place twice or close on themselves.
TopologicalMap random_map(std::mt19937_64& random) {
  static const std::vector<Star> stars{Star::parse("a+1 b+1 a-1 b-1"), Star::parse("a+1 a-1"),
                                       Star::parse("a+1 b-1 a-0 b+1"), Star::parse("a+0 a-1")};
  std::vector<Star> places;
  std::map<PlaceArm, PlaceArm> other_end;
  const auto gateway_of = [&](std::size_t place) {
    const Star& star = places[place];
    std::size_t arm = random() % star.size();
    while (!star.has_gateway(arm)) arm = star.clockwise(arm, 1);
    return PlaceArm{PlaceId(place), arm};
  };
  const auto new_place = [&] {
    places.push_back(stars[random() % stars.size()]);
    return gateway_of(places.size() - 1);
  };

  Trace trace;
  std::vector<Arrival> arrivals;
  PlaceArm entered = new_place();
  for (auto visits = 1 + random() % 20; visits > 0; --visits) {
    const PlaceArm left = gateway_of(entered.place.index());
    trace.visits.push_back(
        {.star = places[entered.place.index()], .entered_by = entered.arm, .left_by = left.arm});
    arrivals.push_back({entered.place, entered.arm});
    const PlaceArm open = gateway_of(random() % places.size());
    if (const auto known = other_end.find(left); known != other_end.end())
      entered = known->second;
    else
      entered = other_end.contains(open) ? new_place() : open;
    other_end.emplace(left, entered);
    other_end.emplace(entered, left);
  }
  return make_map(trace, arrivals);
}

}  // namespace

TEST_CASE("a maps file is written key by key, one line a part of a map", "[io]") {
  CHECK(text_of(corner()) ==
        content(std::string(ASTERISM_SOURCE_DIR) + "/tests/corpus/maps/good/corner.maps.json"));
}

TEST_CASE("maps of the basic SSH are written as they are known", "[io][ssh]") {
  const std::string tests = std::string(ASTERISM_SOURCE_DIR) + "/tests/corpus";
  SshReport report;
  report.experience = std::get<Experience>(
      read_any_trace_file(std::string(ASTERISM_SOURCE_DIR) + "/examples/05_square.trace.json"));
  report.trace = report.experience.name;
  report.options.certify_s = 0;
  report.consistent = 2;
  report.per_visit = {1, 1, 1, 1, 1, 2, 3, 5, 2};
  report.minimal = {4, 4, 1, false};
  std::vector<DStateId> dstates;
  for (const std::size_t dstate : {0U, 1U, 2U, 3U, 4U, 5U, 6U, 7U, 0U})
    dstates.emplace_back(dstate);
  report.maps = {make_ssh_map(report.experience, dstates)};
  CHECK(text_of(report) == content(tests + "/maps/good/ssh_square.maps.json"));
}

TEST_CASE("random maps of the basic SSH are read as they were written", "[io][ssh][property]") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    RandomEngine random(seed);
    SshReport report;
    report.trace = report.experience.name = "t";
    report.options.all = true;
    report.options.theory.preference.clear();
    std::set<std::vector<DStateId>> namings;
    const std::size_t views = 1 + below(8, random);
    for (std::size_t k = 0; k < views; ++k) {
      report.experience.views.push_back("v" + std::to_string(below(3, random)));
      const auto kind = static_cast<Action::Kind>(below(3, random));
      if (k > 0)
        report.experience.actions.push_back({kind, kind == Action::Kind::turn ? "left" : ""});
    }
    for (std::size_t i = 0; i < 3; ++i) {
      std::vector<DStateId> dstates;
      std::size_t known = 0;
      for (std::size_t k = 0; k < views; ++k) {
        dstates.emplace_back(below(known + 1, random));
        if (dstates.back().index() == known) ++known;
      }
      namings.insert(dstates);
    }
    for (const auto& dstates : namings)
      report.maps.push_back(make_ssh_map(report.experience, dstates));
    report.consistent = report.maps.size();
    report.per_visit.emplace(views, report.maps.size());
    report.minimal = {1, 1, report.maps.size(), false};
    INFO(seed);
    CHECK(same(read_any_maps(text_of(report), "again"), report));
  }
}

TEST_CASE("every good maps file is read and written without loss", "[io]") {
  for (const auto& file : good_files("maps")) {
    INFO(file);
    CHECK(is_read_back(
        read_any_maps_file(file), [](const auto& one) { return text_of(one); }, read_any_maps));
  }
}

TEST_CASE("reports are read as they were written", "[io]") {
  MapReport report = corner();
  SECTION("as it is") {}
  SECTION("options") {
    report.options = {.theory = {.planar = true,
                                 .axioms = "my \"axioms\"",
                                 .optional_axioms = {"one_segment"},
                                 .preference = {"place", "path"},
                                 .assumptions = {{Assumption::Kind::same, VisitId(1), VisitId(1)}}},
                      .check = "solver",
                      .certify_s = 0.1,
                      .max_hypotheses = std::numeric_limits<std::uint64_t>::max(),
                      .time_limit_s = 1e-3,
                      .all = true};
  }
  SECTION("stopped") {
    report.complete = false;
    report.stopped_by = "time_limit_s";
    report.per_visit = {1, 1};
  }
  SECTION("nothing listed") {
    report.consistent.reset();
    report.per_visit.reset();
    report.minimal->certified = false;
  }
  SECTION("nothing consistent") {
    report.consistent = 0;
    report.per_visit = {1, 1, 0};
    report.minimal.reset();
    report.maps.clear();
  }
  CHECK(same(read_any_maps(text_of(report), "again"), report));
}

TEST_CASE("what is not UTF-8 or no number is not written", "[io]") {
  MapReport report = corner();
  SECTION("name") { report.trace = "latin 1: \xff"; }
  SECTION("axioms") { report.options.theory.axioms = "cut short: \xc3"; }
  SECTION("infinite") { report.options.certify_s = std::numeric_limits<double>::infinity(); }
  CHECK_THROWS_AS(text_of(report), std::invalid_argument);
}

TEST_CASE("random maps are read as they were written", "[io][property]") {
  const auto seed = GENERATE(range(0U, 300U));
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  MapReport report;
  report.options.theory.axioms = "none";
  report.maps = {random_map(random)};
  report.minimal = {report.maps[0].paths.size(), report.maps[0].places.size(), 1, false};
  CHECK(same(read_any_maps(text_of(report), "again"), report));
  report.ranked = {ranked(report.maps[0], random)};
  CHECK(same(read_any_maps(text_of(report), "again"), report));
}

TEST_CASE("a ranked map is written part by part, one line a pose", "[io]") {
  MapReport report = corner();
  const std::string before = text_of(report);
  RankedMap map{report.maps[0]};
  map.layout = {{{}, {1.5, -2, 0.5}, {3, 0, -1}}, {PoseCovariance{}, {}, {}}, 2.25};
  map.displacements = {{PlaceId(0), PlaceId(1), {1.5, -2, 0.5, {1, 0, 0, 0, 1, 0, 0, 0, 1}}},
                       {PlaceId(1), PlaceId(2), {}}};
  map.misfit = {2.25, 4, 0.5};
  map.log_likelihood = -3;
  report.ranked = {map};
  const std::string zeros = "\"covariance\": [0, 0, 0, 0, 0, 0, 0, 0, 0]";
  const std::string text = text_of(report);
  const std::string start = before.substr(0, before.size() - 3);  // without " }\n"
  REQUIRE(text.starts_with(start + ",\n  \"ranked\": [\n    { \"visits\": [0, 1, 2],\n"));
  CHECK(text.substr(text.find("      \"plausible\"")) ==
        "      \"plausible\": true, \"tail_probability\": 0.5, \"chi_squared\": 2.25, "
        "\"degrees_of_freedom\": 4, \"log_likelihood\": -3,\n"
        "      \"layout\": [\n"
        "        {\"x_m\": 0, \"y_m\": 0, \"heading_rad\": 0, " +
            zeros +
            "},\n"
            "        {\"x_m\": 1.5, \"y_m\": -2, \"heading_rad\": 0.5, " +
            zeros +
            "},\n"
            "        {\"x_m\": 3, \"y_m\": 0, \"heading_rad\": -1, " +
            zeros +
            "}],\n"
            "      \"displacements\": [\n"
            "        {\"from\": 0, \"to\": 1, \"x_m\": 1.5, \"y_m\": -2, \"heading_rad\": 0.5, "
            "\"covariance\": [1, 0, 0, 0, 1, 0, 0, 0, 1]},\n"
            "        {\"from\": 1, \"to\": 2, \"x_m\": 0, \"y_m\": 0, \"heading_rad\": 0, " +
            zeros + "}],\n      \"alignments\": [] } ] }\n");
  CHECK(same(read_any_maps(text, "again"), report));
}

TEST_CASE("a ranked map whose layout is not its own is not written", "[io]") {
  MapReport report = corner();
  RankedMap map{report.maps[0]};
  map.layout = {std::vector<Pose2>(3), std::vector<PoseCovariance>(3), 0};
  map.displacements = {{PlaceId(0), PlaceId(1), {}}, {PlaceId(1), PlaceId(2), {}}};
  report.ranked = {map};
  CHECK_NOTHROW(text_of(report));
  RankedMap& wrong = report.ranked[0];
  SECTION("no layout") { wrong.layout = {}; }
  SECTION("a covariance missing") { wrong.layout.covariances.pop_back(); }
  SECTION("a pose too many") { wrong.layout.layout_from_place.push_back({}); }
  SECTION("no number") { wrong.misfit.chi_squared = std::numeric_limits<double>::quiet_NaN(); }
  SECTION("infinite") { wrong.layout.layout_from_place[1].x_m = HUGE_VAL; }
  CHECK_THROWS_AS(text_of(report), std::invalid_argument);
}

}  // namespace asterism
