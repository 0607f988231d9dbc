#include "engine/minimal/minimal_search.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "core/error.hpp"
#include "core/stop.hpp"
#include "engine/arm_table.hpp"
#include "engine/minimal/folding.hpp"
#include "engine/minimal/search_level.hpp"
#include "engine/minimal/search_threads.hpp"
#include "engine/minimal/search_worker.hpp"
#include "engine/preference.hpp"

namespace asterism {
namespace {

using Rank = Preference::Rank;
using Decision = SearchState::Decision;
using Branch = SearchState::Branch;
using Model = SearchState::Model;

/// For some map, where the first slice did not end the search.
constexpr std::uint64_t random_walks = 20;
constexpr std::uint64_t random_walk_branchings = 400;

/// The order of reports (minimal_models.hpp): places are numbered by first visit, which an arm
/// tells.
bool is_before(const Model& a, const Model& b, const ArmTable& table) {
  const auto& [one, other] = std::mismatch(a.begin(), a.end(), b.begin(), [&](ArmId x, ArmId y) {
    return table.visit_of(x) == table.visit_of(y);
  });
  return one == a.end() ? a < b : *one < *other;
}

const AxiomSet& shipped(const AxiomSet& axioms) {
  if (!axioms.is_shipped())
    throw std::invalid_argument("axioms or extents other than the shipped ones need the solver");
  return axioms;
}

}  // namespace

class MinimalSearch::Searching {
 public:
  explicit Searching(Options given)
      : options(std::move(given)), preference(shipped(options.theory.axioms).preference()) {
    options.jobs = std::max(options.jobs, 1U);
  }
  Searching(const Searching&) = delete;

  void extend(std::span<const Visit> visits);
  Outcome run(const Stop& stop);
  Bounds bounds() const;
  std::size_t memory_bytes() const;
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
  SearchLevel level;
  std::unique_ptr<Folding> folding;  ///< of the trace so far
  Branch root;                       ///< where each level begins
  bool is_begun = false;             ///< the folding and the root are
  bool is_level_begun = false;
  bool is_resumed = false;  ///< from branches that nobody has looked at
  bool has_looked_around = false;
  bool is_complete = false;
  std::uint64_t at_least = 0;
  std::optional<Model> incumbent;
  Rank incumbent_rank = no_rank;
  SearchThreads threads{table, preference, level};

 private:
  std::uint64_t bytes_to_come() const;
  bool begin(const Stop& stop);
  void look_around(const Stop& stop);
  bool next_level();
  void check_branches();
};

void MinimalSearch::Searching::extend(std::span<const Visit> visits) {
  if (visits.empty()) return;
  constexpr std::size_t most_grown = 64;
  const auto best = best_models().first(std::min(best_models().size(), most_grown));
  const std::vector<Model> known(best.begin(), best.end());
  const std::size_t before = table.visits();
  try {
    for (const Visit& visit : visits) table.append(visit);
  } catch (...) {
    table.keep_first(before);
    throw;
  }
  // A map of the longer trace has a map of the shorter in it; each travel may have joined two of
  // that one's paths.
  if (preference.extents().front() == Extent::path)
    at_least -= std::min<std::uint64_t>(at_least, visits.size());
  const bool had_none = is_complete && known.empty() && before > 0;
  threads.forget();
  is_begun = false;
  is_level_begun = false;
  has_looked_around = false;
  is_resumed = false;
  is_complete = had_none;
  incumbent.reset();
  incumbent_rank = no_rank;
  level.begin(0);
  for (const Model& shorter : known) {
    auto model = grown(shorter);
    if (!model) continue;
    const Rank rank = preference.rank(extents_of_model(*model));
    if (rank >= incumbent_rank) continue;
    incumbent = std::move(model);
    incumbent_rank = rank;
  }
}

/// The model, with the visits since it was found explained in the way preferred at each.
std::optional<Model> MinimalSearch::Searching::grown(const Model& model) const {
  NativeEngine engine(table, options.theory);
  engine.reset();
  Model result = model;
  for (const VisitId k : table.all_visits()) {
    if (k.index() == result.size()) {
      Rank best = no_rank;
      engine.for_each_child(k, [&](ArmId arm, auto step) {
        const Rank rank = preference.rank(engine.extents_after(k, arm, step));
        if (rank >= best) return;
        best = rank;
        result.resize(k.index(), no_arm);
        result.push_back(arm);
      });
      if (result.size() == k.index()) return std::nullopt;
    }
    const ArmId arm = result[k.index()];
    engine.enter(k, arm, engine.step(k, arm));
  }
  return explains(result) ? std::optional(result) : std::nullopt;
}

/// Whether the native engine allows this, and all that is assumed holds.
bool MinimalSearch::Searching::explains(const Model& model) const {
  if (model.size() != table.visits()) return false;
  NativeEngine engine(table, options.theory);
  engine.reset();
  for (const VisitId k : table.all_visits()) {
    const ArmId entered = model[k.index()];
    bool is_child = false;
    engine.for_each_child(k, [&](ArmId arm, auto) { is_child = is_child || arm == entered; });
    if (!is_child) return false;
    engine.enter(k, entered, engine.step(k, entered));
  }
  return std::ranges::all_of(options.theory.assumptions, [&](const Assumption& assumption) {
    const std::size_t one = assumption.one.index();
    const std::size_t other = assumption.other.index();
    return std::max(one, other) >= model.size() ||
           agrees(assumption, table.visit_of(model[one]), table.visit_of(model[other]));
  });
}

/// What it takes before it finds anything: a bit for every two arms of the trace, for each worker,
/// two a thread, for the folding they begin with, and while it looks around. The list of the maps
/// found is copied as it grows.
std::uint64_t MinimalSearch::Searching::bytes_to_come() const {
  const std::uint64_t at_begin = (2 * options.jobs + 2) * table.size() * table.size() / 8;
  const std::uint64_t held = memory_bytes();
  return (at_begin > held ? at_begin - held : 0) + best_models().size() * sizeof(Model);
}

std::size_t MinimalSearch::Searching::memory_bytes() const {
  return (folding ? folding->memory_bytes() : 0) + threads.memory_bytes() +
         best_models().size() * (sizeof(Model) + table.visits() * sizeof(ArmId));
}

/// Folds the trace; what the shorter trace showed is known already.
bool MinimalSearch::Searching::begin(const Stop& stop) {
  if (table.visits() > max_visits)
    throw Error("trace: found " + std::to_string(table.visits()) + " visits; expected at most " +
                std::to_string(max_visits) + " to search for minimal models");
  auto next = std::make_unique<Folding>(table, NativeEngine::rules_of(options.theory));
  const Verdict verdict = next->begin(options.theory.assumptions, folding.get(), stop);
  if (verdict == Verdict::undecided) return false;
  folding = std::move(next);
  is_begun = true;
  is_complete = verdict == Verdict::inconsistent;
  if (!is_complete) root = first_branch(table, *folding);
  return true;
}

/// Some map: to be shown, and to limit what is searched. Worth it where the search takes long.
///
/// Where the narrowest place is decided first, a walk at random comes upon better maps; from the
/// first visit outwards, it comes upon planar ones at all.
void MinimalSearch::Searching::look_around(const Stop& stop) {
  has_looked_around = true;
  SearchLevel around;
  around.begin(std::min(incumbent_rank, level.best) - 1);
  SearchWorker worker(table, preference, *folding, around);
  for (std::uint64_t walk = 0; walk < random_walks && !stop.is_due(); ++walk) {
    const bool from_first_visit = walk % 2 == 1;
    const Deadline until = deadline_in(slice_s);
    worker.wander(walk, from_first_visit);
    worker.take(from_first_visit ? Branch{{}, {{ArmId(0), std::nullopt}}} : root);
    for (std::uint64_t n = 0; n < random_walk_branchings && !worker.is_idle(); ++n) {
      worker.advance();
      if (n % 4 == 0 && is_over(until)) break;
    }
  }
  // No two places one: rarely good, always a map, unless it is assumed that some are.
  if (around.models.empty() && !incumbent) worker.stand_apart();
  if (around.models.empty()) return;
  incumbent = around.models.front();
  incumbent_rank = around.best;
  if (preference.first(incumbent_rank) == at_least) level.lower(incumbent_rank);
}

bool MinimalSearch::Searching::next_level() {
  if (is_level_begun) {
    if (level.refused() == no_rank) return false;
    at_least = preference.first(level.refused());
  }
  level.begin(std::min(preference.highest(at_least), incumbent_rank));
  level.branches.push_back(root);
  is_level_begun = true;
  return true;
}

/// A search that was extended otherwise knows more of some visits, less of others. Where what was
/// decided there contradicts what is known here, the level is begun again.
void MinimalSearch::Searching::check_branches() {
  is_resumed = false;
  if (threads.hold(level.branches, *folding)) return;
  if (!level.models.empty()) {
    incumbent = level.models.front();
    incumbent_rank = level.best;
  }
  is_level_begun = false;
  next_level();
}

MinimalSearch::Outcome MinimalSearch::Searching::run(const Stop& stop) {
  if (table.visits() == 0) is_complete = true;
  if (is_complete) return Outcome::complete;
  const auto is_due = [&] { return stop.is_due({.maps = best_models().size()}, bytes_to_come()); };
  if (!is_begun && (is_due() || !begin(stop))) return Outcome::stopped;
  if (is_complete) return Outcome::complete;
  if (!is_level_begun) next_level();
  if (is_resumed) check_branches();
  while (true) {
    if (is_due()) return Outcome::stopped;
    if (!threads.work(*folding, options.jobs)) {
      if (!has_looked_around && level.is_due()) look_around(stop);
      continue;
    }
    is_complete = !level.models.empty() || !next_level();
    if (!is_complete) continue;
    if (level.models.empty() && incumbent)
      throw std::invalid_argument("no map is left, though one was found");
    // Threads find them in any order; they may differ in extents that nothing minimises.
    std::ranges::sort(level.models,
                      [&](const Model& a, const Model& b) { return is_before(a, b, table); });
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
  threads.add_branches(state.branches);
  state.branches.insert(state.branches.end(), level.branches.begin(), level.branches.end());
  return state;
}

void MinimalSearch::Searching::resume(const SearchState& state) {
  const auto require = [](bool holds, const char* what) {
    if (!holds) throw std::invalid_argument(what);
  };
  for (const Model& model : state.models) require(explains(model), "a model is none of this trace");
  if (state.incumbent) require(explains(*state.incumbent), "the map found is none of this trace");
  const auto rank_of = [&](const Model& model) { return preference.rank(extents_of_model(model)); };
  const Rank rank = state.models.empty() ? no_rank : rank_of(state.models.front());
  for (const Model& model : state.models)
    require(rank_of(model) == rank && rank == state.limit, "a model is not among the best");
  require(!state.is_level_begun || preference.first(state.limit) <= table.size(),
          "more is allowed than a map can have");
  require(!state.is_level_begun || !state.incumbent || state.limit <= rank_of(*state.incumbent),
          "more is allowed than the map found has");
  const ArmId end(table.size());
  for (const Branch& branch : state.branches)
    for (const auto* decisions : {&branch.decided, &branch.next})
      for (const Decision& decision : *decisions)
        require(decision.arm < end && decision.same.value_or(ArmId(0)) < end,
                "a branch names an arm that the trace does not have");
  threads.forget();
  is_complete = false;
  is_resumed = state.is_level_begun;
  has_looked_around = false;
  incumbent = state.incumbent;
  incumbent_rank = incumbent ? rank_of(*incumbent) : no_rank;
  is_level_begun = state.is_level_begun;
  if (!is_level_begun) return level.begin(0);
  level.resume(state, rank);
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

MinimalSearch::Outcome MinimalSearch::run(const Stop& stop) { return searching_->run(stop); }

MinimalSearch::Bounds MinimalSearch::bounds() const { return searching_->bounds(); }

bool MinimalSearch::is_complete() const { return searching_->is_complete; }

void MinimalSearch::for_each_while(const std::function<bool(std::span<const Arrival>)>& f,
                                   std::size_t most) const {
  const ArmTable& table = searching_->table;
  const std::span<const Model> models = searching_->best_models();
  std::vector<std::uint32_t> order(models.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto first = std::span(order).first(std::min(most, order.size()));
  if (!is_complete())
    std::partial_sort(order.begin(), order.begin() + std::ssize(first), order.end(),
                      [&](auto a, auto b) { return is_before(models[a], models[b], table); });
  for (const std::uint32_t i : first)
    if (!f(table.arrivals(models[i]))) return;
}

std::vector<std::vector<Arrival>> MinimalSearch::models() const {
  std::vector<std::vector<Arrival>> models;
  for_each_while([&](std::span<const Arrival> model) {
    models.emplace_back(model.begin(), model.end());
    return true;
  });
  return models;
}

std::size_t MinimalSearch::memory_bytes() const { return searching_->memory_bytes(); }

std::uint64_t MinimalSearch::branchings() const { return searching_->threads.branchings(); }

const Trace& MinimalSearch::trace() const { return searching_->table.trace(); }

const MinimalSearch::Options& MinimalSearch::options() const { return searching_->options; }

SearchState MinimalSearch::state() const { return searching_->state(); }

void MinimalSearch::resume(const SearchState& state) { searching_->resume(state); }

}  // namespace asterism
