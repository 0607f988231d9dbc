#include "mapping/checkpointing.hpp"

#include <chrono>
#include <filesystem>

#include "core/error.hpp"
#include "io/json/digest.hpp"
#include "mapping/minimal_report.hpp"
#include "tests/io/folder.hpp"
#include "tests/mapping/shipped_trace.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

Checkpoint::Search search_of(const Trace& trace) {
  return {.trace = trace.name, .digest = digest(trace), .theory = {}};
}

MinimalSearch extended_by(const Trace& trace) {
  MinimalSearch search;
  search.extend(trace.visits);
  return search;
}

}  // namespace

TEST_CASE("a search that was stopped goes on from its file to the same models", "[mapping][unit]") {
  const Folder folder;
  const std::string file = folder.file("search.checkpoint.json");
  const Trace trace = shipped_trace("aces-stubs");

  MinimalSearch stopped = extended_by(trace);
  Checkpointing first({.file = file}, search_of(trace));
  const MapReport part =
      find_minimal(stopped, trace, {}, {.deadline = std::chrono::steady_clock::now()}, &first);
  CHECK_FALSE(part.complete);
  CHECK(part.stopped_by == "time limit");
  CHECK(part.bounds.has_value());
  REQUIRE(std::filesystem::exists(file));

  MinimalSearch resumed = extended_by(trace);
  Checkpointing second({.file = file}, search_of(trace));
  REQUIRE(second.resume(resumed, {}));
  const MapReport whole = find_minimal(resumed, trace, {}, {}, &second);
  CHECK(whole.complete);
  CHECK(whole.minimal->count == 6);
  MinimalSearch afresh = extended_by(trace);
  afresh.run();
  CHECK(resumed.models() == afresh.models());
  second.remove();
  CHECK_FALSE(std::filesystem::exists(file));
}

TEST_CASE("without a file a search begins afresh", "[mapping][unit]") {
  const Folder folder;
  const Trace trace = shipped_trace("04_ring");
  MinimalSearch search = extended_by(trace);
  Checkpointing checkpoint({.file = folder.file("none.checkpoint.json")}, search_of(trace));
  CHECK_FALSE(checkpoint.resume(search, {}));
}

TEST_CASE("the file of another search is refused", "[mapping][unit]") {
  const Folder folder;
  const std::string file = folder.file("search.checkpoint.json");
  const Trace trace = shipped_trace("aces-stubs");
  MinimalSearch search = extended_by(trace);
  Checkpointing({.file = file}, search_of(trace)).run(search, {});

  const Trace other = shipped_trace("04_ring");
  MinimalSearch of_other = extended_by(other);
  Checkpointing checkpoint({.file = file}, search_of(other));
  CHECK_THROWS_AS(checkpoint.resume(of_other, {}), InputError);
}

TEST_CASE("a trace that no map explains says how far one does", "[mapping][unit]") {
  const Trace trace = shipped_trace("aces-stubs");
  MinimalSearch search(Theory{.assumptions = {{Assumption::Kind::same, VisitId(0), VisitId(1)}}});
  search.extend(trace.visits);
  const MapReport report = find_minimal(search, trace, {});
  CHECK(report.complete);
  CHECK(report.consistent == 0);
  CHECK(report.explained_visits == 1);
  CHECK(report.minimal == std::nullopt);
}
