#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/map_report.hpp"
#include "core/stop.hpp"
#include "engine/tree/map_tree.hpp"

namespace asterism {

/// Grows a tree of either kind by so many steps: in one pass where nothing can stop it early, since
/// that is the fastest; else step by step, to end on a whole level.
/// @param grow  grow(k, n) explains n steps from k on
/// @return what stopped it, if anything did, or that the solver owes answers
template <class Tree, class Grow>
std::optional<std::string> grow_all(const Tree& tree, std::size_t steps, const MapOptions& options,
                                    const Stop& stop, Grow grow) {
  const bool may_stop = options.max_hypotheses || stop.deadline != Deadline::max() ||
                        stop.memory_bytes || options.check != "native";
  const std::size_t at_once = may_stop ? 1 : steps;
  for (std::size_t k = 0; k < steps; k += at_once) {
    // The tree asks now and then within a level; a small one is over before.
    if (may_stop && stop.is_due({k, tree.size()})) return stop.reason;
    switch (grow(k, at_once)) {
      case MapTree::Growth::complete:
        break;
      case MapTree::Growth::stopped:
        return stop.reason;
      case MapTree::Growth::too_many:
        return "limit of " + std::to_string(*options.max_hypotheses) + " hypotheses";
    }
  }
  if (tree.undecided() == 0) return std::nullopt;
  return std::to_string(tree.undecided()) + " candidates undecided by the solver";
}

}  // namespace asterism
