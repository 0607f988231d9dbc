#include "tests/engine/ssh/basic_ssh.hpp"

#include <map>
#include <string>

#include "engine/arm_table.hpp"

namespace asterism {
namespace {

/// The arms faced at a visit, one after the other, if it was entered by this arm: of its own star,
/// or of that of the place it was to.
std::vector<ArmId> faced(const ArmTable& table, VisitId k, ArmId entered) {
  const Visit& visit = table.trace().visits[k.index()];
  const bool is_left = k.index() + 1 < table.visits();
  std::vector<ArmId> result;
  if (visit.entered_by || !is_left) result.push_back(table.opposite(entered));
  if (is_left) {
    const ArmId left = table.left(k, entered);
    if (result.empty() || result.back() != left) result.push_back(left);
  }
  return result;
}

Action turn(const ArmTable& table, ArmId from, ArmId to) {
  if (table.opposite(from) == to) return {Action::Kind::turn_around};
  const std::uint32_t size = table.star_size(table.visit_of(from));
  return {Action::Kind::turn,
          std::to_string((table.position(to) + size - table.position(from)) % size)};
}

}  // namespace

Experience basic_ssh(const Trace& trace) {
  const ArmTable table(trace);
  Experience result{.name = trace.name, .views = {}, .actions = {}};
  for (const VisitId k : table.all_visits()) {
    if (k.index() > 0) result.actions.push_back({Action::Kind::travel});
    const std::vector<ArmId> arms = faced(table, k, table.entered(k));
    for (std::size_t i = 0; i < arms.size(); ++i) {
      if (i > 0) result.actions.push_back(turn(table, arms[i - 1], arms[i]));
      result.views.push_back("v" + std::to_string(table.view(arms[i]).index()));
    }
  }
  return result;
}

std::vector<DStateId> basic_ssh_dstates(const Trace& trace, std::span<const Arrival> hypothesis) {
  const ArmTable table(trace);
  const std::vector<ArmId> named = table.named(hypothesis);
  std::map<ArmId, DStateId> known;
  std::vector<DStateId> result;
  for (const VisitId k : table.all_visits())
    for (const ArmId arm : faced(table, k, named[k.index()]))
      result.push_back(known.emplace(arm, known.size()).first->second);
  return result;
}

}  // namespace asterism
