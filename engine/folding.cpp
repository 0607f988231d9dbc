#include "engine/folding.hpp"

#include <algorithm>
#include <map>

namespace asterism {

Folding::Folding(const ArmTable& table, NativeEngine::Options axioms)
    : table_(table), axioms_(axioms), words_((table.size() + 63) / 64) {}

Verdict Folding::begin(std::span<const Assumption> assumptions, const Folding* before,
                       const std::function<bool()>& go_on) {
  const auto arms = static_cast<ArmIndex>(table_.size());
  const auto visits = static_cast<ArmIndex>(table_.visits());
  above_.assign(visits, none);
  visits_there_.assign(visits, 1);
  across_.assign(arms, none);
  settled_.assign(visits, false);
  settled_list_.clear();
  settled_arms_.assign(words_, 0);
  seen_.assign(arms, 0);
  face_.assign(arms, 0);
  part_.assign(visits, 0);
  faces_are_numbered_ = false;
  done_.clear();
  narrowed_.clear();

  std::vector<std::vector<std::uint64_t>> alike(table_.views(),
                                                std::vector<std::uint64_t>(words_, 0));
  for (ArmIndex arm = 0; arm < arms; ++arm)
    alike[table_.view(arm)][arm / 64] |= std::uint64_t{1} << (arm % 64);
  may_be_.clear();
  may_be_.reserve(arms * words_);
  for (ArmIndex arm = 0; arm < arms; ++arm)
    may_be_.insert(may_be_.end(), alike[table_.view(arm)].begin(), alike[table_.view(arm)].end());

  if (before != nullptr) know(*before);

  same_.clear();
  differ_.clear();
  for (const Assumption& assumption : assumptions) {
    const auto one = static_cast<ArmIndex>(assumption.one.index());
    const auto other = static_cast<ArmIndex>(assumption.other.index());
    if (std::max(one, other) >= visits) continue;  // holds from then on
    if (assumption.kind == Assumption::Kind::same) {
      same_.emplace_back(one, other);
    } else {
      if (one == other) return Verdict::inconsistent;
      differ_.emplace_back(one, other);
      for (ArmIndex step = 0; step < table_.star_size(other); ++step)
        if (has(table_.first_arm(one), table_.first_arm(other) + step))
          forbid(table_.first_arm(one), table_.first_arm(other) + step);
    }
  }

  for (ArmIndex k = 0; k + 1 < visits; ++k)
    if (!join(table_.left(k, table_.entered(k)), table_.entered(k + 1)))
      return Verdict::inconsistent;

  // What cannot be by itself cannot be in any map. Those found earlier make later ones shorter.
  constexpr std::uint64_t united_between_questions = 2'000;
  std::uint64_t asked = united_;
  for (ArmIndex visit = 0; visit < visits; ++visit) {
    if (!represents(visit)) continue;
    if (!go_on()) return Verdict::undecided;
    const ArmIndex x = table_.first_arm(visit);
    for (ArmIndex other = visit + 1; other < visits; ++other) {
      if (!represents(other)) continue;
      const ArmIndex first = table_.first_arm(other);
      for (ArmIndex y = first; y < first + table_.star_size(other); ++y) {
        if (!has(x, y)) continue;
        if (united_ - asked >= united_between_questions) {
          asked = united_;
          if (!go_on()) return Verdict::undecided;
        }
        const Mark here = mark();
        const bool can_be = identify(x, y);
        undo(here);
        if (!can_be) forbid(x, y);
      }
    }
  }
  done_.clear();
  narrowed_.clear();
  narrowed_.shrink_to_fit();
  return Verdict::consistent;
}

/// What could not be in a shorter trace cannot be in this.
void Folding::know(const Folding& before) {
  for (ArmIndex arm = 0; arm < before.across_.size(); ++arm) {
    for (std::size_t w = 0; w + 1 < before.words_; ++w)
      may_be_[arm * words_ + w] &= before.may_be_[arm * before.words_ + w];
    const std::size_t last = before.words_ - 1;
    const std::uint64_t later =
        before.across_.size() % 64 == 0 ? 0 : ~std::uint64_t{0} << (before.across_.size() % 64);
    may_be_[arm * words_ + last] &= before.may_be_[arm * before.words_ + last] | later;
  }
}

/// Two visits in a row: a travel from x to y.
bool Folding::join(ArmIndex x, ArmIndex y) {
  to_identify_.clear();
  changed_.clear();
  x = representative(x);
  y = representative(y);
  for (const auto& [from, to] : {std::pair(x, y), std::pair(y, x)}) {
    if (across_[from] == none)
      across_[from] = to;
    else
      to_identify_.emplace_back(across_[from], to);
  }
  changed_.push_back(table_.visit_of(x));
  return go_on_identifying();
}

/// Star on star, no two visits' arms that are so aligned are one.
void Folding::forbid(ArmIndex x, ArmIndex y) {
  for (ArmIndex step = 0; step < table_.star_size(table_.visit_of(x)); ++step) {
    const ArmIndex a = table_.clockwise(x, step);
    const ArmIndex b = table_.clockwise(y, step);
    may_be_[a * words_ + b / 64] &= ~(std::uint64_t{1} << (b % 64));
    may_be_[b * words_ + a / 64] &= ~(std::uint64_t{1} << (a % 64));
  }
}

bool Folding::identify(ArmIndex x, ArmIndex y) {
  to_identify_.clear();
  changed_.clear();
  to_identify_.emplace_back(x, y);
  if (!go_on_identifying()) return false;
  return std::ranges::none_of(
             changed_, [&](ArmIndex visit) { return settled_[representative_visit(visit)]; }) ||
         settled_places_agree();
}

bool Folding::contradicts(ArmIndex x, ArmIndex y) const {
  const ArmIndex one = table_.visit_of(x);
  const ArmIndex other = table_.visit_of(y);
  return one == other || (settled_[one] && settled_[other]) || !may_be_one(x, y);
}

bool Folding::go_on_identifying() {
  while (!to_identify_.empty()) {
    ArmIndex x = representative(to_identify_.back().first);
    ArmIndex y = representative(to_identify_.back().second);
    to_identify_.pop_back();
    if (x == y) continue;
    if (contradicts(x, y)) return false;
    // A look at what would follow at once costs less than to unite and undo.
    const ArmIndex arms = table_.star_size(table_.visit_of(x));
    for (ArmIndex step = 0; step < arms; ++step) {
      const ArmIndex a = across_[table_.clockwise(x, step)];
      const ArmIndex b = across_[table_.clockwise(y, step)];
      if (a == none || b == none) continue;
      const ArmIndex to_a = representative(a);
      const ArmIndex to_b = representative(b);
      if (to_a != to_b && contradicts(to_a, to_b)) return false;
    }
    const ArmIndex one = table_.visit_of(x);
    const ArmIndex other = table_.visit_of(y);
    const bool one_stays =
        settled_[one] || (!settled_[other] && visits_there_[one] >= visits_there_[other]);
    unite(one_stays ? x : y, one_stays ? y : x);
  }
  return differ_as_assumed() && std::ranges::all_of(changed_, [&](ArmIndex visit) {
           return paths_are_lines(representative_visit(visit));
         });
}

/// What may be one is asked of representatives, and forgets what two visits under them may not.
bool Folding::differ_as_assumed() const {
  return std::ranges::none_of(differ_, [&](const auto& visits) {
    return representative_visit(visits.first) == representative_visit(visits.second);
  });
}

/// The place of y becomes that of x.
void Folding::unite(ArmIndex x, ArmIndex y) {
  ++united_;
  const ArmIndex stays = table_.visit_of(x);
  const ArmIndex goes = table_.visit_of(y);
  const ArmIndex first = table_.first_arm(goes);
  const ArmIndex arms = table_.star_size(goes);
  const ArmIndex above = table_.clockwise(x, (arms - (y - first)) % arms);
  above_[goes] = above;
  visits_there_[stays] += visits_there_[goes];
  done_.push_back({Done::Kind::united, goes, stays});
  for (ArmIndex step = 0; step < arms; ++step) {
    const ArmIndex a = table_.clockwise(above, step);
    const ArmIndex b = first + step;
    std::uint64_t* const row = &may_be_[a * words_];
    const std::uint64_t* const other = &may_be_[b * words_];
    narrowed_.insert(narrowed_.end(), row, row + words_);
    done_.push_back({Done::Kind::narrowed, a, 0});
    for (std::size_t w = 0; w < words_; ++w) row[w] &= other[w];
    if (across_[b] == none) continue;
    if (across_[a] == none) {
      across_[a] = across_[b];
      done_.push_back({Done::Kind::joined, a, 0});
    } else {
      to_identify_.emplace_back(across_[a], across_[b]);
    }
  }
  changed_.push_back(stays);
}

bool Folding::settle(ArmIndex arm) {
  const ArmIndex visit = table_.visit_of(representative(arm));
  if (settled_[visit]) return false;
  settled_[visit] = true;
  settled_list_.push_back(visit);
  const ArmIndex first = table_.first_arm(visit);
  for (ArmIndex own = first; own < first + table_.star_size(visit); ++own)
    settled_arms_[own / 64] |= std::uint64_t{1} << (own % 64);
  done_.push_back({Done::Kind::settled, visit, 0});
  return settled_places_agree();
}

void Folding::undo(Mark mark) {
  if (done_.size() > mark) faces_are_numbered_ = false;
  while (done_.size() > mark) {
    const Done last = done_.back();
    done_.pop_back();
    switch (last.kind) {
      case Done::Kind::united:
        above_[last.arm] = none;
        visits_there_[last.other] -= visits_there_[last.arm];
        break;
      case Done::Kind::joined:
        across_[last.arm] = none;
        break;
      case Done::Kind::narrowed:
        std::copy(narrowed_.end() - static_cast<std::ptrdiff_t>(words_), narrowed_.end(),
                  may_be_.begin() + static_cast<std::ptrdiff_t>(last.arm * words_));
        narrowed_.resize(narrowed_.size() - words_);
        break;
      case Done::Kind::settled: {
        settled_[last.arm] = false;
        settled_list_.pop_back();
        const ArmIndex first = table_.first_arm(last.arm);
        for (ArmIndex own = first; own < first + table_.star_size(last.arm); ++own)
          settled_arms_[own / 64] &= ~(std::uint64_t{1} << (own % 64));
        break;
      }
    }
  }
}

std::uint32_t Folding::new_stamp() {
  if (++stamp_ == 0) {
    std::ranges::fill(seen_, 0);
    stamp_ = 1;
  }
  return stamp_;
}

/// No path through this place comes to a place twice.                              [BMK10, (8)]
bool Folding::paths_are_lines(ArmIndex visit) {
  const ArmIndex first = table_.first_arm(visit);
  for (ArmIndex arm = first; arm < first + table_.star_size(visit); ++arm)
    if (arm < table_.opposite(arm) && !is_line(arm)) return false;
  return true;
}

bool Folding::is_line(ArmIndex arm) {
  const std::uint32_t stamp = new_stamp();
  seen_[table_.first_arm(table_.visit_of(arm))] = stamp;
  for (ArmIndex on_path : {arm, table_.opposite(arm)})
    for (ArmIndex to = across(on_path); to != none; to = across(table_.opposite(to))) {
      std::uint32_t& seen = seen_[table_.first_arm(table_.visit_of(to))];
      if (seen == stamp) return false;
      seen = stamp;
    }
  return true;
}

/// What holds of places that differ: they and what joins them are a part of every map to come.
bool Folding::settled_places_agree() {
  for (const auto& [one, other] : same_) {
    const ArmIndex a = representative_visit(one);
    const ArmIndex b = representative_visit(other);
    if (a != b && settled_[a] && settled_[b]) return false;
  }
  return (!axioms_.planar || settled_places_are_planar()) &&
         (!axioms_.one_segment || settled_places_are_joined_once()) &&
         (!axioms_.one_crossing || settled_paths_cross_once());
}

/// V - E + F = 2 of each connected part.                                          [DESIGN §7]
bool Folding::settled_places_are_planar() {
  std::size_t ends = 0;
  std::uint32_t parts = 0;
  const std::uint32_t faced = new_stamp();
  faces_ = 0;
  for (const ArmIndex visit : settled_list_) {
    bool is_joined = false;
    const ArmIndex first = table_.first_arm(visit);
    const ArmIndex end = first + table_.star_size(visit);
    for (ArmIndex arm = first; arm < end; ++arm) {
      if (across_settled(arm) == none) continue;
      is_joined = true;
      ++ends;
      if (seen_[arm] == faced) continue;
      for (ArmIndex on_face = arm; seen_[on_face] != faced;) {
        seen_[on_face] = faced;
        on_face = table_.clockwise(across_settled(on_face), 1);
        for (; across_settled(on_face) == none; on_face = table_.clockwise(on_face, 1))
          face_[on_face] = faces_;
      }
      ++faces_;
    }
    if (is_joined) continue;
    std::fill(face_.begin() + first, face_.begin() + end, faces_);
    ++faces_;
  }
  const std::uint32_t reached = new_stamp();
  std::vector<ArmIndex>& to_do = changed_;  // of no use any more where this is asked
  to_do.clear();
  for (const ArmIndex root : settled_list_) {
    if (seen_[table_.first_arm(root)] == reached) continue;
    seen_[table_.first_arm(root)] = reached;
    to_do.assign(1, root);
    while (!to_do.empty()) {
      const ArmIndex first = table_.first_arm(to_do.back());
      const ArmIndex size = table_.star_size(to_do.back());
      part_[to_do.back()] = parts;
      to_do.pop_back();
      for (ArmIndex arm = first; arm < first + size; ++arm) {
        const ArmIndex to = across_settled(arm);
        if (to == none) continue;
        std::uint32_t& seen = seen_[table_.first_arm(table_.visit_of(to))];
        if (seen == reached) continue;
        seen = reached;
        to_do.push_back(table_.visit_of(to));
      }
    }
    ++parts;
  }
  faces_are_numbered_ = true;
  return settled_list_.size() + faces_ == ends / 2 + 2 * parts;
}

void Folding::number_faces() {
  if (axioms_.planar && !faces_are_numbered_) settled_places_are_planar();
}

bool Folding::may_stand_at(ArmIndex x, ArmIndex y) const {
  if (!axioms_.planar) return true;
  const ArmIndex first = table_.first_arm(table_.visit_of(x));
  for (ArmIndex arm = first; arm < first + table_.star_size(table_.visit_of(x)); ++arm) {
    const ArmIndex from = across_settled(arm);
    if (from == none) continue;
    const ArmIndex to = table_.clockwise(
        y, (arm + table_.star_size(table_.visit_of(x)) - x) % table_.star_size(table_.visit_of(x)));
    if (face_[from] != face_[to] && part_[table_.visit_of(from)] == part_[table_.visit_of(to)])
      return false;
  }
  return true;
}

bool Folding::may_stand_apart(ArmIndex x) const {
  if (!axioms_.planar) return true;
  const ArmIndex first = table_.first_arm(table_.visit_of(x));
  ArmIndex before = none;
  for (ArmIndex arm = first; arm < first + table_.star_size(table_.visit_of(x)); ++arm) {
    const ArmIndex from = across_settled(arm);
    if (from == none) continue;
    if (before != none && face_[from] != face_[before] &&
        part_[table_.visit_of(from)] == part_[table_.visit_of(before)])
      return false;
    before = from;
  }
  return true;
}

bool Folding::settled_places_are_joined_once() const {
  for (const ArmIndex visit : settled_list_) {
    std::vector<ArmIndex> neighbours;
    const ArmIndex first = table_.first_arm(visit);
    for (ArmIndex arm = first; arm < first + table_.star_size(visit); ++arm)
      if (const ArmIndex to = across_settled(arm); to != none)
        neighbours.push_back(table_.visit_of(to));
    std::ranges::sort(neighbours);
    if (std::ranges::adjacent_find(neighbours) != neighbours.end()) return false;
  }
  return true;
}

/// Two paths that meet at two settled places would do so in every map to come: they cannot turn out
/// to be one path, since no path comes to a place twice.
bool Folding::settled_paths_cross_once() {
  std::map<ArmIndex, std::vector<ArmIndex>> paths_at;  // ends of paths, by settled place
  for (const ArmIndex visit : settled_list_) {
    const ArmIndex first = table_.first_arm(visit);
    for (ArmIndex arm = first; arm < first + table_.star_size(visit); ++arm) {
      if (arm > table_.opposite(arm)) continue;
      ArmIndex end = arm;
      for (ArmIndex to = across(end); to != none; to = across(end)) end = table_.opposite(to);
      ArmIndex other_end = table_.opposite(arm);
      for (ArmIndex to = across(other_end); to != none; to = across(other_end))
        other_end = table_.opposite(to);
      paths_at[visit].push_back(std::min(end, other_end));
    }
  }
  std::map<std::pair<ArmIndex, ArmIndex>, int> meetings;
  for (auto& [visit, paths] : paths_at) {
    std::ranges::sort(paths);
    for (std::size_t i = 0; i < paths.size(); ++i)
      for (std::size_t j = i + 1; j < paths.size(); ++j)
        if (++meetings[{paths[i], paths[j]}] > 1) return false;
  }
  return true;
}

std::vector<ArmIndex> Folding::named() const {
  std::vector<ArmIndex> first_visit(table_.visits(), none);  // of representatives
  std::vector<ArmIndex> result;
  for (ArmIndex k = 0; k < table_.visits(); ++k) {
    const ArmIndex entered = representative(table_.entered(k));
    const ArmIndex visit = table_.visit_of(entered);
    if (first_visit[visit] == none) first_visit[visit] = k;
    const ArmIndex first = table_.first_arm(first_visit[visit]);
    const ArmIndex arms = table_.star_size(visit);
    const ArmIndex begins = representative(first) - table_.first_arm(visit);
    result.push_back(first + (entered - table_.first_arm(visit) + arms - begins) % arms);
  }
  return result;
}

std::size_t Folding::memory_bytes() const {
  return (may_be_.capacity() + narrowed_.capacity()) * sizeof(std::uint64_t) +
         done_.capacity() * sizeof(Done);
}

}  // namespace asterism
