#include "engine/facts.hpp"

namespace asterism {
namespace {

std::string view_name(ArmIndex view) { return "v" + std::to_string(view); }

}  // namespace

std::string dstate_name(const ArmTable& table, ArmIndex arm) {
  const ArmIndex visit = table.visit_of(arm);
  return "d" + std::to_string(visit) + "_" + std::to_string(arm - table.first_arm(visit));
}

std::vector<Fact> general_facts() {
  return {{"is_turn", {"turn_around"}}, {"is_turn", {"turn_clockwise"}}};
}

std::vector<Fact> place_facts(const ArmTable& table, std::size_t k) {
  std::vector<Fact> facts;
  const ArmIndex first = table.first_arm(k);
  for (ArmIndex arm = first; arm < first + table.star_size(k); ++arm) {
    const std::string dstate = dstate_name(table, arm);
    facts.push_back({"sees", {dstate, view_name(table.view(arm))}});
    facts.push_back({"opposite", {dstate, dstate_name(table, table.opposite(arm))}});
    facts.push_back({"next", {dstate, dstate_name(table, table.clockwise(arm, 1))}});
    if (!table.has_gateway(arm)) facts.push_back({"ends", {dstate}});
  }
  return facts;
}

std::vector<Fact> travel_facts(const ArmTable& table, std::size_t k, ArmIndex left,
                               ArmIndex entered) {
  // The arm entered by leads back: the robot faces the opposite one.
  const std::string arrived = dstate_name(table, table.opposite(entered));
  const ArmIndex faced = table.opposite(table.entered(k));
  return {{"sees", {arrived, view_name(table.view(faced))}},
          {"leads", {dstate_name(table, left), "travel", arrived}}};
}

std::vector<Fact> visit_facts(const ArmTable& table, std::span<const ArmIndex> named) {
  const std::size_t k = named.size() - 1;
  std::vector<Fact> facts;
  if (table.visit_of(named[k]) == k) facts = place_facts(table, k);
  if (k > 0) {
    const auto travel = travel_facts(table, k, table.left(k - 1, named[k - 1]), named[k]);
    facts.insert(facts.end(), travel.begin(), travel.end());
  }
  return facts;
}

}  // namespace asterism
