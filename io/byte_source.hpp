#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>

namespace asterism {

/// Compressed data that cannot be read on; whoever knows the file and the line says where.
struct CompressionError : std::runtime_error {
  CompressionError(const std::string& what_found, std::string what_expected)
      : std::runtime_error(what_found), expected(std::move(what_expected)) {}
  std::string expected;
};

/// The bytes of a stream, unpacked if its first bytes say that it is gzip [RFC 1952] or xz. Several
/// compressed files one after the other count as one, as for gzip and xz themselves.
///
/// Memory does not grow with the stream: 64 KiB of it, and what the format asks for (gzip 32 KiB,
/// xz at most max_xz_memory_bytes).
class ByteSource {
 public:
  /// More than any preset of xz needs to unpack.
  static constexpr std::uint64_t max_xz_memory_bytes = std::uint64_t{80} << 20;

  explicit ByteSource(std::unique_ptr<std::istream> in);
  ~ByteSource();

  /// Fills `buffer` from the front; how many bytes, 0 at the end.
  /// @throws CompressionError after the bytes before the fault were handed out
  std::size_t read(std::span<char> buffer);

  /// Bytes of the stream taken so far, as they lie there.
  std::uint64_t bytes_taken() const noexcept;

 private:
  class Decoder;
  std::unique_ptr<Decoder> decoder_;
};

}  // namespace asterism
