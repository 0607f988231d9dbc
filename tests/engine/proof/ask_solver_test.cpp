#include "engine/proof/ask_solver.hpp"

#include <algorithm>

#include "engine/ask/query_map.hpp"
#include "engine/ask/query_reader.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

Stop ample() { return Stop{}.within(600); }

std::string text(const std::string& name, std::initializer_list<std::size_t> visits) {
  std::string list;
  for (const std::size_t visit : visits) list += (list.empty() ? "" : ", ") + std::to_string(visit);
  return name + "(" + list + ")";
}

/// One query a predicate, about visits that the seed picks.
std::vector<Query> some_queries(std::size_t visits, RandomEngine& engine) {
  const auto visit = [&] { return below(visits, engine); };
  const auto left = [&] { return below(visits - 1, engine); };
  const std::string path = text("path_of", {left()});
  const std::string number = std::to_string(below(visits + 2, engine));
  const std::vector<std::string> texts{
      text("same", {visit(), visit()}),
      text("adjacent", {visit(), visit()}),
      text("on_path", {visit(), visit()}),
      "on(" + std::to_string(visit()) + ", " + path + ")",
      path + " = " + text("path_of", {left()}),
      text("order", {visit(), visit(), visit()}),
      "places <= " + number,
      number + " < paths",
      "segments != " + number,
      "paths >= places",
      text("steps", {visit(), visit()}) + " = " + std::to_string(1 + below(3, engine)),
      "places > " + text("steps", {visit(), visit()}) + " and not " +
          text("same", {visit(), visit()}),
      text("same", {visit(), visit()}) + " or " + text("adjacent", {visit(), visit()})};
  std::vector<Query> queries;
  for (const std::string& query : texts) queries.push_back(read_query(query));
  return queries;
}

/// Whether a map is one of those asked, and the claim holds in it or not.
bool is_witness(const std::vector<Association>& maps, const Trace& trace, const Claim& claim,
                const std::optional<std::vector<Arrival>>& map, bool expected) {
  if (!map || std::ranges::find(maps, *map) == maps.end()) return false;
  QueryMap view(trace);
  view.set(*map);
  return holds(claim, view) == expected;
}

void compare_with_enumeration(unsigned seed) {
  RandomEngine engine(seed);
  const Trace trace = seeded_walk(seed, 4 + seed % 4).trace;
  const bool planar = seed % 2 == 0;
  const bool only_minimal = seed % 3 == 0;
  const std::vector<Query> queries = some_queries(trace.visits.size(), engine);
  const MapTree tree = tree_of(trace, planar);
  const std::vector<Association> maps = only_minimal ? minimal_of(tree) : maps_of(tree);
  const auto listed = ask(tree, queries, only_minimal).value();
  const auto solved = ask_solver(trace, {shipped_with(), planar}, queries, only_minimal, ample());
  INFO(to_keep(seed, trace));
  for (std::size_t i = 0; i < queries.size(); ++i) {
    INFO(queries[i].text);
    REQUIRE(solved[i].modality().has_value());
    CHECK(solved[i].modality() == listed[i].modality());
    if (listed[i].holds > 0)
      CHECK(is_witness(maps, trace, queries[i].claim, solved[i].witness, true));
    if (listed[i].holds < listed[i].of)
      CHECK(is_witness(maps, trace, queries[i].claim, solved[i].counterexample, false));
  }
}

}  // namespace

TEST_CASE("the solver answers queries as listing all maps does") {
  for (unsigned seed = 0; seed < 40; ++seed) compare_with_enumeration(seed);
}

TEST_CASE("the solver answers queries on 500 worlds as listing all maps does", "[full]") {
  for (unsigned seed = 40; seed < 540; ++seed) compare_with_enumeration(seed);
}
