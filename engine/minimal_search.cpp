#include "engine/minimal_search.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <utility>

#include "core/deadline.hpp"
#include "core/error.hpp"
#include "engine/arm_table.hpp"
#include "engine/folding.hpp"
#include "engine/preference.hpp"

namespace asterism {
namespace {

using Rank = Preference::Rank;
using Decision = SearchState::Decision;
using Branch = SearchState::Branch;
using Model = SearchState::Model;

constexpr Rank no_rank = UINT64_MAX;
/// A row of bits for every arm, of as many bits.
constexpr std::size_t max_visits = 4'000;
/// Between questions to the caller.
constexpr double slice_s = 0.02;
/// Of a search for some good map, before anything is proved.
constexpr std::uint64_t first_look_branchings = 300;
/// Before threads are worth their start.
constexpr std::uint64_t branchings_alone = 500;

/// What the workers share: the level in work, what was found, and branches to take over.
class Level {
 public:
  explicit Level(const Preference& preference) : preference_(preference) {}

  /// What is preferred less than this is left out.
  Rank limit() const { return limit_.load(std::memory_order_relaxed); }

  void refuse(Rank rank) {
    Rank refused = refused_.load(std::memory_order_relaxed);
    while (rank < refused &&
           !refused_.compare_exchange_weak(refused, rank, std::memory_order_relaxed)) {
    }
  }
  void found(Rank rank, Model model) {
    const std::lock_guard lock(mutex_);
    if (rank > limit()) return;
    if (models.empty() || rank < best) {
      models.clear();
      best = rank;
      limit_ = rank;
    }
    models.push_back(std::move(model));
  }

  void begin(Rank limit) {
    limit_ = limit;
    refused_ = no_rank;
    best = no_rank;
    models.clear();
    branches.clear();
  }
  Rank refused() const { return refused_; }
  void resume(const SearchState& state, Rank rank) {
    begin(state.limit);
    refused_ = state.refused;
    models = state.models;
    best = rank;
    branches.assign(state.branches.begin(), state.branches.end());
  }

  /// Whether a worker waits for something to do.
  bool is_hungry() const { return hungry_.load(std::memory_order_relaxed); }
  bool is_stopped() const { return stopped_.load(std::memory_order_relaxed); }

  void give(Branch branch) {
    const std::lock_guard lock(mutex_);
    branches.push_back(std::move(branch));
    hungry_ = waiting_ > branches.size();
    wake_.notify_one();
  }
  /// Waits until there is something to do, unless all wait, or it is to end.
  std::optional<Branch> take() {
    std::unique_lock lock(mutex_);
    ++waiting_;
    if (waiting_ == workers_ && branches.empty()) stop_locked();
    hungry_ = waiting_ > branches.size();
    wake_.wait(lock, [&] { return is_stopped() || !branches.empty(); });
    --waiting_;
    if (is_stopped()) return std::nullopt;
    Branch branch = std::move(branches.front());
    branches.pop_front();
    hungry_ = waiting_ > branches.size();
    return branch;
  }
  void start(unsigned workers) {
    workers_ = workers;
    waiting_ = 0;
    stopped_ = false;
    hungry_ = false;
  }
  void stop() {
    const std::lock_guard lock(mutex_);
    stop_locked();
  }

  std::vector<Model> models;  ///< of rank `best`
  Rank best = no_rank;
  std::deque<Branch> branches;

 private:
  void stop_locked() {
    stopped_ = true;
    wake_.notify_all();
  }

  const Preference& preference_;
  std::atomic<Rank> limit_ = 0;
  std::atomic<Rank> refused_ = no_rank;
  std::mutex mutex_;
  std::condition_variable wake_;
  unsigned workers_ = 1;
  unsigned waiting_ = 0;
  std::atomic<bool> stopped_ = false;
  std::atomic<bool> hungry_ = false;
};

/// One thread's search, depth first.
class Worker {
 public:
  Worker(const ArmTable& table, const Preference& preference, const Folding& begun, Level& level)
      : table_(table), preference_(preference), folding_(begun), level_(level) {
    flexible_.resize(folding_.words());
    for (ArmIndex visit = 0; visit < table.visits(); ++visit) {
      std::uint32_t ends = 0;
      const ArmIndex first = table.first_arm(visit);
      for (ArmIndex arm = first; arm < first + table.star_size(visit); ++arm)
        if (!table.has_gateway(arm)) ++ends;
      ends_.push_back(ends);
    }
  }

  bool is_idle() const { return frames_.empty(); }
  std::uint64_t branchings() const { return branchings_; }
  std::size_t memory_bytes() const { return folding_.memory_bytes(); }

  /// @return false if what was decided contradicts itself
  bool take(const Branch& branch) {
    clear();
    for (const Decision& decision : branch.decided)
      if (!decide(decision)) {
        clear();
        return false;
      }
    push(branch.next);
    return true;
  }
  void clear() {
    frames_.clear();
    folding_.undo(0);
    decided_.clear();
  }

  /// Tries what is next.
  /// @pre  it is not idle
  void advance() {
    Frame& top = frames_.back();
    folding_.undo(top.mark);
    decided_.resize(top.decided);
    if (top.tried == top.next.size()) return frames_.pop_back();
    const Decision next = top.next[top.tried++];
    ++branchings_;
    if (decide(next)) expand();
  }

  /// Parts with the branch nearest to the root, if it keeps another.
  std::optional<Branch> give() {
    std::size_t open = 0;
    for (const Frame& frame : frames_) open += frame.next.size() - frame.tried;
    if (open < 2) return std::nullopt;
    for (Frame& frame : frames_) {
      if (frame.tried == frame.next.size()) continue;
      Branch branch = branch_of(frame);
      if (branch.next.size() == open) branch.next.resize(branch.next.size() / 2);
      // What is kept comes last.
      const auto begin = frame.next.begin() + static_cast<std::ptrdiff_t>(frame.tried);
      frame.next.erase(begin, begin + static_cast<std::ptrdiff_t>(branch.next.size()));
      return branch;
    }
    return std::nullopt;
  }
  /// All that is yet to be tried.
  void add_branches(std::vector<Branch>& branches) const {
    for (auto frame = frames_.rbegin(); frame != frames_.rend(); ++frame)
      if (frame->tried < frame->next.size()) branches.push_back(branch_of(*frame));
  }

 private:
  struct Frame {
    std::vector<Decision> next;
    std::size_t tried;
    Folding::Mark mark;
    std::size_t decided;
  };

  Branch branch_of(const Frame& frame) const {
    return {{decided_.begin(), decided_.begin() + static_cast<std::ptrdiff_t>(frame.decided)},
            {frame.next.begin() + static_cast<std::ptrdiff_t>(frame.tried), frame.next.end()}};
  }
  void push(std::vector<Decision> next) {
    frames_.push_back({std::move(next), 0, folding_.mark(), decided_.size()});
  }

  bool decide(const Decision& decision) {
    decided_.push_back(decision);
    // Only a state to resume from may settle a place again.
    if (!decision.same &&
        folding_.is_settled(folding_.representative_visit(table_.visit_of(decision.arm))))
      return false;
    return decision.same ? folding_.identify(decision.arm, *decision.same)
                         : folding_.settle(decision.arm);
  }

  /// Looks where to branch next; decides what has one way only; ends where there is no map under
  /// the limit.
  void expand() {
    while (true) {
      if (!settle_what_differs()) return;
      const Extents least = least_extents();
      const Rank rank = preference_.rank(least);
      if (rank > level_.limit()) return level_.refuse(rank);
      if (unsettled_.empty()) return level_.found(rank, folding_.named());

      std::uint64_t fewest = UINT64_MAX;
      ArmIndex narrowest = 0;
      bool may_differ = false;
      for (const ArmIndex visit : unsettled_) {
        const Rank settled_rank = preference_.rank(least_if_settled(least, visit));
        const bool may_settle = settled_rank <= level_.limit();
        if (!may_settle) level_.refuse(settled_rank);
        const std::uint64_t visits = std::min<std::uint64_t>(folding_.visits_there(visit), 1023);
        std::uint64_t key = (may_settle ? 1024 : 0) - visits + 1024;
        folding_.for_each_settled(table_.first_arm(visit), [&](ArmIndex) {
          key += 1024;
          return key < fewest;
        });
        if (key >= fewest) continue;
        fewest = key;
        narrowest = visit;
        may_differ = may_settle;
      }
      std::vector<Decision> next;
      const ArmIndex arm = table_.first_arm(narrowest);
      folding_.for_each_settled(arm, [&](ArmIndex same) {
        next.push_back({arm, same});
        return true;
      });
      if (may_differ) next.push_back({arm, std::nullopt});
      if (next.size() > 1) return push(std::move(next));
      if (!decide(next.front())) return;
    }
  }

  /// Settles every place that may be one with none settled. Lists the others.
  bool settle_what_differs() {
    bool again = true;
    while (again) {
      again = false;
      unsettled_.clear();
      for (ArmIndex visit = 0; visit < table_.visits(); ++visit) {
        if (!folding_.represents(visit) || folding_.is_settled(visit)) continue;
        bool differs = true;
        folding_.for_each_settled(table_.first_arm(visit),
                                  [&](ArmIndex) { return differs = false; });
        if (differs) {
          if (!decide({table_.first_arm(visit), std::nullopt})) return false;
          again = true;
        } else {
          unsettled_.push_back(visit);
        }
      }
    }
    return true;
  }

  /// No map that comes of this folding has less.
  ///
  ///   |paths| = (ends + open) / 2      over all places                           [DESIGN §6]
  ///
  /// A gateway of a settled place stays open unless an arm of some unsettled place, one travelled
  /// by, turns out to be it: `shut` ones never do, and of the others there must be enough.
  Extents least_extents() {
    std::uint32_t ends = 0;
    std::uint32_t linked = 0;
    std::uint32_t travelled = 0;  // arms of unsettled places
    std::ranges::fill(flexible_, 0);
    for (const ArmIndex visit : unsettled_) {
      const ArmIndex first = table_.first_arm(visit);
      for (ArmIndex arm = first; arm < first + table_.star_size(visit); ++arm) {
        if (folding_.across(arm) == Folding::none) continue;
        ++travelled;
        flexible_[arm / 64] |= std::uint64_t{1} << (arm % 64);
      }
    }
    std::uint32_t open = 0;
    std::uint32_t shut = 0;
    for (const ArmIndex visit : folding_.settled()) {
      ends += ends_[visit];
      const ArmIndex first = table_.first_arm(visit);
      for (ArmIndex arm = first; arm < first + table_.star_size(visit); ++arm) {
        if (!table_.has_gateway(arm)) continue;
        if (const ArmIndex to = folding_.across(arm); to != Folding::none) {
          if (folding_.is_settled(table_.visit_of(to))) ++linked;
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
            .places = static_cast<std::uint32_t>(folding_.settled().size()),
            .segments = linked / 2};
  }
  /// ... if this place too differs from those settled.
  Extents least_if_settled(Extents least, ArmIndex visit) const {
    ++least.places;
    least.paths = (twice_paths_ + ends_[visit] + 1) / 2;
    return least;
  }

  const ArmTable& table_;
  const Preference& preference_;
  Folding folding_;
  Level& level_;
  std::vector<std::uint32_t> ends_;  ///< of a visit's star: arms without gateway
  std::vector<Frame> frames_;
  std::vector<Decision> decided_;
  std::vector<ArmIndex> unsettled_;
  std::vector<std::uint64_t> flexible_;  ///< arms travelled by, of unsettled places
  std::uint32_t twice_paths_ = 0;
  std::uint64_t branchings_ = 0;
};

/// Places no two of which can be one, many of them: settled without branching.
std::vector<Decision> different_places(const ArmTable& table, const Folding& folding) {
  std::vector<ArmIndex> visits;
  for (ArmIndex visit = 0; visit < table.visits(); ++visit)
    if (folding.represents(visit)) visits.push_back(visit);
  const std::size_t words = (visits.size() + 63) / 64;
  std::vector<std::vector<std::uint64_t>> differ(visits.size(),
                                                 std::vector<std::uint64_t>(words, 0));
  for (std::size_t i = 0; i < visits.size(); ++i)
    for (std::size_t j = 0; j < visits.size(); ++j) {
      bool may_be_one = i == j;
      const ArmIndex first = table.first_arm(visits[j]);
      for (ArmIndex arm = first; arm < first + table.star_size(visits[j]) && !may_be_one; ++arm)
        may_be_one = folding.may_be_one(table.first_arm(visits[i]), arm);
      if (!may_be_one) differ[i][j / 64] |= std::uint64_t{1} << (j % 64);
    }
  // Greedy, from each in turn; the one that leaves most to choose from comes next.
  constexpr std::size_t most_beginnings = 400;
  std::vector<std::size_t> most;
  for (std::size_t begin = 0; begin < std::min(visits.size(), most_beginnings); ++begin) {
    std::vector<std::size_t> chosen{begin};
    std::vector<std::uint64_t> left = differ[begin];
    while (true) {
      std::size_t best = visits.size();
      int best_leaves = -1;
      for (std::size_t i = 0; i < visits.size(); ++i) {
        if ((left[i / 64] >> (i % 64) & 1) == 0) continue;
        int leaves = 0;
        for (std::size_t w = 0; w < words; ++w) leaves += std::popcount(left[w] & differ[i][w]);
        if (leaves > best_leaves) best_leaves = leaves, best = i;
      }
      if (best == visits.size()) break;
      chosen.push_back(best);
      for (std::size_t w = 0; w < words; ++w) left[w] &= differ[best][w];
    }
    if (chosen.size() > most.size()) most = chosen;
  }
  std::vector<Decision> result;
  for (const std::size_t i : most) result.push_back({table.first_arm(visits[i]), std::nullopt});
  return result;
}

}  // namespace

class MinimalSearch::Searching {
 public:
  explicit Searching(Options given)
      : options(std::move(given)), preference(options.axioms.preference()), level(preference) {
    if (!options.axioms.is_shipped())
      throw std::invalid_argument("axioms other than the shipped ones need the solver");
    options.jobs = std::max(options.jobs, 1U);
  }
  Searching(const Searching&) = delete;

  void extend(std::span<const Visit> visits);
  Outcome run(const MinimalSearch& self, const std::function<bool(const MinimalSearch&)>& go_on);
  Bounds bounds() const;
  SearchState state() const;
  void resume(const SearchState& state);

  std::span<const Model> best_models() const {
    if (!level.models.empty()) return level.models;
    return incumbent ? std::span(&*incumbent, 1) : std::span<const Model>();
  }
  Extents extents_of_model(const Model& model) const {
    return extents_of(make_map(table.trace(), table.arrivals(model)));
  }
  bool explains(const Model& model) const;
  std::optional<Model> grown(const Model& model) const;

  Options options;
  Preference preference;
  ArmTable table;
  Level level;
  std::unique_ptr<Folding> folding;  ///< of the trace so far
  bool is_begun = false;             ///< the folding is
  bool is_level_begun = false;
  bool is_resumed = false;  ///< from branches that nobody has looked at
  bool is_complete = false;
  std::uint64_t at_least = 0;
  std::optional<Model> incumbent;
  Rank incumbent_rank = no_rank;
  std::vector<Worker> workers;
  std::uint64_t branchings_before = 0;  ///< by workers that are no more

 private:
  NativeEngine::Options engine_options() const {
    return NativeEngine::options(options.axioms, options.planar);
  }
  bool begin(const std::function<bool()>& go_on);
  void look_first(const Branch& root);
  bool next_level();
  void check_branches();
  void make_workers(std::size_t count);
  void forget_workers();
  bool search_slice();
  void work(Worker& worker, Deadline until, std::uint64_t most_branchings);
};

void MinimalSearch::Searching::extend(std::span<const Visit> visits) {
  if (visits.empty()) return;
  const std::vector<Model> known(best_models().begin(), best_models().end());
  const std::size_t before = table.visits();
  try {
    for (const Visit& visit : visits) table.append(visit);
  } catch (...) {
    table.keep_first(before);
    throw;
  }
  // A map of the longer trace has a map of the shorter in it; each travel may have joined two of
  // that one's paths.
  if (preference.extents().front() == "path")
    at_least -= std::min<std::uint64_t>(at_least, visits.size());
  const bool had_none = is_complete && known.empty() && before > 0;
  forget_workers();
  is_begun = false;
  is_level_begun = false;
  is_complete = had_none;
  incumbent.reset();
  incumbent_rank = no_rank;
  level.begin(0);
  constexpr std::size_t most_grown = 64;
  for (std::size_t i = 0; i < std::min(known.size(), most_grown); ++i) {
    auto model = grown(known[i]);
    if (!model) continue;
    const Rank rank = preference.rank(extents_of_model(*model));
    if (rank >= incumbent_rank) continue;
    incumbent = std::move(model);
    incumbent_rank = rank;
  }
}

/// The model, with the visits since it was found explained in the way preferred at each.
std::optional<Model> MinimalSearch::Searching::grown(const Model& model) const {
  NativeEngine engine(table, engine_options());
  engine.reset();
  Model result = model;
  for (std::size_t k = 0; k < table.visits(); ++k) {
    if (k == result.size()) {
      Rank best = no_rank;
      engine.for_each_child(k, [&](ArmIndex arm, auto step) {
        const Rank rank = preference.rank(engine.extents_after(k, arm, step));
        if (rank >= best) return;
        best = rank;
        result.resize(k);
        result.push_back(arm);
      });
      if (result.size() == k) return std::nullopt;
    }
    engine.enter(k, result[k], engine.step(k, result[k]));
  }
  return explains(result) ? std::optional(result) : std::nullopt;
}

/// Whether the native engine allows this, and all that is assumed holds.
bool MinimalSearch::Searching::explains(const Model& model) const {
  if (model.size() != table.visits()) return false;
  NativeEngine engine(table, engine_options());
  engine.reset();
  for (std::size_t k = 0; k < model.size(); ++k) {
    bool is_child = false;
    engine.for_each_child(k, [&](ArmIndex arm, auto) { is_child = is_child || arm == model[k]; });
    if (!is_child) return false;
    engine.enter(k, model[k], engine.step(k, model[k]));
  }
  return std::ranges::all_of(options.assumptions, [&](const Assumption& assumption) {
    const std::size_t one = assumption.one.index();
    const std::size_t other = assumption.other.index();
    return std::max(one, other) >= model.size() ||
           agrees(assumption, table.visit_of(model[one]), table.visit_of(model[other]));
  });
}

/// Folds the trace; what the shorter trace showed is known already.
bool MinimalSearch::Searching::begin(const std::function<bool()>& go_on) {
  if (table.visits() > max_visits)
    throw Error("trace: found " + std::to_string(table.visits()) + " visits; expected at most " +
                std::to_string(max_visits) + " to search for minimal models");
  auto next = std::make_unique<Folding>(table, engine_options());
  const Verdict verdict = next->begin(options.assumptions, folding.get(), go_on);
  if (verdict == Verdict::undecided) return false;
  folding = std::move(next);
  is_begun = true;
  is_complete = verdict == Verdict::inconsistent;
  return true;
}

void MinimalSearch::Searching::make_workers(std::size_t count) {
  while (workers.size() < count) workers.emplace_back(table, preference, *folding, level);
}

void MinimalSearch::Searching::forget_workers() {
  for (const Worker& worker : workers) branchings_before += worker.branchings();
  workers.clear();
}

/// Some map, quickly: something to show, and a limit for what is searched later.
void MinimalSearch::Searching::look_first(const Branch& root) {
  level.begin(incumbent ? incumbent_rank - 1 : no_rank - 1);
  make_workers(1);
  Worker& worker = workers.front();
  if (worker.take(root))
    for (std::uint64_t n = 0; n < first_look_branchings && !worker.is_idle(); ++n) worker.advance();
  worker.clear();
  if (level.models.empty()) return;
  incumbent = level.models.front();
  incumbent_rank = level.best;
}

bool MinimalSearch::Searching::next_level() {
  Branch root{different_places(table, *folding), {}};
  root.next.push_back(root.decided.back());
  root.decided.pop_back();
  std::uint64_t first = at_least;
  if (!is_level_begun) {
    look_first(root);
  } else {
    if (level.refused() == no_rank) return false;
    first = preference.first(level.refused());
  }
  at_least = first;
  level.begin(std::min(preference.highest(first), incumbent_rank));
  level.branches.push_back(std::move(root));
  is_level_begun = true;
  return true;
}

void MinimalSearch::Searching::work(Worker& worker, Deadline until, std::uint64_t most_branchings) {
  const std::uint64_t begin = worker.branchings();
  for (std::uint64_t n = 0; !level.is_stopped(); ++n) {
    if (worker.is_idle()) {
      const auto branch = level.take();
      if (!branch) return;
      if (!worker.take(*branch)) continue;
    }
    worker.advance();
    if (level.is_hungry())
      if (auto branch = worker.give()) level.give(std::move(*branch));
    if ((n % 4 == 0 && is_over(until)) || worker.branchings() - begin >= most_branchings)
      return level.stop();
  }
}

/// @return whether the level has been searched to its end
bool MinimalSearch::Searching::search_slice() {
  const Deadline until = deadline_in(slice_s);
  std::uint64_t branchings = branchings_before;
  for (const Worker& worker : workers) branchings += worker.branchings();
  const bool alone = options.jobs == 1 || branchings < branchings_alone;
  const std::size_t jobs = alone && workers.size() <= 1 ? 1 : options.jobs;
  make_workers(jobs);
  level.start(static_cast<unsigned>(jobs));
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 1; i < jobs; ++i)
      threads.emplace_back([&, i] { work(workers[i], until, UINT64_MAX); });
    work(workers[0], until, jobs < options.jobs ? branchings_alone : UINT64_MAX);
  }
  return level.branches.empty() &&
         std::ranges::all_of(workers, [](const Worker& worker) { return worker.is_idle(); });
}

/// @throws std::invalid_argument if one cannot be of this search
void MinimalSearch::Searching::check_branches() {
  make_workers(1);
  for (const Branch& branch : level.branches)
    if (!workers.front().take(branch))
      throw std::invalid_argument("a branch contradicts the trace");
  workers.front().clear();
  is_resumed = false;
}

MinimalSearch::Outcome MinimalSearch::Searching::run(
    const MinimalSearch& self, const std::function<bool(const MinimalSearch&)>& go_on) {
  const auto goes_on = [&] { return !go_on || go_on(self); };
  if (table.visits() == 0) is_complete = true;
  if (is_complete) return Outcome::complete;
  if (!is_begun && !begin(goes_on)) return Outcome::stopped;
  if (is_complete) return Outcome::complete;
  if (!is_level_begun) next_level();
  if (is_resumed) check_branches();
  while (true) {
    if (!goes_on()) return Outcome::stopped;
    if (!search_slice()) continue;
    is_complete = !level.models.empty() || !next_level();
    if (!is_complete) continue;
    if (level.models.empty()) incumbent.reset();
    return Outcome::complete;
  }
}

MinimalSearch::Bounds MinimalSearch::Searching::bounds() const {
  Bounds bounds{.at_least = at_least, .best = {}, .count = best_models().size()};
  if (bounds.count > 0) bounds.best = extents_of_model(best_models().front());
  return bounds;
}

SearchState MinimalSearch::Searching::state() const {
  SearchState state;
  state.is_level_begun = is_level_begun;
  state.limit = level.limit();
  state.refused = level.refused();
  state.incumbent = incumbent;
  state.models = level.models;
  for (const Worker& worker : workers) worker.add_branches(state.branches);
  state.branches.insert(state.branches.end(), level.branches.begin(), level.branches.end());
  return state;
}

void MinimalSearch::Searching::resume(const SearchState& state) {
  const auto require = [](bool holds, const char* what) {
    if (!holds) throw std::invalid_argument(what);
  };
  forget_workers();
  is_complete = false;
  for (const Model& model : state.models) require(explains(model), "a model is none of this trace");
  if (state.incumbent) require(explains(*state.incumbent), "the map found is none of this trace");
  const auto rank_of = [&](const Model& model) { return preference.rank(extents_of_model(model)); };
  const Rank rank = state.models.empty() ? no_rank : rank_of(state.models.front());
  for (const Model& model : state.models)
    require(rank_of(model) == rank && rank == state.limit, "a model is not among the best");
  for (const Branch& branch : state.branches)
    for (const auto* decisions : {&branch.decided, &branch.next})
      for (const Decision& decision : *decisions)
        require(decision.arm < table.size() && decision.same.value_or(0) < table.size(),
                "a branch names an arm that the trace does not have");
  incumbent = state.incumbent;
  incumbent_rank = incumbent ? rank_of(*incumbent) : no_rank;
  is_level_begun = state.is_level_begun;
  if (!is_level_begun) return;
  level.resume(state, rank);
  is_resumed = true;
  at_least = preference.first(state.limit);
}

MinimalSearch::MinimalSearch(Options options)
    : searching_(std::make_unique<Searching>(std::move(options))) {}
MinimalSearch::~MinimalSearch() = default;
MinimalSearch::MinimalSearch(MinimalSearch&&) noexcept = default;
MinimalSearch& MinimalSearch::operator=(MinimalSearch&&) noexcept = default;

void MinimalSearch::extend(std::span<const Visit> visits) { searching_->extend(visits); }

void MinimalSearch::leave(std::size_t left_by) {
  if (searching_->table.visits() == 0) throw std::invalid_argument("there is no visit to leave");
  searching_->table.leave(left_by);
}

MinimalSearch::Outcome MinimalSearch::run(const std::function<bool(const MinimalSearch&)>& go_on) {
  return searching_->run(*this, go_on);
}

MinimalSearch::Bounds MinimalSearch::bounds() const { return searching_->bounds(); }

bool MinimalSearch::is_complete() const { return searching_->is_complete; }

void MinimalSearch::for_each(const std::function<void(std::span<const Arrival>)>& f,
                             std::size_t most) const {
  const ArmTable& table = searching_->table;
  const std::span<const Model> models = searching_->best_models();
  std::vector<std::uint32_t> order(models.size());
  std::iota(order.begin(), order.end(), 0U);
  // By (visits, entered): places are numbered by first visit, which an arm tells.    [DESIGN §9]
  const auto is_before = [&](std::uint32_t a, std::uint32_t b) {
    const auto& [one, other] = std::mismatch(
        models[a].begin(), models[a].end(), models[b].begin(),
        [&](ArmIndex x, ArmIndex y) { return table.visit_of(x) == table.visit_of(y); });
    return one == models[a].end() ? models[a] < models[b] : *one < *other;
  };
  if (most < order.size()) {
    std::ranges::partial_sort(order, order.begin() + static_cast<std::ptrdiff_t>(most), is_before);
    order.resize(most);
  } else {
    std::ranges::sort(order, is_before);
  }
  for (const std::uint32_t i : order) f(table.arrivals(models[i]));
}

std::vector<std::vector<Arrival>> MinimalSearch::models() const {
  std::vector<std::vector<Arrival>> models;
  for_each(
      [&](std::span<const Arrival> model) { models.emplace_back(model.begin(), model.end()); });
  return models;
}

std::size_t MinimalSearch::memory_bytes() const {
  std::size_t bytes = searching_->folding ? searching_->folding->memory_bytes() : 0;
  for (const Worker& worker : searching_->workers) bytes += worker.memory_bytes();
  return bytes + searching_->best_models().size() *
                     (sizeof(Model) + searching_->table.visits() * sizeof(ArmIndex));
}

std::uint64_t MinimalSearch::branchings() const {
  std::uint64_t sum = searching_->branchings_before;
  for (const Worker& worker : searching_->workers) sum += worker.branchings();
  return sum;
}

const Trace& MinimalSearch::trace() const { return searching_->table.trace(); }

const MinimalSearch::Options& MinimalSearch::options() const { return searching_->options; }

SearchState MinimalSearch::state() const { return searching_->state(); }

void MinimalSearch::resume(const SearchState& state) { searching_->resume(state); }

}  // namespace asterism
