#include "engine/telling_apart.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "engine/minimal_models.hpp"
#include "engine/replay.hpp"

namespace asterism {
namespace {

constexpr std::size_t states_between_questions = 256;
constexpr ArmIndex nowhere = UINT32_MAX;

/// The minimal models, as far as the robot can go along their segments.
class Models {
 public:
  explicit Models(const MapList& list) : map_(list) {
    std::vector<std::vector<Arrival>> models;
    list.for_each_while([&](std::span<const Arrival> model) {
      models.emplace_back(model.begin(), model.end());
      return true;
    });
    std::ranges::sort(models, is_before);
    for (const std::vector<Arrival>& model : models) {
      map_.go_to(model);
      arrived_.push_back(map_.arrived());
      std::vector<ArmIndex>& across = across_.emplace_back();
      for (ArmIndex arm = 0; arm < table().size(); ++arm)
        across.push_back(map_.engine().across(arm).value_or(nowhere));
    }
  }

  std::size_t size() const { return arrived_.size(); }
  const ArmTable& table() const { return map_.table(); }
  const std::vector<ArmIndex>& arrived() const { return arrived_; }
  /// The gateway reached, or nowhere where there is none or no segment.
  ArmIndex travel(std::size_t model, ArmIndex arrived, ArmIndex turn) const {
    if (turn >= table().star_size(table().visit_of(arrived))) return nowhere;
    return across_[model][table().clockwise(arrived, turn)];
  }
  Star seen(ArmIndex arrived) const {
    const std::size_t visit = table().visit_of(arrived);
    return star_as_seen(table().trace().visits[visit].star, arrived - table().first_arm(visit));
  }

 private:
  Replay map_;
  std::vector<ArmIndex> arrived_;
  std::vector<std::vector<ArmIndex>> across_;
};

/// Where the robot is in each model, and which of these have expected the same so far. A model
/// alone is told apart: it does not matter where the robot is in it.
struct State {
  std::vector<ArmIndex> arrived;
  std::vector<ArmIndex> group;  ///< numbered by first model

  friend auto operator<=>(const State&, const State&) = default;
};

/// Groups the models by numbers of their own kind, and forgets those that are alone.
void regroup(State& state, const std::vector<std::pair<ArmIndex, ArmIndex>>& kinds) {
  std::map<std::pair<ArmIndex, ArmIndex>, std::pair<ArmIndex, std::size_t>> groups;
  for (std::size_t m = 0; m < kinds.size(); ++m) {
    const auto number = static_cast<ArmIndex>(groups.size());
    auto& [group, members] = groups.try_emplace(kinds[m], number, 0).first->second;
    state.group[m] = group;
    ++members;
  }
  for (std::size_t m = 0; m < kinds.size(); ++m)
    if (groups.at(kinds[m]).second == 1) state.arrived[m] = nowhere;
}

bool is_alone(const State& state, std::size_t model) { return state.arrived[model] == nowhere; }

bool all_alone(const State& state) {
  return std::ranges::all_of(state.arrived, [](ArmIndex arm) { return arm == nowhere; });
}

State start(const Models& models) {
  State state{models.arrived(), std::vector<ArmIndex>(models.size())};
  regroup(state, std::vector<std::pair<ArmIndex, ArmIndex>>(models.size()));
  return state;
}

/// The state after one more travel, unless some model not yet told apart expects nothing for sure.
std::optional<State> after(const Models& models, const State& state, ArmIndex turn) {
  State next = state;
  std::vector<std::pair<ArmIndex, ArmIndex>> kinds;
  for (std::size_t m = 0; m < models.size(); ++m) {
    if (is_alone(state, m)) {
      kinds.emplace_back(state.group[m], 0);
      continue;
    }
    next.arrived[m] = models.travel(m, state.arrived[m], turn);
    if (next.arrived[m] == nowhere) return std::nullopt;
    kinds.emplace_back(state.group[m], models.table().view(next.arrived[m]));
  }
  regroup(next, kinds);
  return next;
}

ArmIndex most_turns(const ArmTable& table) {
  ArmIndex most = 0;
  for (std::size_t k = 0; k < table.visits(); ++k) most = std::max(most, table.star_size(k));
  return most;
}

std::vector<std::vector<Star>> expected_by(const Models& models, const Turns& turns) {
  std::vector<std::vector<Star>> expected(models.size());
  State state = start(models);
  for (const std::size_t turn : turns) {
    for (std::size_t m = 0; m < models.size(); ++m)
      if (!is_alone(state, m))
        expected[m].push_back(
            models.seen(models.travel(m, state.arrived[m], static_cast<ArmIndex>(turn))));
    state = *after(models, state, static_cast<ArmIndex>(turn));
  }
  return expected;
}

}  // namespace

TellingApart tell_apart(const MapList& list, std::size_t most_numbers,
                        const std::function<bool()>& go_on) {
  using Answer = TellingApart::Answer;
  const Models models(list);
  struct Reached {
    const State* state;
    std::size_t from;  ///< in `reached`
    ArmIndex turn;
  };
  std::set<State> states{start(models)};
  std::vector<Reached> reached{{&*states.begin(), 0, 0}};
  const ArmIndex turns = most_turns(models.table());
  const auto turns_to = [&](std::size_t i) {
    Turns result;
    for (; i != 0; i = reached[i].from) result.push_back(reached[i].turn);
    std::ranges::reverse(result);
    return result;
  };
  for (std::size_t i = 0; i < reached.size(); ++i) {
    if (all_alone(*reached[i].state)) {
      TellingApart found{Answer::found, turns_to(i), {}};
      found.expected = expected_by(models, found.turns);
      return found;
    }
    if (i % states_between_questions == 0 && go_on && !go_on()) return {Answer::stopped, {}, {}};
    for (ArmIndex turn = 0; turn < turns; ++turn) {
      auto next = after(models, *reached[i].state, turn);
      if (!next) continue;
      const auto [state, is_new] = states.insert(*std::move(next));
      if (is_new) reached.push_back({&*state, i, turn});
    }
    if (states.size() * models.size() > most_numbers) return {Answer::out_of_bounds, {}, {}};
  }
  return {};
}

}  // namespace asterism
