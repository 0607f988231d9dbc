#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/ssh/ssh_table.hpp"

namespace asterism {

/// What the axioms force on the dstates of one hypothesis of the basic SSH: the native engine's own
/// bookkeeping, grown action by action.                                     [theory §5] [RK04]
///
/// Kept are the result of each action, travels that reversible derives among them; the dstates at
/// each place (turn); and which dstates come before which (order, opposite, transitive). Equality
/// of directed paths and `on` refute nothing, so they are not kept. What breaks an axiom leaves the
/// closure unusable: work on a copy.
class SshClosure {
 public:
  using DState = std::uint32_t;
  using ActionNumber = SshTable::ActionNumber;

  /// Which are in force.
  struct OptionalAxioms {
    bool one_segment = false;
    bool one_crossing = false;
  };

  /// @param most_dstates  that there will ever be
  SshClosure(std::size_t most_dstates, OptionalAxioms optional)
      : words_((most_dstates + 63) / 64), optional_(optional) {}

  std::size_t size() const { return place_.size(); }
  /// One more, its place its own, with the next number.
  void add_dstate();
  /// Where an action is known to lead.
  std::optional<DState> result(DState q, ActionNumber action) const;
  /// The action, done at q, leads to r.
  /// @return whether all axioms still hold (view apart, which the caller sees to)
  bool add_result(DState q, ActionNumber action, DState r);

 private:
  static constexpr DState none = UINT32_MAX;
  using Word = std::uint64_t;
  /// A row of bits for each dstate.
  using Rows = std::vector<Word>;
  struct Turn {
    DState from;
    ActionNumber action;
    DState to;
  };
  struct Derived {
    bool is_travel;  ///< or an order
    DState q;
    DState r;
  };

  static bool has(const Rows& rows, std::size_t words, DState row, DState bit) {
    return (rows[row * words + bit / 64] >> (bit % 64) & 1) != 0;
  }
  bool is_before(DState q, DState r) const { return has(before_, words_, q, r); }

  bool join_places(DState q, DState r);
  bool add_turn_around(DState q, DState r);
  bool add_travel(DState q, DState r);
  bool add_order(DState q, DState r);
  void turn_round(bool is_travel, DState q, DState r);
  bool derive();
  bool keeps_one_segment() const;
  bool keeps_one_crossing() const;

  std::size_t words_;  ///< in a row
  OptionalAxioms optional_;
  std::vector<DState> travel_;  ///< where travel leads, or none
  std::vector<DState> around_;  ///< where a turn-around leads, or none
  std::vector<Turn> turns_;     ///< the other turns
  std::vector<DState> place_;   ///< of each dstate: a dstate that is there
  Rows members_;                ///< of the place named by a dstate
  Rows before_;                 ///< order(q, r)
  std::vector<Derived> agenda_;
};

}  // namespace asterism
