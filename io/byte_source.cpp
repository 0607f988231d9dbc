#include "io/byte_source.hpp"

#include <lzma.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <istream>
#include <iterator>
#include <string_view>
#include <variant>

#include "io/shown.hpp"

namespace asterism {
namespace {

constexpr std::string_view gzip_magic = "\x1f\x8b";
constexpr std::string_view xz_magic(
    "\xfd"
    "7zXZ\0",
    6);

/// What a decoder did with the bytes it was shown.
struct Step {
  std::size_t taken = 0;
  std::size_t made = 0;
  bool is_end = false;
};

CompressionError cut_short() {
  return {"the end of the file amid compressed data", "the rest of it"};
}
CompressionError damaged(const std::string& format) {
  return {"damaged " + format + " data", "a whole " + format + " file"};
}

class Plain {
 public:
  static Step step(std::span<const char> in, std::span<char> out, bool is_all) {
    const std::size_t size = std::min(in.size(), out.size());
    std::copy_n(in.begin(), size, out.begin());
    return {size, size, is_all && size == in.size()};
  }
};

class Gzip {
 public:
  Gzip() {
    if (inflateInit2(&stream_, 16 + MAX_WBITS) != Z_OK) throw std::bad_alloc();
  }
  Gzip(const Gzip&) = delete;
  Gzip& operator=(const Gzip&) = delete;
  ~Gzip() { inflateEnd(&stream_); }

  Step step(std::span<const char> in, std::span<char> out, bool is_all) {
    if (is_between_members_ && in.empty() && is_all) return {0, 0, true};
    if (is_between_members_ && !in.empty() && in.front() != gzip_magic.front())
      throw CompressionError("other bytes after the compressed data", "the end of the file");
    stream_.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(in.data()));
    stream_.avail_in = static_cast<uInt>(in.size());
    stream_.next_out = reinterpret_cast<Bytef*>(out.data());
    stream_.avail_out = static_cast<uInt>(out.size());
    const int result = inflate(&stream_, Z_NO_FLUSH);
    const Step step{in.size() - stream_.avail_in, out.size() - stream_.avail_out, false};
    if (step.taken > 0) is_between_members_ = false;
    if (result == Z_STREAM_END) {
      inflateReset(&stream_);
      is_between_members_ = true;
    } else if (result == Z_MEM_ERROR) {
      throw std::bad_alloc();
    } else if (step.made == 0 && result != Z_OK && result != Z_BUF_ERROR) {
      throw damaged("gzip");  // a dictionary asked for, which gzip has not, is damage too
    }
    return step;
  }

 private:
  z_stream stream_ = {};
  bool is_between_members_ = false;
};

class Xz {
 public:
  Xz() {
    if (lzma_stream_decoder(&stream_, ByteSource::max_xz_memory_bytes, LZMA_CONCATENATED) !=
        LZMA_OK)
      throw std::bad_alloc();
  }
  Xz(const Xz&) = delete;
  Xz& operator=(const Xz&) = delete;
  ~Xz() { lzma_end(&stream_); }

  Step step(std::span<const char> in, std::span<char> out, bool is_all) {
    stream_.next_in = reinterpret_cast<const std::uint8_t*>(in.data());
    stream_.avail_in = in.size();
    stream_.next_out = reinterpret_cast<std::uint8_t*>(out.data());
    stream_.avail_out = out.size();
    // liblzma tells of a fault once only, maybe along with the last good bytes.
    if (!is_fault(result_)) result_ = lzma_code(&stream_, is_all ? LZMA_FINISH : LZMA_RUN);
    const Step step{in.size() - stream_.avail_in, out.size() - stream_.avail_out,
                    result_ == LZMA_STREAM_END};
    if (step.made > 0 || !is_fault(result_)) return step;
    switch (result_) {
      case LZMA_MEM_ERROR:
        throw std::bad_alloc();
      case LZMA_MEMLIMIT_ERROR:
        throw CompressionError("xz data that need more than " +
                                   std::to_string(ByteSource::max_xz_memory_bytes >> 20) +
                                   " MiB of memory to unpack",
                               "what xz makes by default");
      default:  // bytes after the end too, which could be the damaged head of another stream
        throw damaged("xz");
    }
  }

 private:
  static bool is_fault(lzma_ret result) {
    return result != LZMA_OK && result != LZMA_STREAM_END && result != LZMA_BUF_ERROR;
  }

  lzma_stream stream_ = LZMA_STREAM_INIT;
  lzma_ret result_ = LZMA_OK;
};

}  // namespace

class ByteSource::Decoder {
 public:
  explicit Decoder(std::unique_ptr<std::istream> in) : in_(std::move(in)) {
    refill();
    const std::string_view start(buffer_.data(), rest_.size());
    if (start.starts_with(gzip_magic))
      format_.emplace<Gzip>();
    else if (start.starts_with(xz_magic))
      format_.emplace<Xz>();
  }

  std::size_t read(std::span<char> out) {
    while (!is_end_) {
      if (rest_.empty() && !is_all_) refill();
      const Step step =
          std::visit([&](auto& format) { return format.step(rest_, out, is_all_); }, format_);
      rest_ = rest_.subspan(step.taken);
      is_end_ = step.is_end;
      if (step.made > 0) return step.made;
      if (!is_end_ && step.taken == 0 && rest_.empty() && is_all_) throw cut_short();
    }
    return 0;
  }

  std::uint64_t bytes_taken() const noexcept { return taken_; }

 private:
  void refill() {
    errno = 0;
    in_->read(buffer_.data(), std::ssize(buffer_));
    const auto size = static_cast<std::size_t>(in_->gcount());
    if (in_->bad()) throw CompressionError(system_message(errno), "a file that can be read");
    taken_ += size;
    rest_ = std::span<const char>(buffer_).first(size);
    is_all_ = !*in_;
  }

  std::unique_ptr<std::istream> in_;
  std::array<char, 65536> buffer_ = {};
  std::span<const char> rest_;  ///< of the buffer
  bool is_all_ = false;         ///< nothing follows the buffer
  bool is_end_ = false;
  std::uint64_t taken_ = 0;
  std::variant<Plain, Gzip, Xz> format_;
};

ByteSource::ByteSource(std::unique_ptr<std::istream> in)
    : decoder_(std::make_unique<Decoder>(std::move(in))) {}
ByteSource::~ByteSource() = default;

std::size_t ByteSource::read(std::span<char> buffer) { return decoder_->read(buffer); }
std::uint64_t ByteSource::bytes_taken() const noexcept { return decoder_->bytes_taken(); }

}  // namespace asterism
