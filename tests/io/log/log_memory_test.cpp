#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <istream>
#include <new>
#include <streambuf>

#include "io/log/carmen_log.hpp"
#include "tests/support/catch.hpp"

namespace {

std::size_t now_bytes = 0;
std::size_t peak_bytes = 0;

}  // namespace

// Counts what this program allocates; so it has but one test. Not inlined, where g++ sees malloc()
// meet delete.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  void* const memory = std::malloc(size);
  if (!memory) return nullptr;
  now_bytes += malloc_usable_size(memory);
  peak_bytes = std::max(peak_bytes, now_bytes);
  return memory;
}
void* operator new(std::size_t size) {
  void* const memory = operator new(size, std::nothrow);
  if (!memory) throw std::bad_alloc();
  return memory;
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  if (memory) now_bytes -= malloc_usable_size(memory);
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept { operator delete(memory); }

namespace asterism {
namespace {

/// One line, so many times.
class Repeated : public std::streambuf {
 public:
  Repeated(std::string line, long long times) : line_(std::move(line)), left_(times) {}

 private:
  int_type underflow() override {
    if (left_-- <= 0) return traits_type::eof();
    setg(line_.data(), line_.data(), line_.data() + line_.size());
    return traits_type::to_int_type(line_.front());
  }

  std::string line_;
  long long left_;
};

class RepeatedLine : public std::istream {
 public:
  RepeatedLine(const std::string& line, long long times)
      : std::istream(nullptr), buffer_(line, times) {
    rdbuf(&buffer_);
  }

 private:
  Repeated buffer_;
};

std::size_t peak_of(const std::string& line, long long times) {
  const std::size_t before = now_bytes;
  peak_bytes = now_bytes;
  LogReader reader(std::make_unique<RepeatedLine>(line, times), "log");
  long long scans = 0;
  while (reader.next()) ++scans;
  CHECK(scans == times);
  return peak_bytes - before;
}

}  // namespace

TEST_CASE("a longer log takes no more memory", "[io]") {
  std::string line = "FLASER 180";
  for (int i = 0; i < 180; ++i) line += " 12.345";
  line += " 0 0 0 1 2 0.5 10.5 host 7\n";
  const std::size_t peak = peak_of(line, 1000);
  CHECK(peak < 1 << 20);
  CHECK(peak_of(line, 20'000) <= peak);
}

}  // namespace asterism
