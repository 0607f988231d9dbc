#include "io/picture/report_page.hpp"

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

#include "drawing/plane_drawing.hpp"
#include "io/picture/map_svg.hpp"
#include "io/picture/plan_picture.hpp"
#include "simulation/grid_world.hpp"
#include "simulation/walk.hpp"
#include "tests/io/picture/xml_check.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Free inside, a wall round it.
Grid room(double side_m, const Pose2& frame_from_grid) {
  Grid grid{.width = static_cast<int>(side_m / 0.1), .resolution_m = 0.1};
  grid.height = grid.width;
  grid.frame_from_grid = frame_from_grid;
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      const bool is_wall = std::min(row, column) == 0 || std::max(row, column) == grid.width - 1;
      grid.log_odds.push_back(is_wall ? 4.0F : -3.0F);
    }
  }
  return grid;
}

/// Everything there can be on a page, of a walk in a world; the layout is where the places are.
RunReport random_report(std::uint64_t seed) {
  RandomEngine engine(seed);
  const World world = grid_world({.width = 3, .height = 3, .min_places = 3}, engine);
  Walk walk = asterism::walk(world, {.travels = 1 + below(20, engine)}, engine);
  RunReport report{.log = "walk", .trace = walk.trace};
  for (Visit& visit : report.trace.visits) {
    for (std::size_t arm = 0; arm < visit.star.size(); ++arm) {
      const double heading_rad =
          -6.28 * static_cast<double>(arm) / static_cast<double>(visit.star.size());
      const Point2 at = 2 * unit_vector(heading_rad);
      if (visit.star.has_gateway(arm))
        visit.gateways.push_back({visit.star.name(arm), at.x_m, at.y_m, heading_rad, 1.5});
    }
    report.place_maps.push_back(room(8, {-4, -4, 0}));
  }
  report.odometry_map = room(30, {-5, -25, 0});
  report.all_per_visit.assign(report.trace.visits.size(), 3);
  report.planar_per_visit.assign(report.trace.visits.size(), 2);
  report.consistent = 3;
  report.minimal = MapReport::Minimal{2, 3, 1, true};
  report.decided = {{"axioms", "dropped at once", 12345}, {"likelihood", "the likelier first", {}}};
  for (int i = 0; i < 2; ++i) {
    RunReport::Model model{.ranked = {.map = make_map(report.trace, walk.truth)}};
    RankedMap& ranked = model.ranked;
    const TopologicalMap& map = ranked.map;
    for (const TopologicalMap::Place& place : map.places) {
      const std::string& number = *report.trace.visits[place.first_visit.index()].true_place;
      const Point2 at = world.places[std::stoul(number)].position;
      ranked.layout.layout_from_place.push_back({at.x_m, at.y_m, between(-3, 3, engine)});
      ranked.layout.covariances.push_back({0.2, 0.1, 0, 0.1, 0.3, 0, 0, 0, 0.01});
      model.trajectory.push_back({0, ranked.layout.layout_from_place.back()});
    }
    for (std::size_t k = 0; k + 1 < map.visits.size(); ++k)
      ranked.displacements.push_back({map.visits[k], map.visits[k + 1], {.x_m = 10}});
    for (std::size_t k = 0; k < map.visits.size(); ++k) {
      if (map.places[map.visits[k].index()].first_visit.index() == k) continue;
      ranked.alignments.push_back({.visit = VisitId(k), .place = map.visits[k]});
    }
    ranked.log_likelihood = -10 * i;
    model.global_map = room(30, {-5, -25, 0.1});
    model.drawing_svg = bare_map_svg(map, draw(map), "drawing");
    report.models.push_back(std::move(model));
  }
  return report;
}

/// What stands in the page from one mark to the next.
std::string part(const std::string& page, const std::string& from, const std::string& to) {
  const std::size_t begin = page.find(from);
  REQUIRE(begin != std::string::npos);
  const std::size_t end = page.find(to, begin);
  REQUIRE(end != std::string::npos);
  return page.substr(begin, end - begin);
}

/// All numbers that a pattern's groups find.
std::vector<std::vector<double>> numbers(const std::string& text, const std::string& pattern) {
  std::vector<std::vector<double>> result;
  const std::regex regex(pattern);
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match) {
    result.emplace_back();
    for (std::size_t i = 1; i < match->size(); ++i) result.back().push_back(std::stod((*match)[i]));
  }
  return result;
}

/// A page without the files in it, which regular expressions find too long.
std::string without_data(std::string page) {
  constexpr std::string_view mark = ";base64,";
  for (std::size_t at = page.find(mark); at != std::string::npos; at = page.find(mark, at + 1))
    page.erase(at + mark.size(), page.find('"', at) - at - mark.size());
  return page;
}

}  // namespace

TEST_CASE("the page of any walk is well-formed, whole and alone", "[io][property]") {
  const RunReport report = random_report(GENERATE(range(1U, 30U)));
  const std::string page = run_report_html(report);
  CHECK(is_well_formed(page));
  for (std::size_t rank = 1; rank <= report.models.size(); ++rank)
    CHECK(has(page, "id=\"rank-" + std::to_string(rank) + "\""));
  for (std::size_t k = 0; k < report.trace.visits.size(); ++k) {
    CHECK(count_of(page, "id=\"visit-" + std::to_string(k) + "\"") == 1);
    CHECK(has(page, "href=\"#visit-" + std::to_string(k) + "\""));
  }
  // No script, nothing to fetch, nothing that went wrong on the way to text.
  const std::string text = without_data(page);
  CHECK_FALSE(has(text, "<script"));
  CHECK(count_of(text, "http") == count_of(text, "xmlns=\"http"));
  CHECK(count_of(text, "src=\"") == count_of(text, "src=\"data:"));
  for (const char* wrong : {"nan", "inf ", "inf\"", "inf,"}) CHECK_FALSE(has(text, wrong));
}

TEST_CASE("no name on the page is given twice", "[io]") {
  const std::string page = without_data(run_report_html(random_report(1)));
  std::set<std::string> ids;
  const std::regex id(" id=\"([^\"]*)\"");
  for (std::sregex_iterator match(page.begin(), page.end(), id), end; match != end; ++match)
    CHECK(ids.insert((*match)[1]).second);
  CHECK(ids.size() > 3);
}

TEST_CASE("the same run gives the same page", "[io]") {
  CHECK(run_report_html(random_report(2)) == run_report_html(random_report(2)));
}

TEST_CASE("names are text, whatever is in them", "[io]") {
  RunReport report = random_report(3);
  const std::string name = "<i>\"a\" & b</i>";
  report.log = name;
  report.decided = {{name, name, 1}};
  report.unexplained = {1, name};
  report.trace.visits[0].gateways[0].arm = name;
  for (RunReport::Model& model : report.models) model.drawing_svg = name;
  const std::string page = run_report_html(report);
  CHECK(is_well_formed(page));
  CHECK_FALSE(has(page, "<i>\""));
  CHECK(count_of(page, "&lt;i&gt;&quot;a&quot; &amp; b&lt;/i&gt;") >= 6);
}

TEST_CASE("a report shows what there is", "[io]") {
  RunReport report = random_report(4);
  SECTION("no ranked model") {
    report.models.clear();
    CHECK(has(run_report_html(report), "none was laid out"));
    CHECK_FALSE(has(run_report_html(report), "Ranked models"));
  }
  SECTION("no map explains the trace") {
    report.unexplained = {1, "no place has its star"};
    CHECK(has(run_report_html(report),
              "the first 1 can be explained, the next cannot, no place has its star"));
    CHECK(has(run_report_html(report), "class=\"warning\""));
  }
  SECTION("a limit ended the run") {
    report.consistent.reset();
    report.unexplained = {1, "limit of 9 hypotheses"};
    CHECK(has(run_report_html(report), "The maps of the first 1 of"));
    CHECK(has(run_report_html(report), "visits are known; limit of 9 hypotheses"));
  }
  SECTION("one visit, nothing else") {
    report = {.log = "one", .trace = {}};
    report.trace.visits = {{.star = Star::parse("a+1 a-0")}};
    CHECK(has(run_report_html(report), "a+1 a-0"));
  }
  SECTION("a map of the first visit alone") {
    report.models.resize(1);
    RankedMap& ranked = report.models[0].ranked;
    ranked = {.map = make_map(report.trace, std::vector<Arrival>{{PlaceId(0), {}}})};
    ranked.layout.layout_from_place = {{}};
    report.models[0].global_map = {};
    CHECK(has(run_report_html(report), "1 place "));
  }
  SECTION("a global map that knows nothing") {
    report.models[0].global_map->log_odds.assign(report.models[0].global_map->log_odds.size(), 0);
    report.models[0].trajectory.clear();
  }
  CHECK(is_well_formed(run_report_html(report)));
}

TEST_CASE("places on one spot are named, with the visits that ought to be one and a picture",
          "[io]") {
  RunReport report = random_report(5);
  RankedMap& best = report.models[0].ranked;
  REQUIRE(best.map.places.size() > 1);
  CHECK_FALSE(has(run_report_html(report), "lie on one spot"));
  best.shared_spots = {{PlaceId(0), PlaceId(1), 0.024, {40, 1, 3e-10}}};
  best.is_plausible = false;
  const std::string page = run_report_html(report);
  CHECK(has(page, "not plausible, since places 0 and 1 lie on one spot, 0.02 m apart"));
  CHECK(has(page, "ought to be one place (tail probability under 10⁻⁹)"));
  CHECK(has(page, "<title>places 0 and 1 lie on one spot, 0.02 m apart</title>"));
  CHECK(has(page, "gateways of place 0 orange, of place 1 blue"));
  CHECK(is_well_formed(page));
}

TEST_CASE("what a reader should know stands first", "[io]") {
  RunReport report = random_report(5);
  report.remarks = {"odometry jumps 3.0 m & more"};
  CHECK(has(run_report_html(report), "<p class=\"warning\">odometry jumps 3.0 m &amp; more.</p>"));
}

TEST_CASE("the verdict names what set the best map apart", "[io]") {
  RunReport report = random_report(5);
  RankedMap& next = report.models[1].ranked;
  CHECK(has(run_report_html(report), "it is 22\u202f000 times as likely as the next"));
  next.log_likelihood = 0;
  CHECK(has(run_report_html(report), "the next is as likely"));
  next.map.paths.push_back(next.map.paths.front());
  CHECK(has(run_report_html(report), "it is simpler than the next"));
  next.map.paths.pop_back();
  next.map.paths.pop_back();
  CHECK(has(run_report_html(report), "fits worse what was measured"));
  next.is_plausible = false;
  CHECK(has(run_report_html(report), "the next is not plausible"));
  report.models[0].ranked.misfit.tail_probability = 3e-8;
  CHECK(has(run_report_html(report), "(tail probability 3·10⁻⁸)"));
}

TEST_CASE("the overlay puts places where the layout says and the grid has them", "[io]") {
  const RunReport report = random_report(GENERATE(range(6U, 12U)));
  const std::string svg =
      without_data(part(run_report_html(report), "<title>global map", "</svg>"));
  const std::string number = "(-?[0-9.]+)";
  const auto discs = numbers(svg, "<text class=\"place\" x=\"" + number + "\" y=\"" + number);
  const RankedMap& ranked = report.models[0].ranked;
  REQUIRE(discs.size() == ranked.map.places.size());

  // The bar's length tells the scale.
  const auto bar = numbers(svg, "class=\"scale\" d=\"M2 [0-9.]+v8m0 -4H" + number);
  const auto bar_m = numbers(svg, ">" + number + " m</text>");
  REQUIRE(bar.size() == 1);
  const double px_per_m = (bar[0][0] - 2) / bar_m.at(0)[0];

  // The picture's matrix tells where cells lie, from the upper left of those shown.
  const auto matrix = numbers(svg, "<image width=\"" + number + "\" height=\"" + number +
                                       "\"[^>]*matrix\\(" + number + " " + number + " " + number +
                                       " " + number + " " + number + " " + number);
  REQUIRE(matrix.size() == 1);
  const Grid& grid = *report.models[0].global_map;
  REQUIRE(matrix[0][1] == grid.height);
  for (std::size_t p = 0; p < discs.size(); ++p) {
    const Point2 at = ranked.layout.layout_from_place[p].position();
    const Point2 first = ranked.layout.layout_from_place[0].position();
    constexpr double rounding_px = 0.3;  // coordinates are written to a tenth
    CHECK(discs[p][0] - discs[0][0] == Approx(px_per_m * (at - first).x_m).margin(rounding_px));
    CHECK(discs[p][1] - discs[0][1] == Approx(-px_per_m * (at - first).y_m).margin(rounding_px));

    const Point2 in_grid = inverse(grid.frame_from_grid) * at;
    const double right = in_grid.x_m / grid.resolution_m;
    const double down = grid.height - in_grid.y_m / grid.resolution_m;
    const std::vector<double>& m = matrix[0];
    CHECK(discs[p][0] == Approx(m[2] * right + m[4] * down + m[6]).margin(rounding_px));
    constexpr double text_px = 4;  // a number stands that far below its middle
    CHECK(discs[p][1] - text_px == Approx(m[3] * right + m[5] * down + m[7]).margin(rounding_px));
  }
}

TEST_CASE("the overlay shows the ways driven, dead ends, start and robot", "[io]") {
  RunReport report = random_report(8);
  RunReport::Model& best = report.models[0];
  const auto overlay = [&] { return part(run_report_html(report), "<title>global map", "</svg>"); };
  const std::string straight = overlay();
  CHECK(count_of(straight, "class=\"segment\"") == best.ranked.map.segments.size());
  CHECK(count_of(straight, "class=\"start\"") == 1);
  CHECK(count_of(straight, "class=\"robot\"") == 1);
  std::size_t dead_ends = 0;
  for (const TopologicalMap::Place& place : best.ranked.map.places)
    for (std::size_t arm = 0; arm < place.star.size(); ++arm)
      dead_ends += !place.star.has_gateway(arm);
  CHECK(dead_ends > 0);
  CHECK(count_of(straight, "class=\"dead-end\"") == dead_ends);
  for (const auto& [one, other] : best.ranked.map.segments) {
    const auto at = [&](PlaceArm arm) {
      return best.ranked.layout.layout_from_place[arm.place.index()].position();
    };
    best.ways.push_back({{at(one), at(one) + Point2{3, 7}, at(other)}, 20, 2});
  }
  const std::string driven = overlay();
  CHECK(driven != straight);
  CHECK(count_of(driven, "class=\"segment\"") == best.ranked.map.segments.size());
}

TEST_CASE("a label keeps off the discs and the labels before it, where it can", "[io]") {
  PlanBounds shown;
  shown.include(Point2{0, 0}, 10);
  PlanPicture picture(shown, 400, 400);
  const PlanPicture::Gateway gateway{.outward_rad = 0, .width_m = 2, .colour = "#000000"};
  const auto labels = [&](const std::string& name) {
    const std::string number = "(-?[0-9.]+)";
    return numbers(picture.svg(""), "<text x=\"" + number + "\" y=\"" + number + "\"[^>]*>" + name);
  };
  picture.add_label_beside(gateway, "one");
  picture.add_label_beside(gateway, "two");
  picture.add_place({1, 3.2}, 0, {});  // over a third label's spots to the left
  picture.add_label_beside(gateway, "six");
  const double middle = 200;
  CHECK(labels("one").at(0)[1] < middle);  // the left is up
  CHECK(labels("two").at(0)[1] > middle);
  const auto third = labels("six").at(0);
  for (const auto& taken : {labels("one").at(0), labels("two").at(0)})
    CHECK(std::hypot(third[0] - taken[0], third[1] - taken[1]) > 11);
}

TEST_CASE("visits that differ from the best map's are marked", "[io]") {
  RunReport report = random_report(6);
  CHECK_FALSE(has(run_report_html(report), " other\">"));
  report.models[1].ranked.map.visits.back() = PlaceId(0);
  report.models[0].ranked.map.visits.back() = PlaceId(1);
  CHECK(count_of(run_report_html(report), " other\">") == 1);
}

TEST_CASE("a model that does not fit its trace is refused", "[io]") {
  RunReport report = random_report(7);
  SECTION("too few poses") { report.models[1].ranked.layout.layout_from_place.pop_back(); }
  SECTION("too many visits") { report.trace.visits.pop_back(); }
  CHECK_THROWS_AS(run_report_html(report), std::invalid_argument);
}
