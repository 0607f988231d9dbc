#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/pose2.hpp"
#include "io/line_reader.hpp"

namespace asterism {

/// What a number of a line may be: between two whole numbers, above 0, or any that is finite.
struct Bounds {
  double low = -std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::max();

  bool contain(double value) const { return value >= low && value <= high; }
};
inline constexpr Bounds above_0{std::numeric_limits<double>::min()};
inline constexpr Bounds position_bounds_m{-1e7, 1e7};  ///< so that cells stay countable
inline constexpr Bounds heading_bounds_rad{-1e6, 1e6};
inline constexpr Bounds offset_bounds{-100, 100};  ///< of a laser on a robot, metres or radians
inline constexpr Bounds range_bounds_m{0, 1e6};

/// The words of one line of a log, taken from the left; asked for what each must be.
///
/// Every question throws InputError where the next word is something else: "file:line: found ...;
/// expected ...".
class CarmenLine {
 public:
  /// The line that `reader` read last. Both must outlive this.
  CarmenLine(std::string_view text, const LineReader& reader) : rest_(text), reader_(&reader) {}

  /// The next word, empty at the end of the line.
  std::string_view next_word();
  /// A word, whatever it says.
  std::string_view word(const std::string& name);
  double number(const std::string& name, Bounds bounds = {});
  std::size_t count(const std::string& name, std::size_t smallest);
  /// So many numbers of a kind.
  std::vector<double> numbers(std::size_t size, const std::string& name, Bounds bounds = {});
  /// Position and heading, each named `name` and what it is.
  Pose2 pose(const std::string& name);
  /// The end of the line. `last` names the word before it.
  void end(const std::string& last);

  [[noreturn]] void refuse(std::string_view found, const std::string& expected) const;

 private:
  std::string_view rest_;
  const LineReader* reader_;
};

}  // namespace asterism
