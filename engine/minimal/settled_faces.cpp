#include "engine/minimal/settled_faces.hpp"

namespace asterism {

SettledFaces::SettledFaces(const ArmTable& table)
    : table_(table),
      face_(table.size(), 0),
      part_(table.visits(), 0),
      walked_(table.size()),
      reached_(table.visits()) {}

bool SettledFaces::number(const IdentifiedArms& identified, const SettledPlaces& settled) {
  const std::size_t ends = number_faces(identified, settled);
  number_parts(identified, settled);
  return settled.visits().size() + faces_ == ends / 2 + 2 * parts_;
}

std::size_t SettledFaces::number_faces(const IdentifiedArms& identified,
                                       const SettledPlaces& settled) {
  std::size_t ends = 0;
  faces_ = 0;
  walked_.clear();
  for (const VisitId visit : settled.visits()) {
    bool is_joined = false;
    for (const ArmId arm : table_.arms(visit)) {
      auto to = settled.across(identified, arm);
      if (!to) continue;
      is_joined = true;
      ++ends;
      if (walked_.contains(arm)) continue;
      for (ArmId on_face = arm; walked_.insert(on_face);) {
        on_face = table_.clockwise(*to, 1);
        for (; !(to = settled.across(identified, on_face)); on_face = table_.clockwise(on_face, 1))
          face_[on_face] = faces_;
      }
      ++faces_;
    }
    if (is_joined) continue;
    for (const ArmId arm : table_.arms(visit)) face_[arm] = faces_;
    ++faces_;
  }
  return ends;
}

void SettledFaces::number_parts(const IdentifiedArms& identified, const SettledPlaces& settled) {
  parts_ = 0;
  reached_.clear();
  for (const VisitId root : settled.visits()) {
    if (!reached_.insert(root)) continue;
    for (to_do_.assign(1, root); !to_do_.empty();) {
      const VisitId visit = to_do_.back();
      to_do_.pop_back();
      part_[visit] = parts_;
      for (const ArmId arm : table_.arms(visit)) {
        const auto to = settled.across(identified, arm);
        if (to && reached_.insert(table_.visit_of(*to))) to_do_.push_back(table_.visit_of(*to));
      }
    }
    ++parts_;
  }
}

bool SettledFaces::may_stand_at(ArmId x, ArmId y, const IdentifiedArms& identified,
                                const SettledPlaces& settled) const {
  const std::uint32_t size = table_.star_size(table_.visit_of(x));
  for (std::uint32_t step = 0; step < size; ++step) {
    const auto from = settled.across(identified, table_.clockwise(x, step));
    if (from && are_apart(*from, table_.clockwise(y, step))) return false;
  }
  return true;
}

bool SettledFaces::may_stand_apart(ArmId x, const IdentifiedArms& identified,
                                   const SettledPlaces& settled) const {
  OptionalArm before;
  for (const ArmId arm : table_.arms(table_.visit_of(x))) {
    const auto from = settled.across(identified, arm);
    if (!from) continue;
    if (before && are_apart(*from, *before)) return false;
    before = from;
  }
  return true;
}

}  // namespace asterism
