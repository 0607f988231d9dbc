#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "io/byte_source.hpp"

namespace asterism {

/// Longer than any line of text that is meant: some hundred thousand numbers.
inline constexpr std::size_t max_line_bytes = std::size_t{1} << 20;

/// The lines of a text, packed or not, one at a time. Holds no more than one line and a buffer.
class LineReader {
 public:
  /// @param name  for messages
  /// @throws InputError if nothing can be read
  LineReader(std::unique_ptr<std::istream> in, std::string name);

  /// The next line without its end, good until the next call; nothing after the last.
  /// @throws InputError "name:line: found ...; expected ..." for damaged compression and for a line
  ///         of more than max_line_bytes
  std::optional<std::string_view> next();

  /// Name and number of the line read last, counted from 1: "drive.log:17".
  std::string where() const { return name_ + ':' + std::to_string(line_); }
  const std::string& name() const noexcept { return name_; }
  std::uint64_t bytes_taken() const noexcept { return source_->bytes_taken(); }

 private:
  std::string_view take(std::size_t end, std::size_t next_begin);
  void fill();

  std::string name_;
  std::unique_ptr<ByteSource> source_;
  std::string buffer_;
  std::size_t begin_ = 0;  ///< of what was not yet handed out
  bool is_end_ = false;
  std::uint64_t line_ = 0;
};

}  // namespace asterism
