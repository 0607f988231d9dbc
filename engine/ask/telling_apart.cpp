#include "engine/ask/telling_apart.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "core/id_vector.hpp"
#include "engine/ask/replay.hpp"
#include "engine/minimal/minimal_models.hpp"

namespace asterism {
namespace {

constexpr std::size_t states_between_questions = 256;
constexpr ArmId nowhere = no_arm;

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
      IdVector<ArmId, ArmId>& across = across_.emplace_back();
      for (const ArmId arm : table().all_arms())
        across.push_back(map_.engine().across(arm).value_or(nowhere));
    }
  }

  std::size_t size() const { return arrived_.size(); }
  const ArmTable& table() const { return map_.table(); }
  const std::vector<ArmId>& arrived() const { return arrived_; }
  /// The gateway reached, or nowhere where there is none or no segment.
  ArmId travel(std::size_t model, ArmId arrived, std::size_t turn) const {
    if (turn >= table().star_size(table().visit_of(arrived))) return nowhere;
    return across_[model][table().clockwise(arrived, turn)];
  }
  Star seen(ArmId arrived) const {
    const VisitId visit = table().visit_of(arrived);
    return star_as_seen(table().trace().visits[visit.index()].star, table().position(arrived));
  }

 private:
  Replay map_;
  std::vector<ArmId> arrived_;
  std::vector<IdVector<ArmId, ArmId>> across_;
};

/// Where the robot is in each model, and which of these have expected the same so far. A model
/// alone is told apart: it does not matter where the robot is in it.
struct State {
  std::vector<ArmId> arrived;
  std::vector<std::uint32_t> group;  ///< numbered by first model

  friend auto operator<=>(const State&, const State&) = default;
};

/// The group a model was in, and the view it expects.
using Kind = std::pair<std::uint32_t, ViewId>;

/// Groups the models by numbers of their own kind, and forgets those that are alone.
void regroup(State& state, const std::vector<Kind>& kinds) {
  std::map<Kind, std::pair<std::uint32_t, std::size_t>> groups;
  for (std::size_t m = 0; m < kinds.size(); ++m) {
    const auto number = static_cast<std::uint32_t>(groups.size());
    auto& [group, members] = groups.try_emplace(kinds[m], number, 0).first->second;
    state.group[m] = group;
    ++members;
  }
  for (std::size_t m = 0; m < kinds.size(); ++m)
    if (groups.at(kinds[m]).second == 1) state.arrived[m] = nowhere;
}

bool is_alone(const State& state, std::size_t model) { return state.arrived[model] == nowhere; }

bool all_alone(const State& state) {
  return std::ranges::all_of(state.arrived, [](ArmId arm) { return arm == nowhere; });
}

State start(const Models& models) {
  State state{models.arrived(), std::vector<std::uint32_t>(models.size())};
  regroup(state, std::vector<Kind>(models.size(), Kind(0, ViewId(0))));
  return state;
}

/// The state after one more travel, unless some model not yet told apart expects nothing for sure.
std::optional<State> after(const Models& models, const State& state, std::size_t turn) {
  State next = state;
  std::vector<Kind> kinds;
  for (std::size_t m = 0; m < models.size(); ++m) {
    if (is_alone(state, m)) {
      kinds.emplace_back(state.group[m], ViewId(0));
      continue;
    }
    next.arrived[m] = models.travel(m, state.arrived[m], turn);
    if (next.arrived[m] == nowhere) return std::nullopt;
    kinds.emplace_back(state.group[m], models.table().view(next.arrived[m]));
  }
  regroup(next, kinds);
  return next;
}

std::size_t most_turns(const ArmTable& table) {
  std::uint32_t most = 0;
  for (const VisitId k : table.all_visits()) most = std::max(most, table.star_size(k));
  return most;
}

std::vector<std::vector<Star>> expected_by(const Models& models, const Turns& turns) {
  std::vector<std::vector<Star>> expected(models.size());
  State state = start(models);
  for (const std::size_t turn : turns) {
    for (std::size_t m = 0; m < models.size(); ++m)
      if (!is_alone(state, m))
        expected[m].push_back(models.seen(models.travel(m, state.arrived[m], turn)));
    state = *after(models, state, turn);
  }
  return expected;
}

}  // namespace

TellingApart tell_apart(const MapList& list, std::size_t most_numbers, const Stop& stop) {
  using Answer = TellingApart::Answer;
  const Models models(list);
  struct Reached {
    const State* state;
    std::size_t before;  ///< in `reached`
    std::size_t turn;
  };
  std::set<State> states{start(models)};
  std::vector<Reached> reached{{&*states.begin(), 0, 0}};
  const std::size_t turns = most_turns(models.table());
  for (std::size_t i = 0; i < reached.size(); ++i) {
    if (all_alone(*reached[i].state)) {
      TellingApart found{Answer::found, turns_to(reached, i), {}};
      found.expected = expected_by(models, found.turns);
      return found;
    }
    if (i % states_between_questions == 0 && stop.is_due()) return {Answer::stopped, {}, {}};
    for (std::size_t turn = 0; turn < turns; ++turn) {
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
