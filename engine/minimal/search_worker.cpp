#include "engine/minimal/search_worker.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "engine/bits.hpp"

namespace asterism {
namespace {

template <class T>
void keep_first(std::vector<T>& list, std::size_t size) {
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(size), list.end());
}

}  // namespace

SearchWorker::SearchWorker(const ArmTable& table, const Preference& preference,
                           const Folding& begun, SearchLevel& level)
    : table_(table), preference_(preference), folding_(begun), level_(level) {
  flexible_.resize(folding_.arms().words());
  for (const VisitId visit : table.all_visits())
    ends_.push_back(table.star_size(visit) -
                    static_cast<std::uint32_t>(table.gateways(visit).size()));
}

bool SearchWorker::take(const SearchState::Branch& branch) {
  clear();
  for (const Decision& decision : branch.decided)
    if (!decide(decision)) {
      clear();
      return false;
    }
  push(branch.next);
  return true;
}

void SearchWorker::clear() {
  frames_.clear();
  folding_.undo({});
  decided_.clear();
}

void SearchWorker::advance() {
  Frame& top = frames_.back();
  folding_.undo(top.mark);
  keep_first(decided_, top.decided);
  if (top.tried == top.next.size()) return frames_.pop_back();
  const Decision next = top.next[top.tried++];
  ++branchings_;
  if (decide(next)) expand();
}

void SearchWorker::stand_apart() {
  clear();
  for (const VisitId visit : table_.all_visits())
    if (folding_.arms().represents(visit) && !decide({table_.first_arm(visit), std::nullopt}))
      return;
  unsettled_.clear();
  level_.found(preference_.rank(least_extents()), folding_.named());
}

void SearchWorker::wander(std::uint64_t seed, bool from_settled) {
  wandering_.emplace(seed);
  wanders_from_settled_ = from_settled;
}

std::optional<SearchState::Branch> SearchWorker::give() {
  std::size_t open = 0;
  for (const Frame& frame : frames_) open += frame.next.size() - frame.tried;
  if (open < 2) return std::nullopt;
  for (Frame& frame : frames_) {
    if (frame.tried == frame.next.size()) continue;
    SearchState::Branch branch = branch_of(frame);
    if (branch.next.size() == open) keep_first(branch.next, branch.next.size() / 2);
    // What is kept comes last.
    const auto begin = frame.next.begin() + static_cast<std::ptrdiff_t>(frame.tried);
    frame.next.erase(begin, begin + static_cast<std::ptrdiff_t>(branch.next.size()));
    return branch;
  }
  return std::nullopt;
}

void SearchWorker::add_branches(std::vector<SearchState::Branch>& branches) const {
  for (auto frame = frames_.rbegin(); frame != frames_.rend(); ++frame)
    if (frame->tried < frame->next.size()) branches.push_back(branch_of(*frame));
}

SearchState::Branch SearchWorker::branch_of(const Frame& frame) const {
  return {{decided_.begin(), decided_.begin() + static_cast<std::ptrdiff_t>(frame.decided)},
          {frame.next.begin() + static_cast<std::ptrdiff_t>(frame.tried), frame.next.end()}};
}

void SearchWorker::push(std::vector<Decision> next) {
  frames_.push_back({std::move(next), 0, folding_.mark(), decided_.size()});
}

bool SearchWorker::decide(const Decision& decision) {
  decided_.push_back(decision);
  return decision.same ? folding_.identify(decision.arm, *decision.same)
                       : folding_.settle(decision.arm);
}

/// Looks where to branch next; decides what has one way only; ends where there is no map under
/// the limit.
void SearchWorker::expand() {
  while (true) {
    if (!settle_what_differs()) return;
    folding_.number_faces();
    const Extents least = least_extents();
    const Preference::Rank rank = preference_.rank(least);
    if (rank > level_.limit()) return level_.refuse(rank);
    if (unsettled_.empty()) return level_.found(rank, folding_.named());

    std::uint64_t fewest = UINT64_MAX;
    VisitId narrowest(0);
    bool may_differ = false;
    for (const VisitId visit : unsettled_) {
      const Preference::Rank settled_rank = preference_.rank(least_if_settled(least, visit));
      const bool may_stand_apart = folding_.may_stand_apart(table_.first_arm(visit));
      const bool may_settle = may_stand_apart && settled_rank <= level_.limit();
      if (may_stand_apart && !may_settle) level_.refuse(settled_rank);
      const std::uint64_t visits =
          std::min<std::uint64_t>(folding_.arms().visits_there(visit), 1023);
      std::uint64_t key = (may_settle ? 1024 : 0) - visits + 1024;
      if (wanders_from_settled_ && !hangs_on_settled(visit)) key += std::uint64_t{1} << 32;
      folding_.for_each_settled(table_.first_arm(visit), [&](ArmId same) {
        if (folding_.may_stand_at(table_.first_arm(visit), same)) key += 1024;
        return key < fewest;
      });
      if (key >= fewest) continue;
      fewest = key;
      narrowest = visit;
      may_differ = may_settle;
    }
    std::vector<Decision> next;
    const ArmId arm = table_.first_arm(narrowest);
    folding_.for_each_settled(arm, [&](ArmId same) {
      if (folding_.may_stand_at(arm, same)) next.push_back({arm, same});
      return true;
    });
    if (wandering_) shuffle(next);
    if (may_differ) next.push_back({arm, std::nullopt});
    if (next.empty()) return;
    // A long row of places decided without a choice is broken off where time is up.
    if (next.size() > 1 || level_.is_due()) return push(std::move(next));
    if (!decide(next.front())) return;
  }
}

bool SearchWorker::hangs_on_settled(VisitId visit) const {
  for (const ArmId arm : table_.arms(visit))
    if (folding_.settled().across(folding_.arms(), arm)) return true;
  return false;
}

void SearchWorker::shuffle(std::vector<Decision>& next) {
  for (std::size_t i = next.size(); i > 1; --i) std::swap(next[i - 1], next[below(i, *wandering_)]);
}

/// Settles every place that may be one with none settled. Lists the others: they may be one with
/// more places then, never with fewer, so once is enough.
bool SearchWorker::settle_what_differs() {
  unsettled_.clear();
  for (const VisitId visit : table_.all_visits()) {
    if (!folding_.arms().represents(visit) || folding_.settled().contains(visit)) continue;
    bool differs = true;
    folding_.for_each_settled(table_.first_arm(visit), [&](ArmId) { return differs = false; });
    if (!differs)
      unsettled_.push_back(visit);
    else if (!decide({table_.first_arm(visit), std::nullopt}))
      return false;
  }
  return true;
}

/// No map that comes of this folding has less.
///
///   |paths| = (ends + open) / 2      over all places                           [theory §6]
///
/// A gateway of a settled place stays open unless an arm of some unsettled place, one travelled
/// by, turns out to be it: `shut` ones never do, and of the others there must be enough.
Extents SearchWorker::least_extents() {
  std::uint32_t ends = 0;
  std::uint32_t linked = 0;
  std::uint32_t travelled = 0;  // arms of unsettled places
  std::ranges::fill(flexible_, 0);
  for (const VisitId visit : unsettled_) {
    for (const ArmId arm : table_.arms(visit)) {
      if (!folding_.arms().across(arm)) continue;
      ++travelled;
      flexible_[word_of(arm)] |= bit_of(arm);
    }
  }
  std::uint32_t open = 0;
  std::uint32_t shut = 0;
  for (const VisitId visit : folding_.settled().visits()) {
    ends += ends_[visit];
    for (const ArmId arm : table_.arms(visit)) {
      if (!table_.has_gateway(arm)) continue;
      if (const auto to = folding_.arms().across(arm)) {
        if (folding_.settled().contains(table_.visit_of(*to))) ++linked;
      } else if (folding_.may_be_any(arm, flexible_)) {
        ++open;
      } else {
        ++shut;
      }
    }
  }
  const std::uint32_t stay_open = shut + (open > travelled ? open - travelled : 0);
  twice_paths_ = ends + stay_open;
  return {.paths = (twice_paths_ + 1) / 2,
          .places = static_cast<std::uint32_t>(folding_.settled().visits().size()),
          .segments = linked / 2};
}

/// The least extents if this visit's place, too, differs from those settled.
Extents SearchWorker::least_if_settled(Extents least, VisitId visit) const {
  ++least.places;
  least.paths = (twice_paths_ + ends_[visit] + 1) / 2;
  return least;
}

SearchState::Branch first_branch(const ArmTable& table, const Folding& folding) {
  std::vector<VisitId> visits;
  for (const VisitId visit : table.all_visits())
    if (folding.arms().represents(visit)) visits.push_back(visit);
  const std::size_t words = (visits.size() + 63) / 64;
  std::vector<std::vector<std::uint64_t>> differ(visits.size(),
                                                 std::vector<std::uint64_t>(words, 0));
  for (std::size_t i = 0; i < visits.size(); ++i)
    for (std::size_t j = 0; j < visits.size(); ++j) {
      bool may_be_one = i == j;
      for (const ArmId arm : table.arms(visits[j]))
        may_be_one = may_be_one || folding.arms().may_be_one(table.first_arm(visits[i]), arm);
      if (!may_be_one) differ[i][j / 64] |= std::uint64_t{1} << (j % 64);
    }
  // Greedy, from each in turn, while that is quick; what leaves most to choose from comes next.
  constexpr std::size_t quick = 20'000'000;
  std::size_t steps = 0;
  std::vector<std::size_t> most;
  for (std::size_t begin = 0; begin < visits.size() && steps < quick; ++begin) {
    std::vector<std::size_t> chosen{begin};
    std::vector<std::uint64_t> left = differ[begin];
    while (true) {
      std::size_t best = visits.size();
      int best_leaves = -1;
      for (std::size_t i = 0; i < visits.size(); ++i) {
        if ((left[i / 64] >> (i % 64) & 1) == 0) continue;
        int leaves = 0;
        for (std::size_t w = 0; w < words; ++w) leaves += std::popcount(left[w] & differ[i][w]);
        if (leaves > best_leaves) {
          best_leaves = leaves;
          best = i;
        }
        steps += words;
        if (steps > quick) break;
      }
      if (best == visits.size()) break;
      chosen.push_back(best);
      for (std::size_t w = 0; w < words; ++w) left[w] &= differ[best][w];
    }
    if (chosen.size() > most.size()) most = chosen;
  }
  SearchState::Branch branch;
  for (const std::size_t i : most) branch.decided.push_back({table.first_arm(visits[i]), {}});
  branch.next.push_back(branch.decided.back());
  branch.decided.pop_back();
  return branch;
}

}  // namespace asterism
