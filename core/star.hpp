#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asterism {

/// One direction of a local-path, leading away from its place.               [BMK10, §5.1.2]
struct Arm {
  std::string label;         ///< names the local-path, within one visit
  char sign = '+';           ///< its direction, '+' or '-'
  bool has_gateway = false;  ///< α: whether one can travel that way

  friend bool operator==(const Arm&, const Arm&) = default;
};

/// The local topology of a place: its arms in clockwise circular order, seen from above.
///                                                                          [BMK10, §5.1.2]
/// Arms are named by their position in the listing, from 0. The opposite of an arm is the other
/// direction of its local-path; it need not stand half-way round, so the star stores the pairs.
///
/// Invariant: each local-path occurs exactly twice, once in each direction, and at least one of
/// the two has a gateway. A value: threads may read one side by side.
class Star {
 public:
  /// No star has more arms.
  static constexpr std::size_t max_arms = 256;

  /// @param arms  clockwise
  /// @throws std::invalid_argument "found ...; expected ..." if the invariant does not hold, or
  ///         there are more than max_arms
  explicit Star(std::vector<Arm> arms);

  /// Reads "a+1 b+1 a-1 b-0": label, direction, α; one space between arms.       [theory §2]
  /// @throws std::invalid_argument "found ...; expected ..."
  static Star parse(std::string_view text);
  /// The star as parse() reads it.
  std::string text() const;

  /// How many arms there are: two for each local-path.
  std::size_t size() const noexcept { return arms_.size(); }
  /// @throws std::out_of_range if there is no arm i
  const Arm& arm(std::size_t i) const { return arms_.at(i); }
  /// α of arm i: whether one can travel that way.   @throws std::out_of_range
  bool has_gateway(std::size_t i) const { return arms_.at(i).has_gateway; }
  /// The arm in the other direction of arm i's local-path.   @throws std::out_of_range
  std::size_t opposite(std::size_t i) const { return opposite_.at(i); }
  /// The arm that many steps clockwise after arm i.
  std::size_t clockwise(std::size_t i, std::size_t steps) const noexcept {
    return (i + steps) % arms_.size();
  }
  /// Position of an arm written as "a+"; nothing if the star has none of that name.
  std::optional<std::size_t> find(std::string_view arm_name) const;
  /// The name of arm i, "a+".   @throws std::out_of_range
  std::string name(std::size_t i) const { return arm(i).label + arm(i).sign; }

  /// The star as read clockwise from arm i, without labels: α and distance to the opposite arm, arm
  /// by arm. Two stars match from two arms iff these are equal; never mirrored.   [theory §3]
  std::vector<std::size_t> view(std::size_t i) const;

  friend bool operator==(const Star&, const Star&) = default;

 private:
  std::vector<Arm> arms_;
  std::vector<std::size_t> opposite_;
};

}  // namespace asterism
