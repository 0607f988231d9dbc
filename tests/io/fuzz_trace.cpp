#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/error.hpp"
#include "io/trace_file.hpp"
#include "tests/io/same.hpp"

namespace {

/// Any text is a trace or refused; a trace is written, and read back, as it is.
void check(std::string_view text) {
  using namespace asterism;
  Trace trace;
  try {
    trace = read_trace(text, "input");
  } catch (const InputError& error) {
    const std::string_view message = error.what();
    if (message.find('\n') != std::string_view::npos) std::abort();
    if (message.find(": found ") == std::string_view::npos) std::abort();
    if (message.find("; expected ") == std::string_view::npos) std::abort();
    return;
  }
  const std::string written = trace_json(trace);
  const Trace again = read_trace(written, "written");
  if (!same(again, trace) || trace_json(again) != written) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  check({reinterpret_cast<const char*>(data), size});
  return 0;
}
