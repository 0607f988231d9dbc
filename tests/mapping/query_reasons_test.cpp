#include "mapping/query_reasons.hpp"

#include <chrono>

#include "engine/ask/query_reader.hpp"
#include "tests/mapping/shipped_trace.hpp"
#include "tests/support/axiom_files.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

const Theory planar{.planar = true};

ExplainReport explained(const std::string& query, bool only_minimal) {
  return explain_query(shipped_trace("aces-stubs"), planar, read_query(query), only_minimal);
}

}  // namespace

TEST_CASE("what is impossible is due to premises that clash", "[mapping][unit]") {
  const ExplainReport report = explained("places < 9", false);
  CHECK(report.modality == Modality::impossible);
  REQUIRE(report.clash.has_value());
  CHECK_FALSE(report.clash->members.empty());
  CHECK(report.preference == std::nullopt);
}

TEST_CASE("what is certain has a map where it holds, and a clash without", "[mapping][unit]") {
  const ExplainReport report = explained("order(1, 2, 3)", false);
  CHECK(report.modality == Modality::certain);
  CHECK(report.clash.has_value());
  CHECK(report.witness.size() == 15);
  CHECK(report.counterexample.empty());
}

TEST_CASE("what is possible has two maps that differ in it", "[mapping][unit]") {
  const ExplainReport report = explained("same(0, 8)", false);
  CHECK(report.modality == Modality::possible);
  CHECK(report.clash == std::nullopt);
  CHECK(report.witness[0].place == report.witness[8].place);
  CHECK(report.counterexample[0].place != report.counterexample[8].place);
}

TEST_CASE("preference makes certain what all maps leave open", "[mapping][unit]") {
  const ExplainReport report = explained("same(0, 8)", true);
  CHECK(report.modality == Modality::certain);
  CHECK(report.clash == std::nullopt);
  REQUIRE(report.preference.has_value());
  CHECK(report.preference->minimal == std::vector<std::size_t>{6, 9});
  CHECK(report.preference->best.extents > report.preference->minimal);
  CHECK(report.counterexample[0].place != report.counterexample[8].place);
}

TEST_CASE("axioms that the search does not know are put to the solver", "[mapping][unit]") {
  AxiomFiles files = shipped_files();
  files["own.smt2"] = R"(; idle
; What is next is next.
;   next(q, r)  →  next(q, r)
(assert (! (forall ((q DState) (r DState)) (=> (next q r) (next q r))) :named axiom.idle))
)";
  const Theory own{.axioms = AxiomSet::parse(files)};
  REQUIRE_FALSE(own.axioms.is_shipped());
  const ExplainReport report =
      explain_query(shipped_trace("04_ring"), own, read_query("places = 2"), true);
  CHECK(report.modality == Modality::certain);
  REQUIRE(report.preference.has_value());
  CHECK(report.preference->minimal == std::vector<std::size_t>{2, 2});
}

TEST_CASE("without time a query is left undecided", "[mapping][unit]") {
  const Stop at_once{.deadline = std::chrono::steady_clock::now()};
  const ExplainReport report = explain_query(shipped_trace("aces-stubs"), planar,
                                             read_query("same(0, 8)"), false, 1, at_once);
  CHECK(report.modality == std::nullopt);
}
