#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/pose2.hpp"
#include "io/bounds.hpp"
#include "io/line_reader.hpp"

namespace asterism {

/// The words of one line of a text, taken from the left; asked for what each must be.
///
/// Every question throws InputError where the next word is something else: "file:line: found ...;
/// expected ...".
class LineWords {
 public:
  /// The line that `reader` read last. Both must outlive this.
  LineWords(std::string_view text, const LineReader& reader) : rest_(text), reader_(&reader) {}

  /// The next word, empty at the end of the line.
  std::string_view next_word();
  /// A word, whatever it says.
  std::string_view word(const std::string& name);
  /// A number in decimals, in its bounds.
  double number(const std::string& name, Bounds bounds = {});
  /// An integer, of things that could be listed in the line.
  std::size_t count(const std::string& name, std::size_t smallest);
  /// An integer from 0 to `largest`, written in digits alone.
  std::uint64_t integer(const std::string& name, std::uint64_t largest);
  /// So many numbers of a kind.
  std::vector<double> numbers(std::size_t size, const std::string& name, Bounds bounds = {});
  /// Position and heading, each named `name` and what it is.
  Pose2 pose(const std::string& name);
  /// A number that is 0 of what lies in the plane, up to 1e-3, since some write few digits.
  double planar_zero(const std::string& name);
  /// The end of the line. `last` names the word before it.
  void end(const std::string& last);

  /// A word found where another is expected; none is the end of the line.
  [[noreturn]] void refuse(std::string_view word, const std::string& expected) const;
  /// Something that several words say together, where something else is expected.
  [[noreturn]] void complain(const std::string& found, const std::string& expected) const;

 private:
  std::string_view rest_;
  const LineReader* reader_;
};

/// The next line that is neither blank nor a comment, which starts with #; nothing after the last.
std::optional<LineWords> next_data_line(LineReader& reader);

}  // namespace asterism
