#include "engine/ask/map_list.hpp"

#include <map>

#include "engine/ask/query_reader.hpp"
#include "engine/ask/route.hpp"
#include "engine/ask/telling_apart.hpp"
#include "engine/minimal/longest_explained_prefix.hpp"
#include "engine/minimal/minimal_search.hpp"
#include "simulation/grid_world.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

MinimalSearch searched(const Trace& trace, bool planar, std::vector<Assumption> assumptions = {}) {
  MinimalSearch search(
      {.theory = {
           .axioms = shipped_with(), .planar = planar, .assumptions = std::move(assumptions)}});
  search.extend(trace.visits);
  REQUIRE(search.run() == MinimalSearch::Outcome::complete);
  return search;
}

std::vector<Query> queries_of(std::size_t visits) {
  const std::string last = std::to_string(visits - 1);
  std::vector<Query> queries;
  for (const std::string& text :
       {"same(0, " + last + ")", "on_path(1, " + last + ")",
        "steps(0, " + last + ") < 3 or places = 6", std::string("paths <= 6 and not same(2, 4)")})
    queries.push_back(read_query(text));
  return queries;
}

void check_same(const Answer& one, const Answer& other) {
  CHECK(one.holds == other.holds);
  CHECK(one.of == other.of);
  CHECK(one.witness == other.witness);
  CHECK(one.counterexample == other.counterexample);
}

void check_same(const RouteAnswer& one, const RouteAnswer& other) {
  CHECK(one.of == other.of);
  CHECK(one.certain == other.certain);
  CHECK(one.is_shortest == other.is_shortest);
  CHECK(one.unlisted == other.unlisted);
  REQUIRE(one.shorter.size() == other.shorter.size());
  for (std::size_t i = 0; i < one.shorter.size(); ++i) {
    CHECK(one.shorter[i].route == other.shorter[i].route);
    CHECK(one.shorter[i].maps == other.shorter[i].maps);
    CHECK(one.shorter[i].witness == other.shorter[i].witness);
  }
}

}  // namespace

TEST_CASE("minimal models answer alike, listed by the tree or searched for",
          "[engine][map_list][reference][property]") {
  std::size_t possible = 0;
  std::size_t told_apart = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    const Trace trace = seeded_walk(seed, 6 + seed % 10).trace;
    INFO(to_keep(seed, trace));
    const bool planar = seed % 2 == 0;
    const MapTree tree = tree_of(trace, planar);
    const MinimalSearch search = searched(trace, planar);
    const std::vector<Query> queries = queries_of(trace.visits.size());
    const auto listed = ask(tree, queries, true).value();
    const auto found = ask(minimal_maps(search), queries).value();
    for (std::size_t i = 0; i < queries.size(); ++i) {
      check_same(found[i], listed[i]);
      possible += found[i].modality() == Modality::possible;
    }
    const RouteQuery route = std::get<RouteQuery>(
        read_question("route(" + std::to_string(trace.visits.size() - 1) + ", 1)"));
    check_same(find_route(minimal_maps(search), route).value(),
               find_route(tree, route, true).value());
    const TellingApart one = tell_apart(minimal_maps(search));
    const TellingApart other = tell_apart(tree);
    CHECK((one.answer == other.answer && one.turns == other.turns));
    CHECK(one.expected == other.expected);
    told_apart += !one.turns.empty();
  }
  CHECK(possible > 40);
  CHECK(told_apart > 20);
}

TEST_CASE("a trace too long to be listed is asked by its minimal models", "[engine][map_list]") {
  RandomEngine engine(1);
  const World world = grid_world({.width = 5, .height = 5}, engine);
  const Trace trace = walk(world, {.travels = 60}, engine).trace;
  const MinimalSearch search = searched(trace, false);
  const auto answers = ask(minimal_maps(search), queries_of(trace.visits.size())).value();
  for (const Answer& answer : answers) CHECK(answer.of == search.bounds().count);
}

TEST_CASE("asking stops where it is told to", "[engine][map_list]") {
  for (unsigned seed = 0; seed < 100; ++seed) {
    const Trace trace = seeded_walk(seed, 14).trace;
    const MinimalSearch search = searched(trace, false);
    if (search.bounds().count < 2) continue;
    std::size_t calls = 0;
    minimal_maps(search).for_each_while([&](std::span<const Arrival>) { return ++calls < 2; });
    CHECK(calls == 2);
    return;
  }
  FAIL("no trace has two minimal models");
}

TEST_CASE("the visits that are explained end where the tree's level is empty",
          "[engine][map_list][reference][property]") {
  std::map<bool, std::size_t> ended;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Trace trace = seeded_walk(seed, 10).trace;
    INFO(to_keep(seed, trace));
    const std::size_t one = seed % 7;
    const std::vector<Assumption> assumptions{
        {Assumption::Kind::same, VisitId(one), VisitId(one + 1 + seed % 4)}};
    const bool planar = seed % 2 == 0;
    const MapTree tree = tree_of(
        trace,
        {.theory = {.axioms = shipped_with(), .planar = planar, .assumptions = assumptions}});
    const auto counts = tree.per_visit();
    const auto explained =
        static_cast<std::size_t>(std::ranges::find(counts, std::uint64_t{0}) - counts.begin());
    const MinimalSearch::Options options{
        .theory = {.axioms = shipped_with(), .planar = planar, .assumptions = assumptions}};
    CHECK(longest_explained_prefix(trace, options) == explained);
    ++ended[explained < trace.visits.size()];
    CHECK(!longest_explained_prefix(trace, options, stop_unless([] { return false; })));
  }
  CHECK((ended[true] > 30 && ended[false] > 30));
}
