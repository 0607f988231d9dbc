#include "mapping/suite.hpp"

#include <chrono>
#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "mapping/expected_answers.hpp"
#include "tests/io/folder.hpp"
#include "tests/mapping/shipped_trace.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

using Kind = SuiteOutcome::Kind;

const std::string examples = ASTERISM_SOURCE_DIR "/examples/";

void copy(const std::string& name, const Folder& folder) {
  std::filesystem::copy_file(examples + name, folder.file(name));
}

}  // namespace

TEST_CASE("a suite says of each trace what became of it, in the order of names",
          "[mapping][unit]") {
  const Folder folder;
  for (const char* name : {"aces-stubs.trace.json", "aces-stubs.expect.json", "04_ring.trace.json",
                           "05_square.trace.json"})
    copy(name, folder);
  // Expects of the ring what the corner gives.
  std::filesystem::copy_file(examples + "01_corner.expect.json",
                             folder.file("04_ring.expect.json"));
  std::ofstream(folder.file("broken.trace.json")) << "{";
  const std::string where = std::filesystem::path(folder.file("x")).parent_path();
  std::vector<std::string> told;
  const auto outcomes = run_suite(
      {.folder = where}, {}, [&](const SuiteOutcome& outcome) { told.push_back(outcome.name); });
  CHECK(told == std::vector<std::string>{"04_ring", "05_square", "aces-stubs", "broken"});
  REQUIRE(outcomes.size() == 4);
  CHECK(outcomes[0].kind == Kind::differs);
  CHECK_FALSE(outcomes[0].differences.empty());
  CHECK(outcomes[1].kind == Kind::nothing_expected);
  CHECK(outcomes[2].kind == Kind::as_expected);
  CHECK(outcomes[2].why == "2 cases and 3 queries");
  CHECK(outcomes[3].kind == Kind::untestable);
}

TEST_CASE("what comes out is recorded, and expected from then on", "[mapping][unit]") {
  const Folder folder;
  copy("04_ring.trace.json", folder);
  Suite suite{.folder = std::filesystem::path(folder.file("x")).parent_path(), .update = true};
  CHECK(run_suite(suite).front().kind == Kind::recorded);
  suite.update = false;
  CHECK(run_suite(suite).front().kind == Kind::as_expected);
  const Expectation recorded = read_expected_answers(folder.file("04_ring.expect.json"));
  CHECK(recorded.cases.size() == 2);
  CHECK(recorded.cases.front().counts->per_visit.back() == 6);
}

TEST_CASE("a limit leaves a trace of a suite undecided", "[mapping][unit]") {
  const Folder folder;
  copy("aces-stubs.trace.json", folder);
  copy("aces-stubs.expect.json", folder);
  const std::string where = std::filesystem::path(folder.file("x")).parent_path();
  const auto limited = run_suite({.folder = where, .options = {.max_hypotheses = 5}});
  CHECK(limited.front().kind == Kind::undecided);
  CHECK(limited.front().why == "stopped by limit of 5 hypotheses");
  MapWatch watch;
  watch.stop = [](const TraceMaps&) { return Stop{.deadline = std::chrono::steady_clock::now()}; };
  CHECK(run_suite({.folder = where}, watch).front().why == "stopped by time limit");
}

TEST_CASE("a folder without traces is no suite", "[mapping][unit]") {
  const Folder folder;
  CHECK_THROWS_AS(run_suite({.folder = folder.file("none")}), InputError);
}

TEST_CASE("questions about visits that are not there are pointed at in their file",
          "[mapping][unit]") {
  const Trace trace = shipped_trace("04_ring");
  Expectation asked = default_questions();
  asked.cases[1].queries.push_back({.query = "same(0, 7)"});
  CHECK_THROWS_WITH(find_answers(trace, asked, {}, "ring.expect.json"),
                    Catch::Matchers::StartsWith("ring.expect.json:/cases/1/queries/0/query: "));
}
