#include "engine/ssh_tree.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "engine/preorder.hpp"
#include "engine/ssh_engines.hpp"
#include "planarity/boyer_myrvold.hpp"

namespace asterism {
namespace {

using DState = SshTable::DState;
using Engine = std::variant<SshNative, SshSolver, SshBoth>;

Engine make_engine(const MapTree::Options& options, const SshTable& table) {
  if (options.check != Check::solver && !options.axioms.is_shipped())
    throw std::invalid_argument("axioms other than the shipped ones need the solver");
  if (!options.assumptions.empty())
    throw std::invalid_argument("nothing can be assumed of visits: the basic SSH has none");
  SshNative native(table, {.one_segment = options.axioms.contains("one_segment"),
                           .one_crossing = options.axioms.contains("one_crossing")});
  if (options.check == Check::native) return native;
  SshSolver solver(table, options.axioms, options.solver_timeout_ms);
  if (options.check == Check::solver) return solver;
  return SshBoth(std::move(native), std::move(solver), table);
}

SshMap map_of(const SshTable& table, std::span<const DState> named) {
  const std::vector<DStateId> dstates(named.begin(), named.end());
  return make_ssh_map(table.experience(), dstates);
}

}  // namespace

class SshTree::Growing {
 public:
  Growing(Experience experience, MapTree::Options given)
      : options(std::move(given)),
        table(std::move(experience)),
        engine(make_engine(options, table)) {}
  Growing(const Growing&) = delete;

  MapTree::Options options;
  SshTable table;
  Engine engine;
  Preorder tree;
  std::vector<std::uint64_t> kept;      ///< after each view
  std::vector<std::uint64_t> per_view;  ///< of these, what counts as a map

  template <class E>
  class Pass;
};

/// Walks the tree depth first with an engine that follows each step, and at each leaf goes on into
/// the next views. What does not reach the last of them is taken back.
template <class E>
class SshTree::Growing::Pass {
 public:
  Pass(Growing& growing, E& engine, std::size_t views)
      : growing_(growing),
        engine_(engine),
        old_(growing.tree.nodes()),
        levels_before_(growing.per_view.size()),
        levels_(levels_before_ + views),
        kept_(growing.kept),
        per_view_(growing.per_view) {
    kept_.resize(levels_, 0);
    per_view_.resize(levels_, 0);
  }

  MapTree::Growth run() {
    engine_.reset();
    if (levels_before_ == 0)
      grow(0);
    else if (!old_.empty())
      replay(0);
    if (growth_ == MapTree::Growth::complete && has_too_many()) growth_ = MapTree::Growth::too_many;
    if (growth_ != MapTree::Growth::complete) return growth_;
    growing_.tree = std::move(next_);
    growing_.kept = std::move(kept_);
    growing_.per_view = std::move(per_view_);
    return growth_;
  }

 private:
  bool replay(std::size_t k) {
    Preorder::Siblings siblings(next_, levels_);
    for (bool more = true; more && growth_ == MapTree::Growth::complete;) {
      const Preorder::Node node = old_[at_++];
      more = node.has_next_sibling;
      if (!engine_.try_enter(node.arm)) {  // was undecided, and is refuted now
        skip(k + 1);
        continue;
      }
      named_.push_back(node.arm);
      siblings.begin(node.arm);
      const bool lives = k + 1 < levels_before_ ? replay(k + 1) : grow(k + 1);
      lives ? siblings.keep() : siblings.take_back();
      named_.pop_back();
      engine_.leave();
    }
    return siblings.any();
  }

  /// Passes over what was below a node.
  void skip(std::size_t k) {
    for (bool more = k < levels_before_; more;) {
      more = old_[at_++].has_next_sibling;
      skip(k + 1);
    }
  }

  bool grow(std::size_t k) {
    if (k == levels_) return true;
    Preorder::Siblings siblings(next_, levels_);
    for (const DState dstate : engine_.candidates()) {
      if (--until_question_ == 0) ask(k);
      if (growth_ != MapTree::Growth::complete) break;
      if (!engine_.try_enter(dstate)) continue;
      named_.push_back(dstate);
      ++kept_[k];
      if (!growing_.options.planar || is_planar(map_of(growing_.table, named_))) ++per_view_[k];
      siblings.begin(dstate);
      grow(k + 1) ? siblings.keep() : siblings.take_back();
      named_.pop_back();
      engine_.leave();
    }
    return siblings.any();
  }

  bool has_too_many() const {
    return std::ranges::any_of(kept_, [&](auto n) { return n > growing_.options.max_hypotheses; });
  }

  /// Is it to go on?
  void ask(std::size_t view) {
    until_question_ = candidates_between_questions;
    if (has_too_many())
      growth_ = MapTree::Growth::too_many;
    else if (growing_.options.go_on && !growing_.options.go_on(view, per_view_[view]))
      growth_ = MapTree::Growth::stopped;
  }

  static constexpr std::uint64_t candidates_between_questions =
      std::is_same_v<E, SshNative> ? 1 << 12 : 16;  // some milliseconds

  Growing& growing_;
  E& engine_;
  std::span<const Preorder::Node> old_;
  std::size_t at_ = 0;  ///< in old_
  std::size_t levels_before_;
  std::size_t levels_;
  std::uint64_t until_question_ = candidates_between_questions;
  MapTree::Growth growth_ = MapTree::Growth::complete;

  Preorder next_;
  std::vector<std::uint64_t> kept_;
  std::vector<std::uint64_t> per_view_;
  std::vector<DState> named_;
};

SshTree::SshTree(Experience experience, MapTree::Options options)
    : growing_(std::make_unique<Growing>(std::move(experience), std::move(options))) {}
SshTree::~SshTree() = default;
SshTree::SshTree(SshTree&&) noexcept = default;
SshTree& SshTree::operator=(SshTree&&) noexcept = default;

MapTree::Growth SshTree::grow(std::size_t views) {
  if (this->views() + views > growing_->table.views())
    throw std::invalid_argument("more views than were experienced");
  if (views == 0) return MapTree::Growth::complete;
  return std::visit(
      [&](auto& engine) {
        return Growing::Pass<std::remove_reference_t<decltype(engine)>>(*growing_, engine, views)
            .run();
      },
      growing_->engine);
}

std::span<const std::uint64_t> SshTree::per_view() const { return growing_->per_view; }

std::uint64_t SshTree::undecided() const {
  return std::visit([](const auto& engine) { return engine.undecided(); }, growing_->engine);
}

void SshTree::for_each(const std::function<void(const SshMap&)>& f) const {
  if (views() == 0) return;
  growing_->tree.for_each_leaf(views(), [&](std::uint64_t, std::span<const DState> named) {
    const SshMap map = map_of(growing_->table, named);
    if (!growing_->options.planar || is_planar(map)) f(map);
    return true;
  });
}

std::vector<SshMap> SshTree::minimal() const {
  const std::vector<std::string>& preference = growing_->options.axioms.preference();
  std::vector<SshMap> result;
  std::vector<std::size_t> least;
  for_each([&](const SshMap& map) {
    const std::vector<std::size_t> extents = extents_of(map, preference);
    if (result.empty() || extents < least) {
      result.clear();
      least = extents;
    }
    if (extents == least) result.push_back(map);
  });
  return result;
}

std::vector<std::size_t> extents_of(const SshMap& map, std::span<const std::string> preference) {
  std::vector<std::size_t> result;
  for (const std::string& extent : preference)
    result.push_back(extent == "path"    ? map.number_of_paths()
                     : extent == "place" ? map.number_of_places()
                                         : map.segments.size());
  return result;
}

std::vector<std::pair<std::size_t, std::size_t>> edges_of(const SshMap& map) {
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& [from, to] : map.segments)
    edges.emplace_back(map.places[from.index()].index(), map.places[to.index()].index());
  return edges;
}

bool is_planar(const SshMap& map) { return is_planar_graph(map.number_of_places(), edges_of(map)); }

}  // namespace asterism
