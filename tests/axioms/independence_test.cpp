#include "axioms/independence.hpp"

#include <algorithm>
#include <functional>
#include <random>
#include <set>

#include "axioms/ground_proof.hpp"
#include "axioms/model_finder.hpp"
#include "tests/support/axiom_files.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

using Clock = std::chrono::steady_clock;
using Kind = Independence::Kind;

Clock::time_point later() { return Clock::now() + std::chrono::hours(2); }

/// The shipped declarations, and these assertions alone.
AxiomSet only(const std::string& assertions) {
  AxiomFiles files = shipped_files();
  const AxiomSet shipped = AxiomSet::shipped();
  for (const Axiom& axiom : shipped.axioms())
    if (!axiom.by_signature) files = with_axiom(files, axiom.name);
  files["only.smt2"] = assertions;
  return AxiomSet::parse(files);
}

AxiomSet shipped_and(const std::string& assertions) {
  AxiomFiles files = shipped_files();
  files["more.smt2"] = assertions;
  return AxiomSet::parse(files);
}

const Axiom& axiom_named(const AxiomSet& axioms, const std::string& name) {
  return *std::find_if(axioms.axioms().begin(), axioms.axioms().end(),
                       [&](const Axiom& axiom) { return axiom.name == name; });
}

Kind kind_of(const AxiomSet& axioms, const std::string& name) {
  return independence(axiom_named(axioms, name), axioms, later()).kind;
}

std::set<std::string> axioms_of(const Independence& found) {
  std::set<std::string> result;
  for (const AxiomInstance& step : found.proof) result.insert(step.axiom);
  return result;
}

/// Two dstates at one or two places, and what holds of them: all there is to random sentences.
struct Tiny {
  bool order[2][2];
  bool next[2][2];
  bool ends[2];
  std::size_t place[2];
};

std::vector<Tiny> every_tiny() {
  std::vector<Tiny> result;
  for (unsigned bits = 0; bits < 1U << 11U; ++bits) {
    Tiny tiny{};
    const auto bit = [&](unsigned i) { return (bits >> i & 1U) != 0; };
    for (unsigned i = 0; i < 4; ++i) {
      tiny.order[i / 2][i % 2] = bit(i);
      tiny.next[i / 2][i % 2] = bit(4 + i);
    }
    tiny.ends[0] = bit(8);
    tiny.ends[1] = bit(9);
    tiny.place[1] = bit(10) ? 1 : 0;
    result.push_back(tiny);
  }
  return result;
}

/// A literal as text, and as what it says of dstates q and r.
struct Literal {
  std::string text;
  std::function<bool(const Tiny&, std::size_t q, std::size_t r)> holds;
};

const std::vector<Literal> literals{
    {"(order q r)", [](const Tiny& t, auto q, auto r) { return t.order[q][r]; }},
    {"(order r q)", [](const Tiny& t, auto q, auto r) { return t.order[r][q]; }},
    {"(order q q)", [](const Tiny& t, auto q, auto) { return t.order[q][q]; }},
    {"(next q r)", [](const Tiny& t, auto q, auto r) { return t.next[q][r]; }},
    {"(next r q)", [](const Tiny& t, auto q, auto r) { return t.next[r][q]; }},
    {"(ends q)", [](const Tiny& t, auto q, auto) { return t.ends[q]; }},
    {"(ends r)", [](const Tiny& t, auto, auto r) { return t.ends[r]; }},
    {"(= q r)", [](const Tiny&, auto q, auto r) { return q == r; }},
    {"(= (place q) (place r))",
     [](const Tiny& t, auto q, auto r) { return t.place[q] == t.place[r]; }}};

struct Sentence {
  std::string text;
  std::function<bool(const Tiny&)> holds;
};

/// order or next of q and r, and maybe more, implies one of two literals, each maybe negated.
Sentence random_sentence(std::mt19937& random, const std::string& name) {
  const auto below = [&](std::size_t n) { return random() % n; };
  const auto any = [&]() -> Literal {
    Literal one = literals[below(literals.size())];
    if (below(2) == 0) return one;
    return {"(not " + one.text + ")",
            [holds = one.holds](const Tiny& t, auto q, auto r) { return !holds(t, q, r); }};
  };
  const Literal first = literals[below(2) == 0 ? 0 : 3];
  const Literal second = any();
  const Literal one = any();
  const Literal other = below(2) == 0 ? any() : one;
  const std::string text = "(assert (! (forall ((q DState) (r DState)) (=> (and " + first.text +
                           " " + second.text + ") (or " + one.text + " " + other.text +
                           "))) :named " + name + "))\n";
  return {text, [=](const Tiny& t) {
            for (std::size_t q = 0; q < 2; ++q)
              for (std::size_t r = 0; r < 2; ++r)
                if (first.holds(t, q, r) && second.holds(t, q, r) && !one.holds(t, q, r) &&
                    !other.holds(t, q, r))
                  return false;
            return true;
          }};
}

}  // namespace

TEST_CASE("each shipped axiom is independent of the others", "[axioms][independence]") {
  const AxiomSet axioms = AxiomSet::shipped();
  for (const Axiom& axiom : axioms.axioms()) {
    INFO(axiom.name);
    const Independence found = independence(axiom, axioms, later());
    REQUIRE(found.kind == Kind::independent);
    INFO(model_text(*found.model));
    for (const Axiom& other : axioms.axioms()) {
      if (other.by_signature)
        CHECK(failure_of_function(other.function, *found.model).has_value() ==
              (other.name == axiom.name));
      else
        CHECK(failure_of(other, axioms, *found.model).has_value() == (other.name == axiom.name));
    }
    CHECK(found.model->elements.at("DState").size() <= 4);
    CHECK(found.failure.size() == (axiom.by_signature ? 1 : axiom.variables.size()));
  }
}

TEST_CASE("what is said of random axioms is what all small structures say",
          "[axioms][independence][property]") {
  // Two variables a sentence: it can fail among two dstates if it can fail at all.
  const std::vector<Tiny> all = every_tiny();
  std::mt19937 random(1988);
  std::map<Kind, int> times;
  for (int i = 0; i < 30; ++i) {
    std::vector<Sentence> sentences;
    std::string text;
    for (std::size_t k = 0; k < 3; ++k) {
      sentences.push_back(random_sentence(random, "random_" + std::to_string(k)));
      text += sentences.back().text;
    }
    INFO(text);
    const AxiomSet axioms = only(text);
    for (std::size_t k = 0; k < sentences.size(); ++k) {
      const bool can_fail = std::any_of(all.begin(), all.end(), [&](const Tiny& tiny) {
        for (std::size_t j = 0; j < sentences.size(); ++j)
          if (sentences[j].holds(tiny) == (j == k)) return false;
        return true;
      });
      const Kind kind = kind_of(axioms, "random_" + std::to_string(k));
      CHECK(kind == (can_fail ? Kind::independent : Kind::implied));
      ++times[kind];
    }
  }
  CHECK(times[Kind::independent] > 12);
  CHECK(times[Kind::implied] > 12);
}

TEST_CASE("evaluation of models is that of all small structures",
          "[axioms][independence][property]") {
  const std::vector<Tiny> all = every_tiny();
  std::mt19937 random(76);
  for (int i = 0; i < 30; ++i) {
    const Sentence sentence = random_sentence(random, "random");
    const AxiomSet axioms = only(sentence.text);
    INFO(sentence.text);
    for (int k = 0; k < 40; ++k) {
      const Tiny& tiny = all[random() % all.size()];
      FiniteModel model;
      model.signature = axioms.functions();
      model.elements = {{"DState", {"q0", "q1"}}, {"Place", {"p0", "p1"}}};
      model.functions["place"] = {{tiny.place[0]}, {tiny.place[1]}};
      for (std::size_t q = 0; q < 2; ++q) {
        if (tiny.ends[q]) model.relations["ends"].insert({q});
        for (std::size_t r = 0; r < 2; ++r) {
          if (tiny.order[q][r]) model.relations["order"].insert({q, r});
          if (tiny.next[q][r]) model.relations["next"].insert({q, r});
        }
      }
      const auto failure = failure_of(axiom_named(axioms, "random"), axioms, model);
      CHECK(failure.has_value() != sentence.holds(tiny));
    }
  }
}

TEST_CASE("an axiom that others imply is found so, with the instances", "[axioms][independence]") {
  const AxiomSet loop = shipped_and(R"(
(assert (! (forall ((q DState) (r DState)) (=> (and (order q r) (order r q)) false))
  :named no_loop)))");
  const Independence no_loop = independence(axiom_named(loop, "no_loop"), loop, later());
  CHECK(no_loop.kind == Kind::implied);
  CHECK(axioms_of(no_loop) == std::set<std::string>{"transitive", "irreflexive"});
  CHECK(no_loop.proof.size() == 2);
  CHECK_FALSE(no_loop.model);
  CHECK(kind_of(loop, "transitive") == Kind::independent);

  // A travel orders places, so that paths cross once only if segments do.
  const AxiomSet optional = AxiomSet::shipped(AxiomSet::optional_names());
  const Independence segment =
      independence(axiom_named(optional, "one_segment"), optional, later());
  CHECK(segment.kind == Kind::implied);
  CHECK(axioms_of(segment) == std::set<std::string>{"one_crossing", "order"});
  CHECK(kind_of(optional, "one_crossing") == Kind::independent);

  // Each of two that say the same is implied by the other.
  const AxiomSet twice = shipped_and(R"(
(assert (! (forall ((s DState) (t DState)) (=> (leads s travel t) (order s t))) :named again)))");
  CHECK(kind_of(twice, "again") == Kind::implied);
  CHECK(kind_of(twice, "order") == Kind::implied);
}

TEST_CASE("what cannot fail is implied by nothing", "[axioms][independence]") {
  // Actions have unique names.
  const AxiomSet axioms = only(R"(
(assert (! (forall ((a Action)) (=> (and (is_turn a) (= a travel)) (not (= a turn_around))))
  :named apart)))");
  const Independence found = independence(axiom_named(axioms, "apart"), axioms, later());
  CHECK(found.kind == Kind::implied);
  CHECK(found.proof.empty());
}

TEST_CASE("sorts that functions make are quantified over as well", "[axioms][independence]") {
  const std::string places = R"(
(declare-const home Place)
(declare-fun beside (Place Place) Bool)
(assert (! (forall ((p Place) (o Place)) (=> (beside p o) (beside o p))) :named symmetric))
(assert (! (forall ((p Place) (o Place)) (=> (beside p o) (= p home))) :named only_home)))";
  const AxiomSet axioms = only(places);
  CHECK(kind_of(axioms, "symmetric") == Kind::independent);
  CHECK(kind_of(axioms, "only_home") == Kind::independent);
  const AxiomSet more = only(places + R"(
(assert (! (forall ((q DState) (r DState)) (=> (and (order q r) (beside (place q) (place r)))
  (= (place q) (place r)))) :named one_place)))");
  CHECK(kind_of(more, "one_place") == Kind::implied);
  CHECK(kind_of(more, "symmetric") == Kind::independent);
}

TEST_CASE("all axioms together have a model with a travel, or the proof that they have none",
          "[axioms][independence]") {
  const AxiomSet shipped = AxiomSet::shipped();
  const Independence found = model_with_travel(shipped, later());
  REQUIRE(found.kind == Kind::independent);
  for (const Axiom& axiom : shipped.axioms())
    CHECK((axiom.by_signature || !failure_of(axiom, shipped, *found.model)));
  // Two dead ends: each arm has its opposite, and the travel its way back.
  CHECK(found.model->elements.at("DState").size() == 4);
  CHECK(found.model->elements.at("Place").size() == 2);
  CHECK(found.model->relations.at("opposite").size() == 4);
  CHECK(found.model->relations.at("sees").size() == 4);
  CHECK(found.model->relations.at("order").size() == 2);

  const AxiomSet none = shipped_and(R"(
(assert (! (forall ((q DState) (r DState)) (=> (order q r) (= (place q) (place r))))
  :named stay)))");
  const Independence refuted = model_with_travel(none, later());
  CHECK(refuted.kind == Kind::implied);
  CHECK(axioms_of(refuted).contains("stay"));

  // Where no dstate may have an opposite arm, travels alone will do.
  const AxiomSet bare = shipped_and(R"(
(assert (! (forall ((q DState) (r DState)) (=> (opposite q r) false)) :named no_opposite)))");
  CHECK(model_with_travel(bare, later()).kind == Kind::independent);

  // No map at all: what is told with every trace is refuted.
  const AxiomSet never =
      shipped_and("(assert (! (forall ((a Action)) (=> (is_turn a) false)) :named never))");
  const Independence no_map = model_with_travel(never, later());
  CHECK(no_map.kind == Kind::implied);
  CHECK(axioms_of(no_map) == std::set<std::string>{"never", "turns"});
}

TEST_CASE("without time it is undecided", "[axioms][independence]") {
  const AxiomSet axioms = AxiomSet::shipped();
  const Independence found = independence(axiom_named(axioms, "transitive"), axioms, Clock::now());
  CHECK(found.kind == Kind::undecided);
  CHECK_FALSE(found.model);
  CHECK(model_with_travel(axioms, Clock::now()).kind == Kind::undecided);
}

TEST_CASE("a model is told in one line", "[axioms][independence]") {
  const AxiomSet axioms = AxiomSet::shipped();
  const Independence found = independence(axiom_named(axioms, "irreflexive"), axioms, later());
  CHECK(model_text(*found.model) ==
        "along: q0 → π0; opp: π0 → π1, π1 → π0; place: q0 → p0; is_turn: turn_around, "
        "turn_clockwise; on: π0 p0; order: q0 q0");
  CHECK(found.failure == std::vector<std::string>{"q0", "q0"});
  CHECK(instance_text({"order", {{"q", "q"}, {"r", "place(s)"}}}) == "order(q, place(s))");
  CHECK(instance_text({"turns", {}}) == "turns");
}
