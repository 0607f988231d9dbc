#include "engine/map_tree.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>

#include "engine/arm_table.hpp"
#include "engine/assuming.hpp"
#include "engine/native.hpp"
#include "engine/preference.hpp"
#include "engine/preorder.hpp"
#include "engine/solver.hpp"

namespace asterism {
namespace {

using Engine = std::variant<NativeEngine, SolverEngine, BothEngines>;

NativeEngine native_engine(const MapTree::Options& options, const ArmTable& table) {
  return NativeEngine(table, NativeEngine::options(options.axioms, options.planar));
}

Engine make_engine(const MapTree::Options& options, const ArmTable& table) {
  const bool is_shipped = options.axioms.is_shipped();
  if (options.check != Check::solver && !is_shipped)
    throw std::invalid_argument("axioms other than the shipped ones need the solver");
  NativeEngine native = native_engine(options, table);
  if (options.check == Check::native) return native;
  SolverEngine solver(table, options.axioms, options.planar, options.solver_timeout_ms);
  if (options.check == Check::solver) return solver;
  return BothEngines(std::move(native), std::move(solver), table);
}

template <class E>
constexpr bool asks_no_solver =
    std::is_same_v<E, NativeEngine> || std::is_same_v<E, Assuming<NativeEngine>>;

/// Calls f(extents) at every leaf, in order. An engine that has just been reset follows each step.
class ExtentsOfLeaves {
 public:
  ExtentsOfLeaves(NativeEngine engine, const Preorder& tree, std::size_t levels)
      : engine_(std::move(engine)), nodes_(tree.nodes()), levels_(levels) {
    engine_.reset();
  }

  template <class F>
  void for_each(F&& f) {
    if (!nodes_.empty()) walk(0, f);
  }

 private:
  template <class F>
  void walk(std::size_t k, F& f) {
    for (bool more = true; more;) {
      const Preorder::Node node = nodes_[at_++];
      more = node.has_next_sibling;
      const Step step = engine_.step(k, node.arm);
      if (k + 1 == levels_) {
        f(engine_.extents_after(k, node.arm, step));
        continue;
      }
      engine_.enter(k, node.arm, step);
      walk(k + 1, f);
      engine_.leave(k, node.arm, step);
    }
  }

  NativeEngine engine_;
  std::span<const Preorder::Node> nodes_;
  std::size_t levels_;
  std::size_t at_ = 0;
};

}  // namespace

class MapTree::Growing {
 public:
  explicit Growing(Options given)
      : options(std::move(given)),
        preference(options.axioms.preference()),
        engine(make_engine(options, table)) {}
  Growing(const Growing&) = delete;

  Growth extend(std::span<const Visit> visits);

  Options options;
  Preference preference;
  ArmTable table;
  Engine engine;
  Preorder tree;
  std::vector<std::uint64_t> per_visit;
  std::vector<HypothesisId> minimal;

 private:
  template <class E>
  class Pass;
};

/// Walks the tree depth first with an engine that follows each step, and at each leaf goes on into
/// the new visits. What does not reach the last of them is taken back.
template <class E>
class MapTree::Growing::Pass {
 public:
  Pass(Growing& growing, E& engine, std::size_t levels_before)
      : growing_(growing),
        engine_(engine),
        old_(growing.tree.nodes()),
        levels_before_(levels_before),
        levels_(growing.table.visits()),
        max_hypotheses_(growing.options.max_hypotheses),
        per_visit_(growing.per_visit) {
    per_visit_.resize(levels_, 0);
  }

  Growth run() {
    engine_.reset();
    if (levels_before_ == 0)
      grow(0);
    else if (!old_.empty())
      replay(0);
    if (growth_ == Growth::complete && has_too_many()) growth_ = Growth::too_many;
    if (growth_ != Growth::complete) return growth_;
    next_.shrink();
    growing_.tree = std::move(next_);
    growing_.per_visit = std::move(per_visit_);
    growing_.minimal = std::move(minimal_);
    return growth_;
  }

 private:
  bool replay(std::size_t k) {
    Preorder::Siblings siblings(next_, levels_);
    for (bool more = true; more && growth_ == Growth::complete;) {
      const Preorder::Node node = old_[at_++];
      more = node.has_next_sibling;
      const Step step = engine_.step(k, node.arm);
      siblings.begin(node.arm);
      engine_.enter(k, node.arm, step);
      const bool lives = k + 1 < levels_before_ ? replay(k + 1) : grow(k + 1);
      engine_.leave(k, node.arm, step);
      lives ? siblings.keep() : siblings.take_back();
    }
    return siblings.any();
  }

  bool grow(std::size_t k) {
    if (k + 1 == levels_) return grow_leaves();
    Preorder::Siblings siblings(next_, levels_);
    engine_.for_each_child(k, [&](ArmIndex arm, auto step) {
      if (growth_ != Growth::complete) return;
      if (--until_question_ == 0) ask(k);
      const auto [end, lives] = engine_.follow(k, arm, step);
      for (std::size_t visit = k; visit < end; ++visit) ++per_visit_[visit];
      if (!lives) return;
      siblings.begin(arm);
      for (std::size_t visit = k + 1; visit < end; ++visit)
        siblings.add_below(engine_.arrived(visit));
      if (end == levels_) {
        rank(growing_.preference.rank(engine_.extents_after(k, arm, step)));
        return siblings.keep();
      }
      engine_.enter(k, arm, step);
      const bool any = grow(end);
      engine_.leave(k, arm, step);
      any ? siblings.keep() : siblings.take_back();
    });
    return siblings.any();
  }

  /// The last visit, which nothing follows: the level with most hypotheses, so made short.
  bool grow_leaves() {
    const std::size_t k = levels_ - 1;
    if (--until_question_ == 0) ask(k);
    const std::size_t leaves_before = leaves_;
    engine_.for_each_child(k, [&](ArmIndex arm, auto step) {
      next_.add_leaf(arm);
      rank(growing_.preference.rank(engine_.extents_after(k, arm, step)));
    });
    if (leaves_ == leaves_before) return false;
    next_.end_leaves();
    per_visit_[k] += leaves_ - leaves_before;
    return true;
  }

  bool has_too_many() const {
    return std::ranges::any_of(per_visit_, [&](auto n) { return n > max_hypotheses_; });
  }

  /// Is it to go on?
  void ask(std::size_t visit) {
    until_question_ = children_between_questions;
    if (has_too_many())
      growth_ = Growth::too_many;
    else if (growing_.options.go_on && !growing_.options.go_on(visit, per_visit_[visit]))
      growth_ = Growth::stopped;
  }

  void rank(Preference::Rank rank) {
    if (leaves_ == 0 || rank < best_) {
      best_ = rank;
      minimal_.clear();
    }
    if (rank == best_) minimal_.emplace_back(leaves_);
    ++leaves_;
  }

  Growing& growing_;
  E& engine_;
  std::span<const Preorder::Node> old_;
  std::size_t at_ = 0;  ///< in old_
  std::size_t levels_before_;
  std::size_t levels_;
  std::uint64_t max_hypotheses_;
  static constexpr std::uint64_t children_between_questions =
      asks_no_solver<E> ? 1 << 16 : 16;  // some milliseconds
  std::uint64_t until_question_ = children_between_questions;
  Growth growth_ = Growth::complete;

  Preorder next_;
  std::vector<std::uint64_t> per_visit_;
  std::size_t leaves_ = 0;
  Preference::Rank best_ = 0;
  std::vector<HypothesisId> minimal_;
};

MapTree::Growth MapTree::Growing::extend(std::span<const Visit> visits) {
  const std::size_t levels_before = table.visits();
  const auto undo = [&] { table.keep_first(levels_before); };
  try {
    for (const Visit& visit : visits) table.append(visit);
    if (visits.empty()) return Growth::complete;
    const Growth growth = std::visit(
        [&](auto& e) {
          using E = std::remove_reference_t<decltype(e)>;
          if (options.assumptions.empty()) return Pass<E>(*this, e, levels_before).run();
          Assuming<E> assuming(e, table, options.assumptions);
          return Pass<Assuming<E>>(*this, assuming, levels_before).run();
        },
        engine);
    if (growth != Growth::complete) undo();
    return growth;
  } catch (const DifferenceError& difference) {
    undo();
    // Depth first, another branch may differ earlier: see whether a shorter trace shows it.
    std::vector<Visit> shorter = difference.shortest_trace.visits;
    shorter.pop_back();
    if (shorter.size() > levels_before) Growing(options).extend(shorter);
    throw;
  } catch (...) {
    undo();
    throw;
  }
}

MapTree::MapTree(Options options) : growing_(std::make_unique<Growing>(std::move(options))) {}
MapTree::~MapTree() = default;
MapTree::MapTree(MapTree&&) noexcept = default;
MapTree& MapTree::operator=(MapTree&&) noexcept = default;

MapTree::Growth MapTree::extend(std::span<const Visit> visits) { return growing_->extend(visits); }

void MapTree::leave(std::size_t left_by) {
  if (growing_->table.visits() == 0) throw std::invalid_argument("there is no visit to leave");
  growing_->table.leave(left_by);
}

std::uint64_t MapTree::size() const {
  return growing_->per_visit.empty() ? 0 : growing_->per_visit.back();
}

std::span<const std::uint64_t> MapTree::per_visit() const { return growing_->per_visit; }

std::uint64_t MapTree::undecided() const {
  return std::visit(
      [](const auto& engine) -> std::uint64_t {
        if constexpr (std::is_same_v<std::decay_t<decltype(engine)>, NativeEngine>)
          return 0;
        else
          return engine.undecided();
      },
      growing_->engine);
}

std::size_t MapTree::memory_bytes() const { return growing_->tree.memory_bytes(); }

const Trace& MapTree::trace() const { return growing_->table.trace(); }

const MapTree::Options& MapTree::options() const { return growing_->options; }

std::span<const HypothesisId> MapTree::minimal() const { return growing_->minimal; }

std::vector<std::vector<HypothesisId>> MapTree::by_preference() const {
  std::map<Preference::Rank, std::vector<HypothesisId>> of_rank;
  std::size_t leaf = 0;
  const auto add = [&](const Extents& extents) {
    of_rank[growing_->preference.rank(extents)].emplace_back(leaf++);
  };
  if (growing_->options.axioms.is_shipped())
    ExtentsOfLeaves(native_engine(growing_->options, growing_->table), growing_->tree,
                    growing_->table.visits())
        .for_each(add);
  else
    for_each([&](HypothesisId, std::span<const Arrival> arrivals) {
      add(extents_of(make_map(trace(), arrivals)));
    });
  std::vector<std::vector<HypothesisId>> result;
  for (auto& [rank, hypotheses] : of_rank) result.push_back(std::move(hypotheses));
  return result;
}

TopologicalMap MapTree::map(HypothesisId id) const {
  std::optional<TopologicalMap> map;
  for_each({&id, 1}, [&](HypothesisId, std::span<const Arrival> arrivals) {
    map = make_map(trace(), arrivals);
  });
  return map.value();
}

void MapTree::for_each(const std::function<void(HypothesisId, std::span<const Arrival>)>& f) const {
  for_each_while([&](HypothesisId id, std::span<const Arrival> arrivals) {
    f(id, arrivals);
    return true;
  });
}

void MapTree::for_each(std::span<const HypothesisId> ids,
                       const std::function<void(HypothesisId, std::span<const Arrival>)>& f) const {
  for_each_while(ids, [&](HypothesisId id, std::span<const Arrival> arrivals) {
    f(id, arrivals);
    return true;
  });
}

void MapTree::for_each_while(
    const std::function<bool(HypothesisId, std::span<const Arrival>)>& f) const {
  const ArmTable& table = growing_->table;
  growing_->tree.for_each_leaf(table.visits(),
                               [&](std::uint64_t leaf, std::span<const ArmIndex> named) {
                                 return f(HypothesisId(leaf), table.arrivals(named));
                               });
}

void MapTree::for_each_while(
    std::span<const HypothesisId> ids,
    const std::function<bool(HypothesisId, std::span<const Arrival>)>& f) const {
  const ArmTable& table = growing_->table;
  growing_->tree.for_each_leaf(table.visits(),
                               [&](std::uint64_t leaf, std::span<const ArmIndex> named) {
                                 if (ids.empty()) return false;
                                 if (ids.front() != HypothesisId(leaf)) return true;
                                 ids = ids.subspan(1);
                                 return f(HypothesisId(leaf), table.arrivals(named));
                               });
}

}  // namespace asterism
