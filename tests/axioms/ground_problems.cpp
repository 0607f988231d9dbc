#include "tests/axioms/ground_problems.hpp"

#include <map>

namespace asterism {
namespace {

/// "(forall ((q DState) ...) (=> PREMISE CONCLUSION))" over q, r, s, t as far as they are asked
/// for.
std::string over(const std::string& dstates, const std::string& implication) {
  std::string variables;
  for (const char dstate : dstates) variables += std::string("(") + dstate + " DState) ";
  return "(forall (" + variables + ") (=> " + implication + "))";
}

}  // namespace

GroundProblem only_decided_by(const std::string& axiom) {
  static const std::map<std::string, GroundProblem> problems{
      {"deterministic", {"leads q travel r, leads q travel s"}},
      {"view", {"sees q v, sees q w"}},
      {"reversible",
       {"leads s travel t, leads s turn_around r, leads t turn_around q", "(leads q travel r)"}},
      {"star", {"next q r, next s r"}},
      {"path_end", {"ends q, order q r"}},
      {"star_binding", {"opposite q r", "(leads q turn_around r)"}},
      {"turn", {"leads q a r, is_turn a", "(= (place q) (place r))"}},
      {"travel", {"leads q travel r", "(= (along q) (along r))"}},
      {"turn_around", {"leads q turn_around r", "(= (along r) (opp (along q)))"}},
      {"on", {"sees q v", "(on (along q) (place q))"}},
      {"order", {"leads q travel r", "(order q r)"}},
      {"order_on", {"order q r", "(on (along q) (place r))"}},
      {"irreflexive", {"leads q a r, is_turn a, order q r"}},
      {"opposite", {"order s t, leads s turn_around r, leads t turn_around q", "(order q r)"}},
      {"transitive", {"order q s, order s r", "(order q r)"}},
      {"one_segment", {"leads q travel r, leads s travel t, leads q a s, leads r a t, is_turn a"}},
      {"one_crossing", {"order q r, order s t, leads q a s, leads r a t, is_turn a"}}};
  return problems.at(axiom);
}

const std::vector<Weakening>& weakenings() {
  const std::string neighbours = "(and (next q r) (next q s) (next t r)) ";
  const std::string opposites = "(and (opposite q r) (opposite q s) (opposite t r)) ";
  const std::string same_places = "(= (place q) (place s)) (= (place r) (place t))";
  const GroundProblem two_travels{"leads q travel r, leads q travel s"};
  static const std::vector<Weakening> result{
      {"deterministic", "travel has one result",
       "(forall ((q DState) (a Action) (r DState) (s DState))"
       " (=> (and (leads q a r) (leads q a s) (is_turn a)) (= r s)))",
       two_travels},
      {"deterministic",
       "a turn has one result",
       over("qrs", "(and (leads q travel r) (leads q travel s)) (= r s)"),
       {"leads q turn_around r, leads q turn_around s"}},
      {"view",
       "one view where the path ends",
       "(forall ((q DState) (v View) (w View))"
       " (=> (and (sees q v) (sees q w) (not (ends q))) (= v w)))",
       {"sees q v, sees q w, ends q"}},
      {"reversible",
       "the way back is a travel",
       over("qrst",
            "(and (leads q travel r) (leads q turn_around s) (leads r turn_around t)) "
            "(order t s)"),
       {"leads s travel t, leads s turn_around r, leads t turn_around q", "(leads q travel r)"}},
      {"star",
       "one arm follows an arm",
       over("qrst", neighbours + "(and (= q t) (leads q turn_clockwise r))"),
       {},
       "next q r, next q s, next t r",
       "rs"},
      {"star",
       "one arm goes before an arm",
       over("qrst", neighbours + "(and (= r s) (leads q turn_clockwise r))"),
       {"next q r, next s r"}},
      {"star",
       "turning clockwise goes to the next arm",
       over("qrst", neighbours + "(and (= r s) (= q t))"),
       {"next q r", "(leads q turn_clockwise r)"}},
      {"path_end",
       "nothing follows that is further than a travel",
       over("qr", "(and (ends q) (leads q travel r)) false"),
       {"ends q, order q r"}},
      {"star_binding",
       "an arm has one opposite",
       over("qrst", opposites + "(and (= q t) (opposite r q) (leads q turn_around r))"),
       {},
       "opposite q r, opposite q s, opposite t r",
       "rs"},
      {"star_binding",
       "an arm is the opposite of one",
       over("qrst", opposites + "(and (= r s) (opposite r q) (leads q turn_around r))"),
       {},
       "opposite q r, opposite q s, opposite t r",
       "qt"},
      {"star_binding",
       "the opposite's opposite is the arm",
       over("qrst", opposites + "(and (= r s) (= q t) (leads q turn_around r))"),
       {"opposite q r", "(opposite r q)"}},
      {"star_binding",
       "turning around goes to the opposite arm",
       over("qrst", opposites + "(and (= r s) (= q t) (opposite r q))"),
       {"opposite q r", "(leads q turn_around r)"}},
      {"turn",
       "other turns than turn-arounds stay",
       over("qr", "(leads q turn_around r) (= (place q) (place r))"),
       {"leads q a r, is_turn a", "(= (place q) (place r))"}},
      {"travel",
       "the direction stays",
       over("qr",
            "(leads q travel r) "
            "(or (= (along q) (along r)) (= (along r) (opp (along q))))"),
       {"leads q travel r", "(= (along q) (along r))"}},
      {"turn_around",
       "the direction is reversed",
       over("qr",
            "(leads q turn_around r) "
            "(or (= (along q) (along r)) (= (along r) (opp (along q))))"),
       {"leads q turn_around r", "(= (along r) (opp (along q)))"}},
      {"on",
       "the place is on a path that ends there",
       "(forall ((q DState) (v View))"
       " (=> (and (sees q v) (not (ends q))) (on (along q) (place q))))",
       {"sees q v, ends q", "(on (along q) (place q))"}},
      {"order",
       "which place comes first",
       over("qr", "(leads q travel r) (or (order q r) (order r q))"),
       {"leads q travel r", "(order q r)"}},
      {"order_on",
       "the first place is on the path",
       over("qr", "(order q r) (on (along q) (place r))"),
       {"order q r", "(on (along q) (place q))"}},
      {"order_on",
       "the second place is on the path",
       over("qr", "(order q r) (on (along q) (place q))"),
       {"order q r", "(on (along q) (place r))"}},
      {"irreflexive",
       "two dstates of one place are not in order",
       over("qr", "(order q r) (not (= q r))"),
       {"leads q a r, is_turn a, order q r"}},
      {"opposite",
       "order is reversed further than a travel",
       over("qrst",
            "(and (leads q travel r) (leads q turn_around s) (leads r turn_around t)) "
            "(order t s)"),
       {"order s t, leads s turn_around r, leads t turn_around q", "(order q r)"}},
      {"transitive",
       "the second step may be longer than a travel",
       over("qrs", "(and (order q r) (leads r travel s)) (order q s)"),
       {"order q s, order s r", "(order q r)"}},
      {"one_segment",
       "two segments are on two paths",
       over("qrst", "(and (leads q travel r) (leads s travel t) " + same_places +
                        ") (= (along q) (along s))"),
       {"leads q travel r, leads s travel t, leads q a s, leads r a t, is_turn a"}},
      {"one_crossing",
       "two dstates are on two paths",
       over("qrst", "(and (order q r) (order s t) " + same_places + ") (= (along q) (along s))"),
       {"order q r, order s t, leads q a s, leads r a t, is_turn a"}}};
  return result;
}

std::vector<GroundProblem> ways_to_fail(const Weakening& weakening) {
  const std::string variables = "qrst";
  std::vector<GroundProblem> result;
  for (unsigned number = 0; number < 256; ++number) {
    const auto bound = [&](char variable) {
      const unsigned at = static_cast<unsigned>(variables.find(variable));
      return "d" + std::to_string(number >> (2 * at) & 3U);
    };
    // Words of one letter are the variables.
    std::string facts;
    for (std::size_t i = 0; i < weakening.premise.size(); ++i) {
      const char c = weakening.premise[i];
      const bool begins = i == 0 || weakening.premise[i - 1] == ' ';
      const bool ends = i + 1 == weakening.premise.size() || weakening.premise[i + 1] == ' ' ||
                        weakening.premise[i + 1] == ',';
      const bool is_variable = begins && ends && variables.find(c) != std::string::npos;
      facts += is_variable ? bound(c) : std::string(1, c);
    }
    result.push_back({facts, "(= q r)", bound(weakening.equal[0]), bound(weakening.equal[1])});
  }
  return result;
}

}  // namespace asterism
