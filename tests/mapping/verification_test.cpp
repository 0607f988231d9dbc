#include "mapping/verification.hpp"

#include <chrono>

#include "mapping/random_traces.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

TEST_CASE("the shipped axioms are verified on random walks", "[mapping][slow]") {
  std::vector<std::string> stages;
  std::size_t traces_done = 0;
  const VerifyReport report =
      verify({}, {random_trace(1), random_trace(2)}, Deadline::max(),
             {.stage_is_over = [&](const std::string& stage) { stages.push_back(stage); },
              .traces_done = [&](std::size_t done, std::size_t) { traces_done = done; }});
  CHECK(report.axioms == "shipped");
  CHECK(report.together.kind == Independence::Kind::independent);
  CHECK(report.engines->difference == std::nullopt);
  CHECK(report.engines->traces == 2);
  CHECK(report.engines->maps_counted > 0);
  CHECK(report.engines->certified + report.engines->not_certified == 4);
  CHECK(report.change == std::nullopt);
  CHECK(stages == std::vector<std::string>{"axioms", "engines"});
  CHECK(traces_done == 2);
}

TEST_CASE("axioms from a folder that say what the shipped say change nothing", "[mapping][slow]") {
  const VerifyReport report = verify({.folder = ASTERISM_SOURCE_DIR "/axioms"}, {random_trace(3)});
  REQUIRE(report.change.has_value());
  CHECK(report.change->added.empty());
  CHECK(report.change->removed.empty());
  CHECK(report.change->traces_that_differ == 0);
  CHECK(report.change->gained == 0);
  CHECK(report.change->lost == 0);
  CHECK(report.change->shipped == report.change->ours);
}

TEST_CASE("a verification without time is stopped and says so", "[mapping][slow]") {
  const VerifyReport report = verify({}, {random_trace(1)}, std::chrono::steady_clock::now());
  CHECK(report.engines->stopped_by == "time limit");
}

TEST_CASE("random traces follow from their seed", "[mapping][unit]") {
  CHECK(random_trace(5).visits == random_trace(5).visits);
  CHECK(random_trace(5).visits != random_trace(6).visits);
  CHECK(ring_trace().visits.size() == 15);
}
