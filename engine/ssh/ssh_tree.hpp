#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/extents.hpp"
#include "core/ssh_map.hpp"
#include "core/stop.hpp"
#include "engine/tree/map_tree.hpp"

namespace asterism {

/// The tree of every map that explains an experience of the basic SSH.   [BMK10, Fig. 5]
///                                                                                     [theory §4]
///
/// Turns and travels both branch. Where the result of an action is known, the view must be the one
/// seen there; else the dstate reached is any with the same view, or new. What breaks an axiom is
/// dropped. A map is planar if its places and segments can be drawn in the plane at all: there is
/// no circular order. As a later turn may show two places to be one, a map that is not planar may
/// become so; it is kept, and not counted. For one thread at a time.
class SshTree {
 public:
  /// max_hypotheses bounds all maps kept after a view, planar or not.
  /// @throws std::invalid_argument if the experience is not valid, something is assumed, or the
  ///         axioms need the solver and `check` does not name it
  SshTree(Experience experience, MapTree::Options options);
  ~SshTree();
  SshTree(SshTree&&) noexcept;
  SshTree& operator=(SshTree&&) noexcept;

  /// Explains so many views more. Where growth stops early, the tree is left as it was.
  /// @throws DifferenceError with Check::both
  /// @param stop  told of the view in work and the maps found so far
  MapTree::Growth grow(std::size_t views, const Stop& stop = {});

  /// Views explained.
  std::size_t views() const { return per_view().size(); }
  /// Maps that explain them.
  std::uint64_t size() const { return views() == 0 ? 0 : per_view().back(); }
  /// How many there were after each view.
  std::span<const std::uint64_t> per_view() const;
  /// Answers the solver owed: each kept its child.
  std::uint64_t undecided() const;

  /// Calls f(map) for each, in the order of their dstates.
  void for_each(const std::function<void(const SshMap&)>& f) const;
  /// Those minimal under the preference of the axioms, in the same order.      [theory §6]
  std::vector<SshMap> minimal() const;

 private:
  class Growing;
  std::unique_ptr<Growing> growing_;
};

/// Counted in a map written out.
Extents extents_of(const SshMap& map);

/// The places that each segment joins.
std::vector<std::pair<std::size_t, std::size_t>> edges_of(const SshMap& map);

/// Whether its places and segments can be drawn in the plane.
bool is_planar(const SshMap& map);

}  // namespace asterism
