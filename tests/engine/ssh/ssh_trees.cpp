#include "tests/engine/ssh/ssh_trees.hpp"

#include <stdexcept>

#include "tests/engine/seeded_walk.hpp"

namespace asterism {
namespace {

Naming naming_of(const SshMap& map) {
  Naming naming;
  for (const DStateId dstate : map.dstates) naming.push_back(dstate.index());
  return naming;
}

}  // namespace

MapTree::Options options(bool planar, Check check, const std::string& optional) {
  return {.theory = {.axioms = shipped_with(optional), .planar = planar}, .check = check};
}

SshTree tree_of(const Experience& experience, MapTree::Options with) {
  SshTree tree(experience, std::move(with));
  if (tree.grow(experience.views.size()) != MapTree::Growth::complete)
    throw std::logic_error("the tree stopped growing");
  return tree;
}

std::vector<Naming> maps_of(const SshTree& tree) {
  std::vector<Naming> result;
  tree.for_each([&](const SshMap& map) { result.push_back(naming_of(map)); });
  return result;
}

std::vector<Naming> minimal_of(const SshTree& tree) {
  std::vector<Naming> result;
  for (const SshMap& map : tree.minimal()) result.push_back(naming_of(map));
  return result;
}

std::vector<std::uint64_t> counts_of(const SshTree& tree) {
  return {tree.per_view().begin(), tree.per_view().end()};
}

std::string to_keep(unsigned seed, const Experience& seen) {
  std::string text = "seed " + std::to_string(seed) + ": " + seen.views.front();
  for (std::size_t k = 0; k < seen.actions.size(); ++k)
    text += " " + seen.actions[k].text() + " " + seen.views[k + 1];
  return text;
}

}  // namespace asterism
