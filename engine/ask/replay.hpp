#pragma once

#include <span>
#include <vector>

#include "engine/arm_table.hpp"
#include "engine/ask/map_list.hpp"
#include "engine/tree/native_engine.hpp"

namespace asterism {

/// The native engine at one map of a list after another: what two of them share at the start
/// is kept.
class Replay {
 public:
  /// @throws std::invalid_argument if the axioms are none that the native engine knows
  explicit Replay(const MapList& maps);
  Replay(const Replay&) = delete;
  Replay& operator=(const Replay&) = delete;

  /// @pre  it is of this list
  void go_to(std::span<const Arrival> map);

  const ArmTable& table() const { return table_; }
  const NativeEngine& engine() const { return engine_; }
  /// The arm by which the robot came to where it is.
  ArmId arrived() const { return entered_.back().arm; }

 private:
  struct Entered {
    ArmId arm;
    Step step;
  };

  ArmTable table_;
  NativeEngine engine_;
  std::vector<Entered> entered_;
};

/// A star as it is seen by one who comes in by arm i: read from there, its local-paths called a, b
/// and so on, each with + first. Equal where the views are.
Star star_as_seen(const Star& star, std::size_t i);

}  // namespace asterism
