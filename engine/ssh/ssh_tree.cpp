#include "engine/ssh/ssh_tree.hpp"

#include <stdexcept>
#include <utility>
#include <variant>

#include "engine/preference.hpp"
#include "engine/ssh/ssh_engines.hpp"
#include "engine/tree/growing_tree.hpp"
#include "planarity/boyer_myrvold.hpp"

namespace asterism {
namespace {

using Engine = std::variant<SshNative, SshSolver, SshBoth>;

Engine make_engine(const MapTree::Options& options, const SshTable& table) {
  const auto& [axioms, planar, assumptions] = options.theory;
  if (options.check != Check::solver && !axioms.is_shipped())
    throw std::invalid_argument("axioms other than the shipped ones need the solver");
  if (axioms.minimises_own())
    throw std::invalid_argument("the basic SSH counts paths, places and segments alone");
  if (!assumptions.empty())
    throw std::invalid_argument("nothing can be assumed of visits: the basic SSH has none");
  SshNative native(table, {.one_segment = axioms.contains("one_segment"),
                           .one_crossing = axioms.contains("one_crossing")});
  if (options.check == Check::native) return native;
  SshSolver solver(table, axioms);
  if (options.check == Check::solver) return solver;
  return SshBoth(std::move(native), std::move(solver));
}

/// How many of those told count as maps, view by view.
template <class E>
struct MapCounts {
  const E& engine;
  const SshTable& table;
  const Theory& theory;
  std::vector<std::uint64_t> per_view;

  void child(VisitId k, DStateId dstate, bool) {
    if (theory.planar) {
      std::vector<DStateId> named(engine.named().begin(), engine.named().end());
      named.push_back(dstate);
      if (!is_planar(make_ssh_map(table.experience(), named))) return;
    }
    ++per_view[k.index()];
  }
  void leaf(VisitId, DStateId, bool) {}
};

}  // namespace

class SshTree::Growing {
 public:
  Growing(Experience experience, MapTree::Options given)
      : options(std::move(given)),
        table(std::move(experience)),
        engine(make_engine(options, table)) {}
  Growing(const Growing&) = delete;

  template <class E>
  MapTree::Growth grow(E& e, std::size_t views, const Stop& stop);

  MapTree::Options options;
  SshTable table;
  Engine engine;
  GrowingTree<DStateId> tree;
  std::vector<std::uint64_t> per_view;  ///< of what the tree keeps, what counts as a map
};

template <class E>
MapTree::Growth SshTree::Growing::grow(E& e, std::size_t views, const Stop& stop) {
  MapCounts<E> counts{e, table, options.theory, per_view};
  counts.per_view.resize(views, 0);
  const MapTree::Growth growth = tree.grow(e, views, options.max_hypotheses, stop, counts);
  if (growth == MapTree::Growth::complete) per_view = std::move(counts.per_view);
  return growth;
}

SshTree::SshTree(Experience experience, MapTree::Options options)
    : growing_(std::make_unique<Growing>(std::move(experience), std::move(options))) {}
SshTree::~SshTree() = default;
SshTree::SshTree(SshTree&&) noexcept = default;
SshTree& SshTree::operator=(SshTree&&) noexcept = default;

MapTree::Growth SshTree::grow(std::size_t views, const Stop& stop) {
  if (this->views() + views > growing_->table.views())
    throw std::invalid_argument("more views than were experienced");
  if (views == 0) return MapTree::Growth::complete;
  return std::visit(
      [&](auto& engine) { return growing_->grow(engine, this->views() + views, stop); },
      growing_->engine);
}

std::span<const std::uint64_t> SshTree::per_view() const { return growing_->per_view; }

std::uint64_t SshTree::undecided() const {
  return std::visit([](const auto& engine) { return engine.undecided(); }, growing_->engine);
}

void SshTree::for_each(const std::function<void(const SshMap&)>& f) const {
  if (views() == 0) return;
  growing_->tree.nodes().for_each_leaf(
      views(), [&](std::uint64_t, std::span<const DStateId> named) {
        const SshMap map = make_ssh_map(growing_->table.experience(), named);
        if (!growing_->options.theory.planar || is_planar(map)) f(map);
        return true;
      });
}

std::vector<SshMap> SshTree::minimal() const {
  const AxiomSet& axioms = growing_->options.theory.axioms;
  std::vector<SshMap> result;
  std::vector<std::size_t> least;
  for_each([&](const SshMap& map) {
    const std::vector<std::size_t> extents = extents_by_preference(map, axioms);
    if (result.empty() || extents < least) {
      result.clear();
      least = extents;
    }
    if (extents == least) result.push_back(map);
  });
  return result;
}

Extents extents_of(const SshMap& map) {
  return {.paths = static_cast<std::uint32_t>(map.number_of_paths()),
          .places = static_cast<std::uint32_t>(map.number_of_places()),
          .segments = static_cast<std::uint32_t>(map.segments.size())};
}

std::vector<std::pair<std::size_t, std::size_t>> edges_of(const SshMap& map) {
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& [from, to] : map.segments)
    edges.emplace_back(map.places[from.index()].index(), map.places[to.index()].index());
  return edges;
}

bool is_planar(const SshMap& map) { return is_planar_graph(map.number_of_places(), edges_of(map)); }

}  // namespace asterism
