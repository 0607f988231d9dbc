#include "engine/tree/map_tree.hpp"

#include <map>
#include <stdexcept>
#include <type_traits>
#include <variant>

#include "engine/arm_table.hpp"
#include "engine/preference.hpp"
#include "engine/tree/assuming.hpp"
#include "engine/tree/both_engines.hpp"
#include "engine/tree/growing_tree.hpp"
#include "engine/tree/native_engine.hpp"
#include "engine/tree/preorder.hpp"
#include "engine/tree/solver_engine.hpp"

namespace asterism {
namespace {

using Tree = Preorder<ArmId>;
using Both = BothEngines<NativeEngine, SolverEngine>;
using Engine = std::variant<NativeEngine, SolverEngine, Both>;

Engine make_engine(const MapTree::Options& options, const ArmTable& table) {
  const bool is_shipped = options.theory.axioms.is_shipped();
  if (options.check != Check::solver && !is_shipped)
    throw std::invalid_argument("axioms or extents other than the shipped ones need the solver");
  NativeEngine native(table, options.theory);
  if (options.check == Check::native) return native;
  SolverEngine solver(table, options.theory);
  if (options.check == Check::solver) return solver;
  return Both(std::move(native), std::move(solver));
}

/// Of the leaves told, those minimal under the preference: of the least rank.
template <class E, class RankOf>
struct MinimalLeaves {
  using Extents = decltype(std::declval<E&>().extents_after(VisitId(0), ArmId(0), Step{}));
  using Rank = std::invoke_result_t<const RankOf&, Extents>;

  E& engine;
  const RankOf& rank_of;
  std::uint64_t leaves = 0;
  Rank best = {};
  std::vector<HypothesisId> minimal = {};

  template <class S>
  void child(VisitId, ArmId, S) {}
  template <class S>
  void leaf(VisitId k, ArmId arm, S step) {
    Rank rank = rank_of(engine.extents_after(k, arm, step));
    if (leaves == 0 || rank < best) {
      best = std::move(rank);
      minimal.assign(1, HypothesisId(leaves));
    } else if (rank == best) {
      minimal.emplace_back(leaves);
    }
    ++leaves;
  }
};

/// Calls f(extents) at every leaf, in order. An engine that has just been reset follows each step.
class ExtentsOfLeaves {
 public:
  ExtentsOfLeaves(NativeEngine engine, const Tree& tree, std::size_t levels)
      : engine_(std::move(engine)), nodes_(tree.nodes()), levels_(levels) {
    engine_.reset();
  }

  template <class F>
  void for_each(F&& f) {
    if (!nodes_.empty()) walk(VisitId(0), f);
  }

 private:
  template <class F>
  void walk(VisitId k, F& f) {
    for (bool more = true; more;) {
      const Tree::Node node = nodes_[at_++];
      more = node.has_next_sibling();
      const Step step = engine_.step(k, node.choice());
      if (k.index() + 1 == levels_) {
        f(engine_.extents_after(k, node.choice(), step));
        continue;
      }
      engine_.enter(k, node.choice(), step);
      walk(k.next(), f);
      engine_.leave(k, node.choice(), step);
    }
  }

  NativeEngine engine_;
  std::span<const Tree::Node> nodes_;
  std::size_t levels_;
  std::size_t at_ = 0;
};

}  // namespace

DifferenceError::DifferenceError(const std::string& candidate, bool kept, AnyTrace trace)
    : Error("native and solver differ: " + candidate + " is " +
            (kept ? "consistent" : "inconsistent") + " to the native engine and " +
            (kept ? "inconsistent" : "consistent") + " to the solver"),
      shortest(std::move(trace)) {}

class MapTree::Growing {
 public:
  explicit Growing(Options given) : options(std::move(given)), engine(make_engine(options, table)) {
    if (!options.theory.axioms.minimises_own())
      preference.emplace(options.theory.axioms.preference());
  }
  Growing(const Growing&) = delete;

  Growth extend(std::span<const Visit> visits, const Stop& stop);

  /// What an engine tells of a hypothesis, to be compared: the smaller is preferred.
  Preference::Rank rank_of(const Extents& extents) const { return preference->rank(extents); }
  std::vector<std::size_t> rank_of(std::vector<std::size_t> by_preference) const {
    return by_preference;
  }

  Options options;
  std::optional<Preference> preference;  ///< unless an extent of the axioms' own is minimised
  ArmTable table;
  Engine engine;
  GrowingTree<ArmId> tree;
  std::vector<HypothesisId> minimal;

 private:
  template <class E>
  Growth grow(E& e, const Stop& stop);
};

template <class E>
MapTree::Growth MapTree::Growing::grow(E& e, const Stop& stop) {
  const auto rank = [this](const auto& extents) { return rank_of(extents); };
  MinimalLeaves<E, decltype(rank)> leaves{e, rank};
  const Growth growth = tree.grow(e, table.visits(), options.max_hypotheses, stop, leaves);
  if (growth == Growth::complete) minimal = std::move(leaves.minimal);
  return growth;
}

MapTree::Growth MapTree::Growing::extend(std::span<const Visit> visits, const Stop& stop) {
  const std::size_t levels_before = table.visits();
  const auto undo = [&] { table.keep_first(levels_before); };
  try {
    for (const Visit& visit : visits) table.append(visit);
    if (visits.empty()) return Growth::complete;
    const Growth growth = std::visit(
        [&](auto& e) {
          const std::vector<Assumption>& assumptions = options.theory.assumptions;
          if (assumptions.empty()) return grow(e, stop);
          Assuming assuming(e, table, assumptions);
          return grow(assuming, stop);
        },
        engine);
    if (growth != Growth::complete) undo();
    return growth;
  } catch (const DifferenceError& difference) {
    undo();
    // Depth first, another branch may differ earlier: see whether a shorter trace shows it.
    std::vector<Visit> shorter = std::get<Trace>(difference.shortest).visits;
    shorter.pop_back();
    if (shorter.size() > levels_before) Growing(options).extend(shorter, stop);
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

MapTree::Growth MapTree::extend(std::span<const Visit> visits, const Stop& stop) {
  return growing_->extend(visits, stop);
}

void MapTree::leave(std::size_t left_by) {
  if (growing_->table.visits() == 0) throw std::invalid_argument("there is no visit to leave");
  growing_->table.leave(left_by);
}

std::uint64_t MapTree::size() const { return per_visit().empty() ? 0 : per_visit().back(); }

std::span<const std::uint64_t> MapTree::per_visit() const { return growing_->tree.per_level(); }

std::uint64_t MapTree::undecided() const {
  return std::visit([](const auto& engine) { return engine.undecided(); }, growing_->engine);
}

std::size_t MapTree::memory_bytes() const { return growing_->tree.nodes().memory_bytes(); }

const Trace& MapTree::trace() const { return growing_->table.trace(); }

const MapTree::Options& MapTree::options() const { return growing_->options; }

std::span<const HypothesisId> MapTree::minimal() const { return growing_->minimal; }

std::vector<std::vector<HypothesisId>> MapTree::by_preference() const {
  const Theory& theory = growing_->options.theory;
  const auto values = [](auto ids_by_rank) {
    std::vector<std::vector<HypothesisId>> result;
    for (auto& [rank, hypotheses] : ids_by_rank) result.push_back(std::move(hypotheses));
    return result;
  };
  if (theory.axioms.is_shipped()) {
    std::size_t leaf = 0;
    std::map<Preference::Rank, std::vector<HypothesisId>> of_rank;
    ExtentsOfLeaves(NativeEngine(growing_->table, theory), growing_->tree.nodes(),
                    growing_->table.visits())
        .for_each([&](const Extents& extents) {
          of_rank[growing_->rank_of(extents)].emplace_back(leaf++);
        });
    return values(std::move(of_rank));
  }
  std::map<std::vector<std::size_t>, std::vector<HypothesisId>> of_sizes;
  for_each([&](HypothesisId id, std::span<const Arrival> arrivals) {
    of_sizes[extents_by_preference(trace(), arrivals, theory.axioms)].push_back(id);
  });
  return values(std::move(of_sizes));
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
  growing_->tree.nodes().for_each_leaf(table.visits(),
                                       [&](std::uint64_t leaf, std::span<const ArmId> named) {
                                         return f(HypothesisId(leaf), table.arrivals(named));
                                       });
}

void MapTree::for_each_while(
    std::span<const HypothesisId> ids,
    const std::function<bool(HypothesisId, std::span<const Arrival>)>& f) const {
  const ArmTable& table = growing_->table;
  growing_->tree.nodes().for_each_leaf(table.visits(),
                                       [&](std::uint64_t leaf, std::span<const ArmId> named) {
                                         if (ids.empty()) return false;
                                         if (ids.front() != HypothesisId(leaf)) return true;
                                         ids = ids.subspan(1);
                                         return f(HypothesisId(leaf), table.arrivals(named));
                                       });
}

}  // namespace asterism
