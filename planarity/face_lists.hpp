#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/id_vector.hpp"

namespace asterism {

/// For each face of a growing planar map, the cyclic list of open gateways along its boundary.
///                                                                     [SK04] [theory §7]
/// Every step can be undone, in reverse order: what a step
/// unlinks keeps its own links, so undoing only puts it back ("dancing links").
template <class Gateway>
class FaceLists {
 public:
  /// Begins again, with none open.  @param gateways  how many ids of them there are

  void reset(std::size_t gateways) {
    next_.assign(gateways, Gateway(0));
    previous_.assign(gateways, Gateway(0));
  }

  /// The open gateway after `gateway` on the boundary of its face. Closing x with y is planar iff
  /// both stand in one list.
  Gateway next(Gateway gateway) const { return next_[gateway]; }

  /// The first star gives one list.
  void open(std::span<const Gateway> clockwise) {
    for (std::size_t i = 0; i < clockwise.size(); ++i)
      join(clockwise[i], clockwise[(i + 1) % clockwise.size()]);
  }

  /// A new place replaces the travelled gateway x by its own open gateways, clockwise after the one
  /// entered by.
  void replace(Gateway x, std::span<const Gateway> clockwise) {
    const Gateway before = previous_[x];
    const Gateway after = next_[x];
    if (before == x) return open(clockwise);
    Gateway last = before;
    for (const Gateway gateway : clockwise) {
      join(last, gateway);
      last = gateway;
    }
    join(last, after);
  }
  void undo_replace(Gateway x) {
    next_[previous_[x]] = x;
    previous_[next_[x]] = x;
  }

  /// Closing x with y splits their list (x A y B) into (A) and (B).
  /// @pre both stand in one list
  void close(Gateway x, Gateway y) {
    const Gateway a_first = next_[x];
    const Gateway a_last = previous_[y];
    const Gateway b_first = next_[y];
    const Gateway b_last = previous_[x];
    if (a_first != y) join(a_last, a_first);
    if (b_first != x) join(b_last, b_first);
  }
  void undo_close(Gateway x, Gateway y) {
    for (const Gateway gateway : {x, y}) undo_replace(gateway);
  }

 private:
  void join(Gateway first, Gateway second) {
    next_[first] = second;
    previous_[second] = first;
  }

  IdVector<Gateway, Gateway> next_;
  IdVector<Gateway, Gateway> previous_;
};

}  // namespace asterism
