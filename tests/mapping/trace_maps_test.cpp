#include "mapping/trace_maps.hpp"

#include <array>
#include <chrono>

#include "axioms/axiom_solver.hpp"
#include "engine/proof/certify.hpp"
#include "io/json/expect_file.hpp"
#include "mapping/own_process.hpp"
#include "tests/mapping/shipped_trace.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

using Counts = std::vector<std::uint64_t>;

std::vector<std::vector<PlaceId>> visits_of(const MapReport& report) {
  std::vector<std::vector<PlaceId>> result;
  for (const TopologicalMap& map : report.maps) result.push_back(map.visits);
  return result;
}

Stop at_once() { return {.deadline = std::chrono::steady_clock::now()}; }

}  // namespace

TEST_CASE("the maps of a trace are as many as are expected of it", "[mapping][unit]") {
  const bool planar = GENERATE(false, true);
  const Expectation expected =
      read_expect_file(ASTERISM_SOURCE_DIR "/examples/aces-stubs.expect.json");
  const Expectation::Counts& counts = *expected.cases[planar ? 1 : 0].counts;
  TraceMaps maps(shipped_trace("aces-stubs"), {.planar = planar}, {});
  CHECK(maps.find() == std::nullopt);
  CHECK_FALSE(maps.are_searched());
  CHECK(maps.per_visit() == counts.per_visit);
  CHECK(maps.consistent() == counts.per_visit.back());
  CHECK(maps.list().size == counts.per_visit.back());
  const MapReport report = maps.report();
  CHECK(report.complete);
  CHECK(report.trace == "aces-stubs");
  CHECK(report.minimal->paths == counts.minimal->paths);
  CHECK(report.minimal->places == counts.minimal->places);
  CHECK(visits_of(report) == counts.minimal->visits);
}

TEST_CASE("minimal models are searched for where they are enough, and are those listed",
          "[mapping][unit]") {
  const Trace trace = shipped_trace("aces-stubs");
  TraceMaps listed(trace, {}, {});
  TraceMaps searched(trace, {}, {}, true, 2);
  listed.find();
  searched.find();
  REQUIRE(searched.are_searched());
  CHECK(visits_of(searched.report()) == visits_of(listed.report()));
  CHECK(searched.list().size == listed.minimal().size);
  CHECK(searched.consistent() == std::nullopt);
  CHECK(searched.per_visit().empty());
  CHECK(searched.explained_visits() == trace.visits.size());
}

TEST_CASE("the tree lists the maps where others decide or are to be counted", "[mapping][unit]") {
  const Trace trace = shipped_trace("04_ring");
  CHECK_FALSE(TraceMaps(trace, {}, {.check = "both"}, true).are_searched());
  CHECK_FALSE(TraceMaps(trace, {}, {.max_hypotheses = 100}, true).are_searched());
  TraceMaps checked(trace, {}, {.check = "both"}, true);
  CHECK(checked.find() == std::nullopt);
  CHECK(checked.list().size == 1);
  CHECK(checked.consistent() == 6);
}

TEST_CASE("a limit on maps ends the growth on a whole level", "[mapping][unit]") {
  TraceMaps maps(shipped_trace("aces-stubs"), {}, {.max_hypotheses = 5});
  CHECK(maps.find() == "limit of 5 hypotheses");
  CHECK(maps.per_visit() == Counts{1, 1, 1, 1, 2, 1, 2, 4, 3, 2});
  const MapReport report = maps.report();
  CHECK_FALSE(report.complete);
  CHECK(report.stopped_by == "limit of 5 hypotheses");
  CHECK(report.consistent == std::nullopt);
  CHECK(report.maps.empty());
}

TEST_CASE("what is stopped at once reports nothing as known", "[mapping][unit]") {
  const bool only_minimal = GENERATE(false, true);
  TraceMaps maps(shipped_trace("aces-stubs"), {}, {}, only_minimal);
  CHECK(maps.find(at_once()) == "time limit");
  CHECK_FALSE(maps.report().complete);
  CHECK(maps.report().minimal == std::nullopt);
}

TEST_CASE("a watcher stops the work by what it says", "[mapping][unit]") {
  TraceMaps maps(shipped_trace("aces-stubs"), {}, {.max_hypotheses = 1000});
  Stop stop;
  stop.watch = [](const Standing& now) {
    return now.visit == 10 ? std::optional<std::string>("enough") : std::nullopt;
  };
  CHECK(maps.find(stop) == "enough");
  CHECK(maps.per_visit().size() == 10);
}

TEST_CASE("the part of a trace that a map explains is kept", "[mapping][unit]") {
  const bool only_minimal = GENERATE(false, true);
  // The first travel leads from one place to another, whatever the map.
  const Assumption impossible{Assumption::Kind::same, VisitId(0), VisitId(1)};
  TraceMaps maps(shipped_trace("aces-stubs"), {.assumptions = {impossible}}, {}, only_minimal);
  CHECK(maps.find() == std::nullopt);
  CHECK(maps.consistent() == 0);
  CHECK(maps.report().maps.empty());
  REQUIRE(maps.explained_visits() == 1);
  maps.keep_explained();
  CHECK(maps.trace().visits.size() == 1);
  CHECK(maps.minimal().size == 1);
}

TEST_CASE("the solver certifies the minimal models, listed or searched for", "[mapping][unit]") {
  const bool only_minimal = GENERATE(false, true);
  TraceMaps maps(shipped_trace("04_ring"), {}, {}, only_minimal);
  maps.find();
  CHECK(maps.are_certified({}));
}

TEST_CASE("models that are not the minimal ones are refuted", "[mapping][unit]") {
  const Trace trace = shipped_trace("04_ring");
  std::vector<Arrival> largest;
  for (std::size_t k = 0; k < trace.visits.size(); ++k)
    largest.push_back({PlaceId(k), trace.visits[k].entered_by});
  CHECK_THROWS_AS(is_certified(trace, {}, {largest}, {}), std::logic_error);
  CHECK_FALSE(is_certified(trace, {}, {largest}, {}, true));
}

/// Back and forth between two dead ends.
Trace shuttle(std::size_t visits) {
  const Star dead_end = Star::parse("a+1 a-0");
  Trace trace;
  for (std::size_t k = 0; k < visits; ++k) {
    Visit visit{.star = dead_end};
    if (k > 0) visit.entered_by = 0;
    if (k + 1 < visits) visit.left_by = 0;
    trace.visits.push_back(visit);
  }
  return trace;
}

TEST_CASE("a certification keeps to its seconds, and is not shown then", "[mapping][unit]") {
  TraceMaps maps(shuttle(500), {}, {});  // Z3 would look at the clock after minutes
  maps.find();
  CHECK(maps.minimal().size == 1);
  const Deadline late = deadline_in(30);
  CHECK_FALSE(maps.are_certified({.deadline = deadline_in(0.5)}));
  CHECK_FALSE(is_over(late));
}

TEST_CASE("a certification without memory has found nothing", "[mapping][unit]") {
  const Trace trace = shuttle(100);
  std::vector<Arrival> model;
  for (std::size_t k = 0; k < trace.visits.size(); ++k)
    model.push_back({PlaceId(k % 2), trace.visits[k].entered_by});
  const auto work = [&]() -> std::string {
    limit_solver_memory(std::uint64_t{64} << 20);
    certify(trace, {}, std::array{model}, {});
    return "enough";
  };
  CHECK(in_own_process(work, Deadline::max()) == std::nullopt);
}

TEST_CASE("the other view on planarity counts the other maps", "[mapping][unit]") {
  TraceMaps maps(shipped_trace("aces-stubs"), {.planar = true}, {});
  maps.find();
  TraceMaps other = maps.under_other_view();
  other.find();
  CHECK(maps.per_visit().back() == 55);
  CHECK(other.per_visit().back() == 107);
  CHECK_FALSE(other.theory().planar);
}
