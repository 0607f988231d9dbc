#include "engine/ask/joint_search.hpp"

#include <algorithm>
#include <unordered_set>

namespace asterism {
namespace {

constexpr std::size_t most_positions = std::size_t{1} << 23;  ///< some 100 MB with what goes along

/// Of a row of positions.
std::size_t hash_of(std::span<const ArmId> row) {
  std::size_t hash = row.size();
  for (const ArmId arm : row) hash = (hash ^ arm.index()) * 0x9e3779b97f4a7c15U + (hash >> 29U);
  return hash;
}

}  // namespace

void JointSearch::add(const RouteMap& map) {
  maps_.push_back(map);
  travels_to_goal_.push_back(map.travels_to(to_));
}

bool JointSearch::is_goal(std::size_t reached) const {
  const auto row = positions(reached);
  for (std::size_t m = 0; m < maps_.size(); ++m)
    if (travels_to_goal_[m][maps_[m].place(row[m])] != 0) return false;
  return true;
}

/// Writes down where a turn and a travel lead from there, at the end of `positions_`, and whether
/// all maps know it and none is then too far from the goal.
bool JointSearch::go_on(std::size_t reached, std::size_t turn, std::size_t most_travels) {
  const std::size_t travels = reached_[reached].travels + 1;
  const std::size_t size = positions_.size();
  for (std::size_t m = 0; m < maps_.size(); ++m) {
    const auto next = maps_[m].after(positions_[reached * maps_.size() + m], turn);
    if (!next || travels + travels_to_goal_[m][maps_[m].place(*next)] > most_travels) {
      positions_.resize(size, no_arm);
      return false;
    }
    positions_.push_back(*next);
  }
  reached_.push_back({reached, turn, travels});
  return true;
}

std::optional<Turns> JointSearch::shortest(std::size_t most_travels) {
  // Breadth-first over where the robot stands in all maps at once, the least turn first. Two ways
  // that come to the same arms in every map go on alike, so the first of them does.
  reached_.assign(1, {0, 0, 0});
  positions_.clear();
  most_travels = std::min(most_travels, RouteMap::far - 1);
  for (std::size_t m = 0; m < maps_.size(); ++m) {
    positions_.push_back(maps_[m].arrived(from_));
    if (travels_to_goal_[m][maps_[m].place(positions_.back())] > most_travels) return std::nullopt;
  }
  const auto hash = [&](std::size_t one) { return hash_of(positions(one)); };
  const auto equal = [&](std::size_t one, std::size_t other) {
    return std::ranges::equal(positions(one), positions(other));
  };
  std::unordered_set<std::size_t, decltype(hash), decltype(equal)> known(64, hash, equal);
  known.insert(0);
  for (std::size_t i = 0; i < reached_.size(); ++i) {
    if (is_goal(i)) return turns_to(reached_, i);
    std::size_t turns = SIZE_MAX;
    for (std::size_t m = 0; m < maps_.size(); ++m)
      turns = std::min(turns, maps_[m].turns(positions(i)[m]));
    for (std::size_t turn = 0; turn < turns; ++turn) {
      if (travels_left_ < maps_.size() || positions_.size() > most_positions) {
        gave_up_ = true;
        return std::nullopt;
      }
      travels_left_ -= maps_.size();
      if (!go_on(i, turn, most_travels)) continue;
      if (known.insert(reached_.size() - 1).second) continue;
      reached_.pop_back();
      positions_.resize(positions_.size() - maps_.size(), no_arm);
    }
  }
  return std::nullopt;
}

}  // namespace asterism
