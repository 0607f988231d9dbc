#pragma once

#include <string>
#include <vector>

#include "engine/ssh/ssh_tree.hpp"
#include "tests/engine/ssh/ssh_reference.hpp"

namespace asterism {

MapTree::Options options(bool planar, Check check = Check::native,
                         const std::string& optional = "");

/// The tree grown by the whole experience.  @throws std::logic_error if growth stops early
SshTree tree_of(const Experience& experience, MapTree::Options with);

/// The dstates of all maps, in the order of the tree; of the minimal ones.
std::vector<Naming> maps_of(const SshTree& tree);
std::vector<Naming> minimal_of(const SshTree& tree);

/// The dstates at which an engine says that view k may have been seen.
template <class Engine>
std::vector<DStateId> children_of(Engine& engine, VisitId k) {
  std::vector<DStateId> result;
  engine.for_each_child(k, [&](DStateId dstate, bool) { result.push_back(dstate); });
  return result;
}

/// Maps after each view.
std::vector<std::uint64_t> counts_of(const SshTree& tree);

/// What a failing test prints.
std::string to_keep(unsigned seed, const Experience& seen);

}  // namespace asterism
