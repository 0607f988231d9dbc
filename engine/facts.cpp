#include "engine/facts.hpp"

#include <algorithm>

#include "axioms/smt2_text.hpp"

namespace asterism {
namespace {

std::string view_name(ViewId view) { return "v" + std::to_string(view.index()); }

}  // namespace

std::string dstate_name(const ArmTable& table, ArmId arm) {
  return "d" + std::to_string(table.visit_of(arm).index()) + "_" +
         std::to_string(table.position(arm));
}

std::vector<Fact> general_facts() {
  return {{"is_turn", {"turn_around"}}, {"is_turn", {"turn_clockwise"}}};
}

std::vector<Fact> place_facts(const ArmTable& table, VisitId k) {
  std::vector<Fact> facts;
  for (const ArmId arm : table.arms(k)) {
    const std::string dstate = dstate_name(table, arm);
    facts.push_back({"sees", {dstate, view_name(table.view(arm))}});
    facts.push_back({"opposite", {dstate, dstate_name(table, table.opposite(arm))}});
    facts.push_back({"next", {dstate, dstate_name(table, table.clockwise(arm, 1))}});
    if (!table.has_gateway(arm)) facts.push_back({"ends", {dstate}});
  }
  return facts;
}

std::vector<Fact> travel_facts(const ArmTable& table, VisitId k, ArmId left, ArmId entered) {
  // The arm entered by leads back: the robot faces the opposite one.
  const std::string arrived = dstate_name(table, table.opposite(entered));
  const ArmId faced = table.opposite(table.entered(k));
  return {{"sees", {arrived, view_name(table.view(faced))}},
          {"leads", {dstate_name(table, left), "travel", arrived}}};
}

std::vector<Fact> visit_facts(const ArmTable& table, std::span<const ArmId> named) {
  const VisitId k(named.size() - 1);
  std::vector<Fact> facts;
  if (table.visit_of(named.back()) == k) facts = place_facts(table, k);
  if (k.index() > 0) {
    const VisitId before = k.previous();
    const ArmId left = table.left(before, named[before.index()]);
    const auto travel = travel_facts(table, k, left, named.back());
    facts.insert(facts.end(), travel.begin(), travel.end());
  }
  return facts;
}

std::vector<Fact> map_facts(const ArmTable& table, std::span<const ArmId> named) {
  std::vector<Fact> facts = general_facts();
  for (std::size_t k = 0; k < named.size(); ++k) {
    const auto more = visit_facts(table, named.first(k + 1));
    facts.insert(facts.end(), more.begin(), more.end());
  }
  return facts;
}

std::string smt2_text(const Trace& trace, std::span<const Arrival> hypothesis,
                      const AxiomSet& axioms) {
  const ArmTable table(trace, hypothesis.size());
  std::string title = "Trace " + trace.name + ": visits at places";
  for (const Arrival& arrival : hypothesis) title += " " + std::to_string(arrival.place.index());
  std::ranges::replace_if(
      title, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return smt2_text(axioms, map_facts(table, table.named(hypothesis)), title);
}

}  // namespace asterism
