#include "engine/minimal/folding.hpp"

#include <algorithm>
#include <optional>

#include "core/id_vector.hpp"

namespace asterism {

Folding::Folding(const ArmTable& table, NativeEngine::Rules rules)
    : table_(table),
      rules_(rules),
      arms_(table),
      settled_(table),
      faces_(table),
      on_path_(table.visits()) {}

Verdict Folding::begin(std::span<const Assumption> assumptions, const Folding* before,
                       const Stop& stop) {
  arms_.reset();
  settled_.reset();
  faces_are_numbered_ = false;
  if (before != nullptr) arms_.know(before->arms_);
  if (!assume(assumptions)) return Verdict::inconsistent;
  for (const VisitId k : IdRange(VisitId(1), VisitId(table_.visits())))
    if (!join(table_.left(k.previous(), table_.entered(k.previous())), table_.entered(k)))
      return Verdict::inconsistent;
  if (!try_all(stop)) return Verdict::undecided;
  arms_.keep();
  return Verdict::consistent;
}

/// An assumption that names a visit to come holds from then on.
/// @return false if one contradicts itself
bool Folding::assume(std::span<const Assumption> assumptions) {
  same_.clear();
  differ_.clear();
  for (const auto& [kind, one, other] : assumptions) {
    if (std::max(one, other).index() >= table_.visits()) continue;
    if (kind == Assumption::Kind::same) {
      same_.emplace_back(one, other);
      continue;
    }
    if (one == other) return false;
    differ_.emplace_back(one, other);
    const ArmId x = table_.first_arm(one);
    for (const ArmId y : table_.arms(other))
      if (arms_.allows(x, y)) arms_.forbid(x, y);
  }
  return true;
}

/// Two visits in a row: a travel from x to y.
bool Folding::join(ArmId x, ArmId y) {
  to_identify_.clear();
  changed_.clear();
  x = arms_.representative(x);
  y = arms_.representative(y);
  for (const auto& [from, to] : {std::pair(x, y), std::pair(y, x)}) {
    if (const auto known = arms_.across(from))
      to_identify_.emplace_back(*known, to);
    else
      arms_.join(from, to);
  }
  changed_.push_back(table_.visit_of(x));
  return go_on_identifying();
}

/// What cannot be by itself cannot be in any map: tries every two arms. Those found earlier make
/// later ones shorter.
/// @return false if it is to stop
bool Folding::try_all(const Stop& stop) {
  constexpr std::uint64_t united_between_questions = 2'000;
  std::uint64_t asked = united_;
  const VisitId end(table_.visits());
  for (const VisitId visit : table_.all_visits()) {
    if (!arms_.represents(visit)) continue;
    if (stop.is_due()) return false;
    const ArmId x = table_.first_arm(visit);
    for (const VisitId other : IdRange(visit.next(), end)) {
      if (!arms_.represents(other)) continue;
      for (const ArmId y : table_.arms(other)) {
        if (!arms_.allows(x, y)) continue;
        if (united_ - asked >= united_between_questions) {
          asked = united_;
          if (stop.is_due()) return false;
        }
        const Mark here = mark();
        const bool can_be = identify(x, y);
        undo(here);
        if (!can_be) arms_.forbid(x, y);
      }
    }
  }
  return true;
}

bool Folding::identify(ArmId x, ArmId y) {
  to_identify_.clear();
  changed_.clear();
  to_identify_.emplace_back(x, y);
  if (!go_on_identifying()) return false;
  return std::ranges::none_of(
             changed_,
             [&](VisitId visit) { return settled_.contains(arms_.representative(visit)); }) ||
         settled_places_agree();
}

bool Folding::contradicts(ArmId x, ArmId y) const {
  const VisitId one = table_.visit_of(x);
  const VisitId other = table_.visit_of(y);
  return one == other || (settled_.contains(one) && settled_.contains(other)) ||
         !arms_.may_be_one(x, y);
}

bool Folding::go_on_identifying() {
  while (!to_identify_.empty()) {
    const ArmId x = arms_.representative(to_identify_.back().first);
    const ArmId y = arms_.representative(to_identify_.back().second);
    to_identify_.pop_back();
    if (x == y) continue;
    if (contradicts(x, y)) return false;
    const VisitId one = table_.visit_of(x);
    const VisitId other = table_.visit_of(y);
    // A look at what would follow at once costs less than to unite and undo.
    for (std::uint32_t step = 0; step < table_.star_size(one); ++step) {
      const auto a = arms_.across(table_.clockwise(x, step));
      const auto b = arms_.across(table_.clockwise(y, step));
      if (a && b && *a != *b && contradicts(*a, *b)) return false;
    }
    const bool one_stays =
        settled_.contains(one) ||
        (!settled_.contains(other) && arms_.visits_there(one) >= arms_.visits_there(other));
    arms_.unite(one_stays ? x : y, one_stays ? y : x,
                [&](ArmId a, ArmId b) { to_identify_.emplace_back(a, b); });
    changed_.push_back(one_stays ? one : other);
    ++united_;
  }
  return differ_as_assumed() && std::ranges::all_of(changed_, [&](VisitId visit) {
           return paths_are_lines(arms_.representative(visit));
         });
}

/// What may be one is asked of representatives, and forgets what two visits under them may not.
bool Folding::differ_as_assumed() const {
  return std::ranges::none_of(differ_, [&](const auto& visits) {
    return arms_.representative(visits.first) == arms_.representative(visits.second);
  });
}

bool Folding::settle(ArmId arm) {
  const VisitId visit = table_.visit_of(arms_.representative(arm));
  if (settled_.contains(visit)) return false;
  settled_.settle(visit);
  return settled_places_agree();
}

void Folding::undo(Mark mark) {
  const bool any_identified = arms_.undo(mark.identified);
  const bool any_settled = settled_.undo(mark.settled);
  if (any_identified || any_settled) faces_are_numbered_ = false;
}

/// No path through this place comes to a place twice.                              [BMK10, (8)]
bool Folding::paths_are_lines(VisitId visit) {
  for (const ArmId arm : table_.arms(visit))
    if (arm < table_.opposite(arm) && !is_line(arm)) return false;
  return true;
}

bool Folding::is_line(ArmId arm) {
  on_path_.clear();
  on_path_.insert(table_.visit_of(arm));
  for (const ArmId way : {arm, table_.opposite(arm)})
    for (auto to = arms_.across(way); to; to = arms_.across(table_.opposite(*to)))
      if (!on_path_.insert(table_.visit_of(*to))) return false;
  return true;
}

/// What holds of places that differ, in every map to come.
bool Folding::settled_places_agree() {
  for (const auto& [one, other] : same_) {
    const VisitId a = arms_.representative(one);
    const VisitId b = arms_.representative(other);
    if (a != b && settled_.contains(a) && settled_.contains(b)) return false;
  }
  faces_are_numbered_ = rules_.faces;
  return (!rules_.faces || faces_.number(arms_, settled_)) &&
         (!rules_.one_segment || settled_.are_joined_once(arms_)) &&
         (!rules_.one_crossing || settled_.paths_cross_once(arms_));
}

void Folding::number_faces() {
  if (rules_.faces && !faces_are_numbered_) faces_.number(arms_, settled_);
  faces_are_numbered_ = true;
}

bool Folding::may_be_any(ArmId x, std::span<const std::uint64_t> arms) const {
  bool any = false;
  arms_.for_each_that_may_be(x, arms, [&](ArmId y) { return !(any = may_stand_at(y, x)); });
  return any;
}

std::vector<ArmId> Folding::named() const {
  IdVector<VisitId, std::optional<VisitId>> first_visit(table_.visits());  // of representatives
  std::vector<ArmId> result;
  for (const VisitId k : table_.all_visits()) {
    const ArmId entered = arms_.representative(table_.entered(k));
    const VisitId visit = table_.visit_of(entered);
    if (!first_visit[visit]) first_visit[visit] = k;
    const ArmId first = table_.first_arm(*first_visit[visit]);
    const std::uint32_t begins = table_.position(arms_.representative(first));
    const std::uint32_t size = table_.star_size(visit);
    result.push_back(table_.clockwise(first, (table_.position(entered) + size - begins) % size));
  }
  return result;
}

}  // namespace asterism
