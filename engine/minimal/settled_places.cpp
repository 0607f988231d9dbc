#include "engine/minimal/settled_places.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace asterism {

void SettledPlaces::reset() {
  is_settled_.assign(table_.visits(), false);
  visits_.clear();
  arms_.assign(words_for(table_.size()), 0);
}

void SettledPlaces::settle(VisitId visit) {
  is_settled_[visit] = true;
  visits_.push_back(visit);
  for (const ArmId arm : table_.arms(visit)) arms_[word_of(arm)] |= bit_of(arm);
}

bool SettledPlaces::undo(Mark mark) {
  if (visits_.size() <= mark) return false;
  for (; visits_.size() > mark; visits_.pop_back()) {
    is_settled_[visits_.back()] = false;
    for (const ArmId arm : table_.arms(visits_.back())) arms_[word_of(arm)] &= ~bit_of(arm);
  }
  return true;
}

bool SettledPlaces::are_joined_once(const IdentifiedArms& identified) const {
  for (const VisitId visit : visits_) {
    std::vector<VisitId> neighbours;
    for (const ArmId arm : table_.arms(visit))
      if (const auto to = across(identified, arm)) neighbours.push_back(table_.visit_of(*to));
    std::ranges::sort(neighbours);
    if (std::ranges::adjacent_find(neighbours) != neighbours.end()) return false;
  }
  return true;
}

bool SettledPlaces::paths_cross_once(const IdentifiedArms& identified) const {
  const auto end_of_path = [&](ArmId arm) {
    for (auto to = identified.across(arm); to; to = identified.across(arm))
      arm = table_.opposite(*to);
    return arm;
  };
  std::map<VisitId, std::vector<ArmId>> paths_at;  // ends of paths, by settled place
  for (const VisitId visit : visits_)
    for (const ArmId arm : table_.arms(visit))
      if (arm < table_.opposite(arm))
        paths_at[visit].push_back(std::min(end_of_path(arm), end_of_path(table_.opposite(arm))));
  std::map<std::pair<ArmId, ArmId>, int> meetings;
  for (auto& [visit, paths] : paths_at) {
    std::ranges::sort(paths);
    for (std::size_t i = 0; i < paths.size(); ++i)
      for (std::size_t j = i + 1; j < paths.size(); ++j)
        if (++meetings[{paths[i], paths[j]}] > 1) return false;
  }
  return true;
}

}  // namespace asterism
