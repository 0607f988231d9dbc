#include "io/line_reader.hpp"

#include <istream>

#include "core/error.hpp"

namespace asterism {
namespace {

constexpr std::size_t chunk_bytes = 65536;

void require_short(std::size_t line_bytes, const std::string& where) {
  if (line_bytes > max_line_bytes)
    throw InputError(where, "a line of more than " + std::to_string(max_line_bytes) + " bytes",
                     "a shorter line");
}

}  // namespace

LineReader::LineReader(std::unique_ptr<std::istream> in, std::string name)
    : name_(std::move(name)) {
  try {
    source_ = std::make_unique<ByteSource>(std::move(in));
  } catch (const CompressionError& error) {
    throw InputError(name_, error.what(), error.expected);
  }
}

std::optional<std::string_view> LineReader::next() {
  std::size_t searched = begin_;
  for (;;) {
    const std::size_t end = buffer_.find('\n', searched);
    if (end != std::string::npos) return take(end, end + 1);
    if (is_end_ && begin_ == buffer_.size()) return std::nullopt;
    if (is_end_) return take(buffer_.size(), buffer_.size());
    searched = buffer_.size() - begin_;
    fill();
  }
}

std::string_view LineReader::take(std::size_t end, std::size_t next_begin) {
  ++line_;
  require_short(end - begin_, where());
  const auto line = std::string_view(buffer_).substr(begin_, end - begin_);
  begin_ = next_begin;
  return line;
}

/// Moves the unread to the front and reads on behind it.
void LineReader::fill() {
  buffer_.erase(0, begin_);
  begin_ = 0;
  const std::size_t unread = buffer_.size();
  const std::string where = name_ + ':' + std::to_string(line_ + 1);
  require_short(unread, where);
  buffer_.resize(unread + chunk_bytes);
  try {
    const std::size_t size = source_->read(std::span(buffer_).subspan(unread));
    buffer_.resize(unread + size);
    is_end_ = size == 0;
  } catch (const CompressionError& error) {
    throw InputError(where, error.what(), error.expected);
  }
}

}  // namespace asterism
