#include "engine/explain.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "engine/arm_table.hpp"
#include "engine/facts.hpp"
#include "planarity/euler.hpp"

namespace asterism {
namespace {

/// All that a hypothesis says to the axioms, with the visit that each fact is from.
struct Problem {
  std::vector<Fact> facts;
  std::vector<std::size_t> visit_of_fact;  ///< of those after the general facts
  std::size_t general = 0;
};

Problem problem_of(const ArmTable& table, std::span<const Arrival> hypothesis) {
  Problem problem;
  problem.facts = general_facts();
  problem.general = problem.facts.size();
  const std::vector<ArmIndex> named = table.named(hypothesis);
  for (std::size_t k = 0; k < named.size(); ++k)
    for (const Fact& fact : visit_facts(table, std::span(named).first(k + 1))) {
      problem.facts.push_back(fact);
      problem.visit_of_fact.push_back(k);
    }
  return problem;
}

Refutation not_planar(std::span<const Arrival> child, const TopologicalMap& map) {
  Refutation result;
  result.not_planar = true;
  const std::size_t k = child.size() - 1;
  result.visits = {VisitId(k - 1), VisitId(k)};
  result.arms = {{child[k - 1].place, *map.left[k - 1]}, {child[k].place, *child[k].entered}};
  return result;
}

}  // namespace

std::optional<Refutation> explain_dropped(const Trace& trace, std::span<const Arrival> child,
                                          const AxiomSet& axioms, bool planar,
                                          unsigned timeout_ms) {
  const ArmTable table(trace, child.size());
  const Problem problem = problem_of(table, child);
  const auto clash = find_clash(axioms, problem.facts, problem.general, timeout_ms);
  if (!clash) {
    const TopologicalMap map = make_map(table.trace(), child);
    if (planar && !is_planar(map)) return not_planar(child, map);
    return std::nullopt;
  }

  Refutation result;
  result.steps = clash->steps;
  std::set<std::string> names;
  std::set<PlaceArm> arms;
  std::map<std::string, PlaceArm> arm_of_dstate;
  const std::vector<ArmIndex> named = table.named(child);
  for (std::size_t k = 0; k < named.size(); ++k)
    if (table.visit_of(named[k]) == k)
      for (ArmIndex i = 0; i < table.star_size(k); ++i)
        arm_of_dstate.emplace(dstate_name(table, table.first_arm(k) + i),
                              PlaceArm{child[k].place, i});
  for (const Clash::Step& step : clash->steps) {
    if (names.insert(step.axiom).second) result.axioms.push_back(step.axiom);
    for (const auto& [variable, constant] : step.binding)
      if (const auto arm = arm_of_dstate.find(constant); arm != arm_of_dstate.end())
        arms.insert(arm->second);
  }
  result.arms.assign(arms.begin(), arms.end());
  std::set<VisitId> visits;
  for (std::size_t i = problem.general; i < problem.facts.size(); ++i)
    if (std::find(clash->facts.begin(), clash->facts.end(), problem.facts[i]) != clash->facts.end())
      visits.insert(VisitId(problem.visit_of_fact[i - problem.general]));
  result.visits.assign(visits.begin(), visits.end());
  return result;
}

std::string smt2_text(const Trace& trace, std::span<const Arrival> hypothesis,
                      const AxiomSet& axioms) {
  const ArmTable table(trace, hypothesis.size());
  std::string title = "Trace " + trace.name + ": visits at places";
  for (const Arrival& arrival : hypothesis) title += " " + std::to_string(arrival.place.index());
  std::replace_if(
      title.begin(), title.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return smt2_text(axioms, problem_of(table, hypothesis).facts, title);
}

}  // namespace asterism
