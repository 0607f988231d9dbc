#include "engine/ssh/ssh_table.hpp"

#include <map>
#include <string>

#include "core/error.hpp"
#include "engine/facts.hpp"

namespace asterism {
namespace {

/// A level of the search holds what follows from its dstates, each pair of them a bit.
constexpr std::size_t max_views = 1000;

std::string action_name(SshTable::ActionNumber action) {
  switch (action) {
    case SshTable::travel:
      return "travel";
    case SshTable::turn_around:
      return "turn_around";
    default:
      return "a" + std::to_string(action);
  }
}

std::string dstate_name(std::size_t first_view) { return "d" + std::to_string(first_view) + "_0"; }

}  // namespace

SshTable::SshTable(Experience experience) : experience_(std::move(experience)) {
  require_valid(experience_);
  if (experience_.views.size() > max_views)
    throw Error("experience: found more than " + std::to_string(max_views) +
                " views; expected fewer");
  std::map<std::string, std::uint32_t> view_numbers;
  for (const std::string& view : experience_.views)
    views_.push_back(
        view_numbers.emplace(view, static_cast<std::uint32_t>(view_numbers.size())).first->second);
  std::map<Action, ActionNumber> action_numbers{{{Action::Kind::travel}, travel},
                                                {{Action::Kind::turn_around}, turn_around}};
  for (const Action& action : experience_.actions)
    actions_.push_back(
        action_numbers.emplace(action, static_cast<ActionNumber>(action_numbers.size()))
            .first->second);
  different_actions_ = action_numbers.size();
}

std::vector<Fact> SshTable::general_facts() const {
  std::vector<Fact> facts = asterism::general_facts();
  for (std::size_t action = 2; action < different_actions_; ++action)
    facts.push_back({"is_turn", {action_name(static_cast<ActionNumber>(action))}});
  return facts;
}

Fact SshTable::sees(std::size_t first, std::size_t view) const {
  return {"sees", {dstate_name(first), "v" + std::to_string(views_[view])}};
}

Fact SshTable::leads(std::size_t from, std::size_t k, std::size_t to) const {
  return {"leads", {dstate_name(from), action_name(actions_[k]), dstate_name(to)}};
}

std::vector<Fact> SshTable::step_facts(std::span<const DStateId> dstates) const {
  const std::size_t k = dstates.size() - 1;
  const std::vector<std::size_t> first = first_views(dstates);
  const std::size_t here = first[dstates[k].index()];
  std::vector<Fact> facts{sees(here, k)};
  if (k > 0) facts.push_back(leads(first[dstates[k - 1].index()], k - 1, here));
  return facts;
}

std::vector<std::size_t> first_views(std::span<const DStateId> dstates) {
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < dstates.size(); ++k)
    if (dstates[k].index() == result.size()) result.push_back(k);
  return result;
}

}  // namespace asterism
