#include "io/json/answers_json.hpp"

#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

using Arrivals = std::vector<Arrival>;

Query query(const std::string& text) { return {text, {Claim::Same{VisitId(0), VisitId(1)}}, {}}; }

/// A report of two visits to nothing in particular.
AnswersReport report() {
  AnswersReport result;
  result.trace = "square";
  result.queries = {query("same(0, 1)")};
  return result;
}

const std::string head =
    R"json({"format":"asterism/answers","version":1,"trace":"square","options":{"planar":false,)json"
    R"json("check":"native","axioms":"shipped","optional_axioms":[],"over":"all","by":")json";

}  // namespace

TEST_CASE("a file of answers tells in how many maps a query holds, and shows one", "[io]") {
  AnswersReport some = report();
  some.consistent = 3;
  some.answers = {{.holds = 1,
                   .of = 3,
                   .witness = Arrivals{{PlaceId(0), {}}, {PlaceId(1), 2}},
                   .counterexample = Arrivals{{PlaceId(0), {}}, {PlaceId(0), 0}}}};
  CHECK(some.is_complete());
  CHECK(answers_json(some) == head + R"json(enumeration"},"consistent":3,"complete":true,
  "queries": [
    {"query":"same(0, 1)","verdict":"possible","holds":1,"of":3,)json"
                                     R"json("witness":{"visits":[0,1],"entered":[null,2]},)json"
                                     R"json("counterexample":{"visits":[0,0],"entered":[null,0]}}]}
)json");
}

TEST_CASE("a file of answers says what stopped the search for them", "[io]") {
  AnswersReport stopped = report();
  stopped.options.theory.assumptions = {{Assumption::Kind::differ, VisitId(0), VisitId(1)}};
  stopped.stopped_by = "time limit of 1 s";
  stopped.routes.queries = {
      {.text = "route(0, 1)", .from = VisitId(0), .to = VisitId(1), .mentions = {}}};
  CHECK_FALSE(stopped.is_complete());
  CHECK(answers_json(stopped) ==
        head + R"json(enumeration","assumptions":["differ(0, 1)"]},"consistent":null,)json"
               R"json("complete":false,"stopped_by":"time limit of 1 s",
  "queries": [
    {"query":"same(0, 1)","verdict":"undecided","holds":null,"of":null,"witness":null,)json"
               R"json("counterexample":null}],
  "routes": [
    {"query":"route(0, 1)","verdict":"undecided","of":null,"turns":null,"is_shortest":null,)json"
               R"json("shorter":null,"unlisted":null}]}
)json");
}

TEST_CASE("a file of answers shows what the solver shows, where it said enough", "[io]") {
  AnswersReport solved = report();
  solved.by = "solver";
  solved.solved = {{.can_hold = Verdict::consistent,
                    .can_fail = Verdict::inconsistent,
                    .witness = Arrivals{{PlaceId(0), {}}, {PlaceId(0), 1}}}};
  CHECK(solved.is_complete());
  CHECK(answers_json(solved).ends_with(
      R"json({"query":"same(0, 1)","verdict":"certain","holds":null,"of":null,)json"
      R"json("witness":{"visits":[0,0],"entered":[null,1]},"counterexample":null}]})json"
      "\n"));

  solved.solved.front().can_fail = Verdict::undecided;
  CHECK_FALSE(solved.is_complete());
  CHECK(answers_json(solved).ends_with(
      R"json("verdict":"undecided","holds":null,"of":null,"witness":null,"counterexample":null}]})json"
      "\n"));
}

TEST_CASE("a file of answers lists routes, and counts the maps of those it does not", "[io]") {
  AnswersReport routes = report();
  routes.queries.clear();
  routes.answers.emplace();
  routes.routes.queries = {
      {.text = "route(0, 1)", .from = VisitId(0), .to = VisitId(1), .mentions = {}}};
  routes.routes.answers = {{{.of = 5,
                             .certain = Turns{0, 2},
                             .is_shortest = false,
                             .shorter = {{{1}, 2, {{PlaceId(0), {}}}}},
                             .unlisted = 1}}};
  CHECK(routes.routes.is_undecided());
  CHECK_FALSE(routes.routes.has_impossible());
  CHECK(maps_with_shorter(routes.routes.answers->front()) == 3);
  CHECK(answers_json(routes) ==
        head + R"json(enumeration"},"consistent":null,"complete":true,
  "queries": [],
  "routes": [
    {"query":"route(0, 1)","verdict":"certain","of":5,"turns":[0,2],"is_shortest":false,)json"
               R"json("shorter":[{"turns":[1],"maps":2,)json"
               R"json("witness":{"visits":[0],"entered":[null]}}],"unlisted":1}]}
)json");
}
