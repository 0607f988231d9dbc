#include "engine/ask/query.hpp"

#include <algorithm>
#include <functional>

#include "benchmarks/traces.hpp"
#include "engine/ask/query_reader.hpp"
#include "tests/engine/ask/query_reference.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

/// A query, and what it asks told a second way.
struct Case {
  std::string text;
  std::function<bool(const QueryReference&)> holds;
};

std::string call(const std::string& name, std::initializer_list<std::size_t> visits) {
  std::string text;
  for (const std::size_t visit : visits) text += (text.empty() ? "" : ", ") + std::to_string(visit);
  return name + "(" + text + ")";
}

/// Every predicate of every pair of visits, and orders of some three.
std::vector<Case> cases_of(std::size_t visits, unsigned seed) {
  std::vector<Case> cases;
  for (std::size_t i = 0; i < visits; ++i)
    for (std::size_t j = 0; j < visits; ++j) {
      cases.push_back({call("same", {i, j}), [=](auto& map) { return map.same(i, j); }});
      cases.push_back({call("adjacent", {i, j}), [=](auto& map) { return map.adjacent(i, j); }});
      cases.push_back({call("on_path", {i, j}), [=](auto& map) { return map.on_path(i, j); }});
      const std::size_t n = (i + j + seed) % 4;
      cases.push_back({call("steps", {i, j}) + " <= " + std::to_string(n),
                       [=](auto& map) { return map.steps(i, j) <= n; }});
      for (std::size_t k = 0; k < visits; ++k)
        if ((i + 3 * j + 2 * k + seed) % 7 == 0)
          cases.push_back(
              {call("order", {i, j, k}), [=](auto& map) { return map.order(i, j, k); }});
      if (j + 1 == visits) continue;
      cases.push_back({"on(" + std::to_string(i) + ", " + call("path_of", {j}) + ")",
                       [=](auto& map) { return map.on(i, j); }});
      if (i + 1 == visits) continue;
      cases.push_back({call("path_of", {i}) + " = " + call("path_of", {j}),
                       [=](auto& map) { return map.same_path(i, j); }});
      cases.push_back({call("path_of", {i}) + " != " + call("path_of", {j}),
                       [=](auto& map) { return !map.same_path(i, j); }});
    }
  for (std::size_t n = 0; n <= 3 * visits; ++n) {
    const std::string number = std::to_string(n);
    cases.push_back({"places = " + number, [=](auto& map) { return map.places() == n; }});
    cases.push_back({number + " < places", [=](auto& map) { return n < map.places(); }});
    cases.push_back({"paths != " + number, [=](auto& map) { return map.paths() != n; }});
    cases.push_back({"paths >= " + number, [=](auto& map) { return map.paths() >= n; }});
    cases.push_back({"segments > " + number, [=](auto& map) { return map.segments() > n; }});
  }
  cases.push_back({"paths <= places", [](auto& map) { return map.paths() <= map.places(); }});
  return cases;
}

std::vector<Query> queries_of(const std::vector<Case>& cases) {
  std::vector<Query> queries;
  for (const Case& one : cases) queries.push_back(read_query(one.text));
  return queries;
}

/// Maps written out, in the order of reports.
std::vector<TopologicalMap> written(const Trace& trace, const std::vector<Association>& maps) {
  std::vector<TopologicalMap> result;
  for (const Association& map : maps) result.push_back(make_map(trace, map));
  std::ranges::sort(result, [](const TopologicalMap& a, const TopologicalMap& b) {
    return std::tie(a.visits, a.entered) < std::tie(b.visits, b.entered);
  });
  return result;
}

std::vector<TopologicalMap> minimal_of(const std::vector<TopologicalMap>& maps) {
  const auto size = [](const TopologicalMap& map) {
    return std::pair(map.paths.size(), map.places.size());
  };
  std::vector<TopologicalMap> result;
  for (const TopologicalMap& map : maps)
    if (std::ranges::none_of(maps, [&](const auto& other) { return size(other) < size(map); }))
      result.push_back(map);
  return result;
}

void check_answers(const std::vector<Case>& cases, const std::vector<Answer>& answers,
                   const std::vector<TopologicalMap>& maps) {
  const std::vector<QueryReference> references(maps.begin(), maps.end());
  REQUIRE(answers.size() == cases.size());
  std::vector<std::string> differing;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    std::uint64_t holding = 0;
    std::optional<Association> witness;
    std::optional<Association> counterexample;
    for (std::size_t m = 0; m < maps.size(); ++m) {
      const bool is_so = cases[i].holds(references[m]);
      holding += is_so ? 1 : 0;
      auto& first = is_so ? witness : counterexample;
      if (!first) first = arrivals(maps[m]);
    }
    const Modality modality = holding == 0             ? Modality::impossible
                              : holding == maps.size() ? Modality::certain
                                                       : Modality::possible;
    const Answer& answer = answers[i];
    const bool agrees = answer.holds == holding && answer.of == maps.size() &&
                        answer.modality() == modality && answer.witness == witness &&
                        answer.counterexample == counterexample;
    if (!agrees) differing.push_back(cases[i].text);
  }
  CHECK(differing == std::vector<std::string>{});
}

std::vector<Answer> answers_to(const MapTree& tree, const std::vector<std::string>& texts,
                               bool only_minimal = false) {
  std::vector<Query> queries;
  for (const std::string& text : texts) queries.push_back(read_query(text));
  return ask(tree, queries, only_minimal).value();
}

bool equal(const Answer& a, const Answer& b) {
  return a.holds == b.holds && a.of == b.of && a.witness == b.witness &&
         a.counterexample == b.counterexample;
}

bool is_certain(const Answer& answer) { return answer.modality() == Modality::certain; }
bool is_possible(const Answer& answer) { return answer.modality() != Modality::impossible; }

/// Some text of the grammar.
std::string random_claim(RandomEngine& engine, std::size_t visits, int depth) {
  const auto visit = [&] { return below(visits - 1, engine); };
  switch (below(depth > 0 ? 9 : 6, engine)) {
    case 0:
      return call("same", {visit(), visit()});
    case 1:
      return call("on_path", {visit(), visit()});
    case 2:
      return call("order", {visit(), visit(), visit()});
    case 3:
      return call("path_of", {visit()}) + " != " + call("path_of", {visit()});
    case 4:
      return call("steps", {visit(), visit()}) + " >= " + std::to_string(below(4, engine));
    case 5:
      return "paths < " + std::to_string(below(3 * visits, engine));
    case 6:
      return "not " + random_claim(engine, visits, 0);
    case 7:
      return "(" + random_claim(engine, visits, depth - 1) + " or " +
             random_claim(engine, visits, depth - 1) + ")";
    default:
      return "(" + random_claim(engine, visits, depth - 1) + " and " +
             random_claim(engine, visits, depth - 1) + ")";
  }
}

}  // namespace

TEST_CASE("every predicate holds in the maps where brute force says so",
          "[engine][query][reference][property]") {
  std::size_t maps_asked = 0;
  for (unsigned seed = 0; seed < 500; ++seed) {
    const Trace trace = seeded_walk(seed, 5 + seed % 6).trace;
    INFO(to_keep(seed, trace));
    const auto cases = cases_of(trace.visits.size(), seed);
    const auto queries = queries_of(cases);
    for (const bool planar : {false, true}) {
      const MapTree tree = tree_of(trace, planar);
      const auto maps = written(trace, every_map_by_visit(trace, {.planar = planar}).back());
      check_answers(cases, ask(tree, queries, false).value(), maps);
      check_answers(cases, ask(tree, queries, true).value(), minimal_of(maps));
      maps_asked += maps.size();
    }
  }
  CHECK(maps_asked > 3000);
}

TEST_CASE("answers keep the laws of logic", "[engine][query][property]") {
  RandomEngine engine(1);
  std::size_t possible = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    const MapTree tree = tree_of(seeded_walk(seed, 13 + seed % 5).trace, seed % 2 == 0);
    const std::size_t visits = tree.trace().visits.size();
    const bool only_minimal = seed % 3 == 0;
    const std::string a = random_claim(engine, visits, 2);
    const std::string b = random_claim(engine, visits, 2);
    const std::string c = random_claim(engine, visits, 1);
    INFO(to_keep(seed, tree.trace()) << "\n" << a << "\n" << b << "\n" << c);
    const auto all = [&](const std::vector<std::string>& texts) {
      return answers_to(tree, texts, only_minimal);
    };
    const auto same = [&](const std::string& one, const std::string& other) {
      INFO(one << "  |  " << other);
      const auto both = all({one, other});
      CHECK(equal(both[0], both[1]));
    };
    same(a, "not not " + a);
    same(a, "((" + a + "))");
    same("not (" + a + " and " + b + ")", "not " + a + " or not " + b);
    same("not (" + a + " or " + b + ")", "not " + a + " and not " + b);
    same(a + " or " + b + " and " + c, a + " or (" + b + " and " + c + ")");
    same("not " + a + " and " + b, "(not " + a + ") and " + b);
    same(a + " and " + b + " and " + c, c + " and (" + b + " and " + a + ")");

    const auto answers = all({a, b, a + " and " + b, a + " or " + b, "not " + a});
    CHECK(is_certain(answers[2]) == (is_certain(answers[0]) && is_certain(answers[1])));
    CHECK(is_possible(answers[3]) == (is_possible(answers[0]) || is_possible(answers[1])));
    CHECK(answers[2].holds + answers[3].holds == answers[0].holds + answers[1].holds);
    CHECK(is_certain(answers[4]) == !is_possible(answers[0]));
    CHECK(answers[4].witness == answers[0].counterexample);
    CHECK(answers[4].counterexample == answers[0].witness);
    for (const Answer& answer : answers)
      if (answer.modality() == Modality::possible) ++possible;
  }
  CHECK(possible > 60);
}

TEST_CASE("predicates are related as their words say", "[engine][query][property]") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const MapTree tree = tree_of(seeded_walk(seed, 8).trace, seed % 2 == 0);
    INFO(to_keep(seed, tree.trace()));
    const auto certain = [&](const std::string& text) {
      INFO(text);
      CHECK(is_certain(answers_to(tree, {text}).front()));
    };
    const auto equivalent = [&](const std::string& one, const std::string& other) {
      INFO(one << "  |  " << other);
      const auto both = answers_to(tree, {one, other});
      CHECK(equal(both[0], both[1]));
    };
    for (std::size_t i = 0; i < 8; ++i) {
      const std::string next = std::to_string(i + 1);
      certain("adjacent(" + std::to_string(i) + ", " + next + ")");
      certain("on(" + std::to_string(i) + ", " + call("path_of", {i}) + ") and on(" + next + ", " +
              call("path_of", {i}) + ")");
      for (std::size_t j = 0; j < 8; ++j) {
        equivalent(call("same", {i, j}), call("same", {j, i}));
        equivalent(call("same", {i, j}), call("steps", {i, j}) + " = 0");
        equivalent(call("adjacent", {i, j}), call("steps", {i, j}) + " = 1");
        equivalent(call("order", {i, j, 8}), call("order", {8, j, i}));
        certain(call("steps", {i, j}) + " = " + call("steps", {j, i}));
        certain("not " + call("order", {i, j, 8}) + " or " + call("on_path", {i, 8}));
        certain("not on(" + std::to_string(i) + ", " + call("path_of", {j}) + ") or " +
                call("on_path", {i, j}));
      }
    }
  }
}

TEST_CASE("the solver's tree answers with the same maps", "[engine][query]") {
  for (const unsigned seed : {3U, 11U, 22U}) {
    const Trace trace = seeded_walk(seed, 7).trace;
    const MapTree native = tree_of(trace, true);
    const MapTree solver = tree_of(
        trace, {.theory = {.axioms = shipped_with(), .planar = true}, .check = Check::solver});
    for (const bool only_minimal : {false, true})
      for (const std::string text : {"same(0, 4)", "on_path(0, 5)", "places < 6"})
        CHECK(equal(answers_to(native, {text}, only_minimal).front(),
                    answers_to(solver, {text}, only_minimal).front()));
  }
}

TEST_CASE("asking stops when it is told to", "[engine][query]") {
  const Trace trace = make_trace(benchmark_traces[2]);
  const MapTree tree = tree_of(trace, false);
  const std::vector<Query> queries{read_query("same(0, 8)")};
  std::uint64_t asked = 0;
  CHECK(!ask(tree, queries, false, stop_unless([&](const Standing& now) {
               asked = now.maps;
               return asked < 50'000;
             })));
  CHECK(asked >= 50'000);
  CHECK(asked < tree.size());
  const auto answers = ask(tree, queries, false, stop_unless([] { return true; }));
  REQUIRE(answers);
  CHECK(answers->front().of == tree.size());
}

TEST_CASE("where no map explains the trace, nothing is certain", "[engine][query]") {
  // Back along the only segment there is a dead end; it cannot have become a crossing.
  const Star crossing = Star::parse("a+1 b+1 a-1 b-1");
  const Trace trace{.name = "none",
                    .visits = {{.star = Star::parse("a+1 a-0"), .left_by = 0},
                               {.star = crossing, .entered_by = 0, .left_by = 0},
                               {.star = crossing, .entered_by = 0}}};
  const MapTree tree = tree_of(trace, false);
  const Answer answer = answers_to(tree, {"same(0, 0)"}).front();
  CHECK((answer.of == 0 && answer.modality() == Modality::impossible));
  CHECK((!answer.witness && !answer.counterexample));
}

TEST_CASE("visits are those of the trace", "[engine][query]") {
  const MapTree tree = tree_of(seeded_walk(2, 5).trace, false);
  const auto refusal = [&](const std::string& text) -> std::string {
    try {
      answers_to(tree, {text});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(refusal("same(5, 5)") == "");
  CHECK(refusal("same(0, 6)") == "query, character 9: found visit 6; expected 0 to 5");
  CHECK(refusal("places = 6 or on(1, path_of(5))") ==
        "query, character 29: found visit 5, of which the trace does not say how it was left; "
        "expected one that was left");
}
