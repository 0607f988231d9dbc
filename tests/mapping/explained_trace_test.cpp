#include "mapping/explained_trace.hpp"

#include <chrono>

#include "tests/mapping/shipped_trace.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

TEST_CASE("a trace is explained by all of its maps, their minimal models certified",
          "[mapping][unit]") {
  const Trace trace = shipped_trace("aces-stubs");
  std::vector<std::string> told;
  MapWatch watch;
  watch.found = [&](const std::string& what) { told.push_back(what); };
  const ExplainedTrace explained = explain_trace(trace, {}, {}, false, watch);
  CHECK(explained.report.consistent == 107);
  CHECK(explained.report.minimal->certified);
  CHECK(explained.report.explained_visits == std::nullopt);
  CHECK(explained.other_per_visit.back() == 55);
  CHECK(explained.why.empty());
  CHECK(told == std::vector<std::string>{"certifying the minimal models"});
}

TEST_CASE("where no map explains a trace, the part explained is told and why it ends",
          "[mapping][unit]") {
  const bool only_minimal = GENERATE(false, true);
  const Trace trace = shipped_trace("aces-stubs");
  const Theory theory{.assumptions = {{Assumption::Kind::same, VisitId(0), VisitId(1)}}};
  const ExplainedTrace explained = explain_trace(trace, theory, {}, only_minimal);
  CHECK(explained.report.consistent == 0);
  CHECK(explained.report.complete);
  CHECK(explained.report.explained_visits == 1);
  CHECK(explained.maps.trace().visits.size() == 1);
  CHECK(explained.other_per_visit.empty() == only_minimal);
  const TopologicalMap first = make_map(trace, std::vector<Arrival>{{PlaceId(0), std::nullopt}});
  CHECK(why_no_more(trace, first, theory) ==
        "visit 1 is at no place, known or new, assuming same(0, 1)");
}

TEST_CASE("a visit that came by a known way, and saw another star there, is told with both",
          "[mapping][unit]") {
  // Out and back along one corridor: the way back leads to the first place, a crossing.
  Trace trace = shipped_trace("01_corner");
  trace.visits.erase(trace.visits.begin() + 2, trace.visits.end());
  trace.visits[1].left_by = trace.visits[1].entered_by;
  trace.visits.push_back(
      {.star = trace.visits[1].star, .entered_by = trace.visits[1].entered_by, .left_by = {}});
  const ExplainedTrace explained = explain_trace(trace, {}, {}, false);
  REQUIRE(explained.report.explained_visits == 2);
  const TopologicalMap map = make_map(
      trace,
      std::vector<Arrival>{{PlaceId(0), std::nullopt}, {PlaceId(1), trace.visits[1].entered_by}});
  const std::string why = why_no_more(trace, map, {});
  CHECK(
      why.starts_with("visit 2 came by the known way from the place of visit 1 to that of visit 0, "
                      "in by arm a+ of a+1 b+1 a-1 b-0; it saw c+0 d+1 c-1 d-0, in by arm c-"));
}

TEST_CASE("a trace that could not be explained in time says what was stopped", "[mapping][unit]") {
  MapWatch watch;
  watch.stop = [](const TraceMaps&) { return Stop{.deadline = std::chrono::steady_clock::now()}; };
  const ExplainedTrace explained = explain_trace(shipped_trace("aces-stubs"), {}, {}, false, watch);
  CHECK_FALSE(explained.report.complete);
  CHECK(explained.why == "growing the tree was stopped: time limit");
}
