#include "perception/detector_laws.hpp"

#include <functional>
#include <limits>

#include "perception/checked_detector.hpp"
#include "tests/perception/messages.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

using Visits = std::vector<DetectedVisit>;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Ten scans, half a second apart.
std::vector<Scan> ten_scans() {
  std::vector<Scan> scans;
  for (long long number = 0; number < 10; ++number)
    scans.push_back({.number = number, .stamp_s = 0.5 * static_cast<double>(number)});
  return scans;
}

/// Hands each visit over when it is given the last scan of it.
class ScriptedDetector : public PlaceDetector {
 public:
  explicit ScriptedDetector(Visits visits) : visits_(std::move(visits)) {}
  std::string_view name() const noexcept override { return "scripted"; }
  std::optional<DetectedVisit> observe(const Scan& scan) override {
    if (next_ == visits_.size() || (*visits_[next_].visit.scans)[1] != scan.number)
      return std::nullopt;
    return visits_[next_++];
  }
  std::optional<DetectedVisit> finish() override { return std::nullopt; }

 private:
  Visits visits_;
  std::size_t next_ = 0;
};

std::vector<std::string> laws_broken_by(const Visits& visits) {
  DetectorLaws laws;
  for (const Scan& scan : ten_scans()) laws.fed(scan);
  std::vector<std::string> broken;
  for (const auto& visit : visits)
    for (const auto& law : laws.broken_by(visit)) broken.push_back(law);
  return broken;
}

/// A T, fully measured:   a+ ahead at (1, 0), b- closed to the left,
///                        a- behind at (-1, 0), b+ to the right at (0, -1).
DetectedVisit lawful_visit(long long first, long long last) {
  DetectedVisit seen{{.star = Star::parse("a+1 b+1 a-1 b-0"), .entered_by = 2, .left_by = 0}};
  seen.visit.scans = {first, last};
  seen.visit.stamps_s = {0.5 * static_cast<double>(first), 0.5 * static_cast<double>(last)};
  seen.visit.gateways = {{"a+", 1, 0, 0, 2}, {"a-", -1, 0, 3.14, 2}, {"b+", 0, -1, -1.57, 2}};
  seen.visit.displacement = make_displacement({1, 2, 3}, diagonal(1, 1));
  seen.place_map = Grid{2, 2, 1, {-1, -1}, {0, 1, 2, 3}};
  return seen;
}

Visits lawful() { return {lawful_visit(0, 2), lawful_visit(4, 4), lawful_visit(5, 9)}; }

}  // namespace

TEST_CASE("a lawful drive breaks no law", "[perception][laws]") {
  CHECK(laws_broken_by(lawful()).empty());

  auto bare = lawful();
  for (auto& seen : bare) seen = {{.star = seen.visit.star, .entered_by = 1, .left_by = 1}};
  bare.front().visit.entered_by.reset();
  bare.back().visit.left_by.reset();
  CHECK(laws_broken_by(bare).empty());
}

TEST_CASE("each law is broken by the visit that breaks it", "[perception][laws]") {
  struct Case {
    std::string broken;
    std::function<void(Visits&)> change;
  };
  const auto [broken, change] = GENERATE(values<Case>({
      {"visit 1/entered_by: found nothing; expected an arm",
       [](Visits& v) { v[1].visit.entered_by.reset(); }},
      {"visit 1/entered_by: found b-, which has no gateway; expected an arm with α = 1",
       [](Visits& v) { v[1].visit.entered_by = 3; }},
      {"visit 0/left_by: found arm 4; expected one of 4",
       [](Visits& v) { v[0].visit.left_by = 4; }},
      {"visit 2: found a visit after one without left_by; expected only the last without it",
       [](Visits& v) { v[1].visit.left_by.reset(); }},
      {"visit 1/scans: found last 3 before first 4; expected first, last",
       [](Visits& v) {
         v[1].visit.scans = {4, 3};
       }},
      {"visit 1/scans: found first 2; expected a scan after 2, where the visit before ended",
       [](Visits& v) {
         v[1].visit.scans = {2, 4};
       }},
      {"visit 2/scans: found scan 10; expected a scan that was given so far",
       [](Visits& v) {
         v[2].visit.scans = {5, 10};
       }},
      {"visit 0/scans: found scan -1; expected a scan that was given so far",
       [](Visits& v) {
         v[0].visit.scans = {-1, 2};
       }},
      {"visit 1/stamps_s: found 2.000000, 2.500000; expected 2.000000, 2.000000, those of its "
       "scans",
       [](Visits& v) {
         v[1].visit.stamps_s = {2, 2.5};
       }},
      {"visit 2/gateways: found \"b-\"; expected an arm of the star with α = 1",
       [](Visits& v) { v[2].visit.gateways[2].arm = "b-"; }},
      {"visit 2/gateways: found \"c?\"; expected an arm of the star with α = 1",
       [](Visits& v) { v[2].visit.gateways[2].arm = "c\n"; }},
      {"visit 0/gateways: found \"a+\" again; expected each arm once",
       [](Visits& v) { v[0].visit.gateways[1].arm = "a+"; }},
      {"visit 0/gateways: found \"a+\" without finite pose and positive width; expected both",
       [](Visits& v) { v[0].visit.gateways[0].width_m = 0; }},
      {"visit 0/gateways: found \"a+\" without finite pose and positive width; expected both",
       [](Visits& v) { v[0].visit.gateways[0].heading_rad = no_number; }},
      {"visit 1/gateways: found gateways in another order; expected the star's, clockwise",
       [](Visits& v) { v[1].visit.gateways[2].y_m = 1; }},  // mirrored
      {"visit 2/displacement: found nothing; expected one, as before",
       [](Visits& v) { v[2].visit.displacement.reset(); }},
      {"visit 2/displacement: found one; expected none, as before",
       [](Visits& v) { v[1].visit.displacement.reset(); }},
      {"visit 1/displacement: found a number that is not finite; expected a pose",
       [](Visits& v) { v[1].visit.displacement->x_m = no_number; }},
      {"visit 1/displacement/covariance: found an asymmetric or indefinite matrix; expected a "
       "symmetric, positive semi-definite matrix, row by row",
       [](Visits& v) { v[1].visit.displacement->covariance[1] = 0.5; }},
      {"visit 1/displacement/covariance: found an asymmetric or indefinite matrix; expected a "
       "symmetric, positive semi-definite matrix, row by row",
       [](Visits& v) {
         v[1].visit.displacement->covariance = {0, no_number, 0, 0, 1, 0, 0, 0, 1};
       }},
      {"visit 0/place_map: found 3 cells; expected 2 x 2 of positive size",
       [](Visits& v) { v[0].place_map->log_odds.pop_back(); }},
      {"visit 0/place_map: found log-odds that are no number; expected numbers",
       [](Visits& v) { v[0].place_map->log_odds[0] = std::numeric_limits<float>::quiet_NaN(); }},
      {"visit 0/place_map: found a map without the origin of the visit's frame; expected the "
       "origin inside",
       [](Visits& v) {
         v[0].place_map->frame_from_grid = {-2, -1, 0};
       }},
      {"visit 0/lpm: found a file beside the place map; expected one of the two",
       [](Visits& v) { v[0].visit.lpm = "lpm.json"; }},
  }));
  auto visits = lawful();
  change(visits);
  CAPTURE(broken);
  const auto found = laws_broken_by(visits);
  REQUIRE_FALSE(found.empty());
  CHECK(found.front() == broken);
}

TEST_CASE("gateways may stand clockwise round their middle or round the origin",
          "[perception][laws]") {
  auto visits = lawful();
  // All of them to the left of the robot, which has just come in.
  for (auto& gateway : visits[0].visit.gateways) gateway.y_m += 5;
  CHECK(laws_broken_by(visits).empty());
  // The same star listed from another arm.
  visits[0].visit.star = Star::parse("b+1 a-1 b-0 a+1");
  visits[0].visit.entered_by = 0;
  visits[0].visit.left_by = 0;
  CHECK(laws_broken_by(visits).empty());
}

TEST_CASE("stamps may run backwards", "[perception][laws]") {
  DetectorLaws laws;
  laws.fed({.number = 0, .stamp_s = 7});
  laws.fed({.number = 1, .stamp_s = 6});
  DetectedVisit seen{{.star = Star::parse("a+1 a-1")}};
  seen.visit.scans = {0, 1};
  seen.visit.stamps_s = {6, 7};
  CHECK(laws.broken_by(seen).empty());
}

TEST_CASE("there are no more visits than scans", "[perception][laws]") {
  DetectorLaws laws;
  CHECK(laws.broken_by({{.star = Star::parse("a+1 a-1")}}) ==
        std::vector<std::string>{
            "visit 0: found more visits than the 0 scans; expected one a scan at most"});
}

TEST_CASE("a checked detector hands lawful visits on and stops at the first that is not",
          "[perception][laws]") {
  const auto scans = ten_scans();
  CHECK(visits_of(*checked(std::make_unique<ScriptedDetector>(lawful()), "it"), scans) == lawful());

  auto visits = lawful();
  visits[1].visit.entered_by.reset();
  const auto detector = checked(std::make_unique<ScriptedDetector>(visits), "it");
  CHECK(complaint_of([&] { visits_of(*detector, scans); }) ==
        "it: visit 1/entered_by: found nothing; expected an arm");
}

TEST_CASE("a detector that keeps the laws passes its runs", "[perception][laws]") {
  const auto lawful_detector = [] { return std::make_unique<ScriptedDetector>(lawful()); };
  CHECK(broken_laws(lawful_detector, ten_scans()) == std::vector<std::string>{});
  CHECK(broken_laws(lawful_detector, {}) == std::vector<std::string>{});
}

TEST_CASE("a detector whose runs differ is found out", "[perception][laws]") {
  // The runs: the whole drive, again, its first quarter, half and three quarters.
  const auto [odd_run, broken] = GENERATE(table<int, std::string>({
      {1, "determinism: found other visits in a second run; expected the same"},
      {3, "prefix: the first 5 scans: found other visits; expected those of the whole drive"},
  }));
  int runs = 0;
  const auto found = broken_laws(
      [&runs, run = odd_run] {
        auto visits = lawful();
        if (runs++ == run) visits[1].visit.left_by = 1;
        return std::make_unique<ScriptedDetector>(visits);
      },
      ten_scans());
  CHECK(found == std::vector<std::string>{broken});
}

TEST_CASE("a detector that tells less or more of a part of the drive is found out",
          "[perception][laws]") {
  const auto [whole, part] = GENERATE(table<std::ptrdiff_t, std::ptrdiff_t>({{3, 1}, {1, 2}}));
  int runs = 0;
  const auto found = broken_laws(
      [&runs, of_whole = whole, of_part = part] {
        auto visits = lawful();
        visits.erase(visits.begin() + (runs++ == 4 ? of_part : of_whole), visits.end());
        return std::make_unique<ScriptedDetector>(visits);
      },
      ten_scans());
  CHECK(found == std::vector<std::string>{"prefix: the first 7 scans: found other visits; expected "
                                          "those of the whole drive"});
}

TEST_CASE("a plug-in error in a run is a law broken", "[perception][laws]") {
  const auto found = broken_laws(
      []() -> std::unique_ptr<PlaceDetector> { throw PluginError("it: found smoke"); }, {});
  REQUIRE_FALSE(found.empty());
  CHECK(found.front() == "it: found smoke");
}

}  // namespace asterism
