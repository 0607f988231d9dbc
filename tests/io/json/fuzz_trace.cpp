#include "io/json/trace_file.hpp"
#include "tests/io/json/round_trip.hpp"
#include "tests/support/fuzz.hpp"

/// Any text is a trace of either kind or refused; a trace is written, and read back, as it is.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asterism;
  return fuzz_text(data, size, read_any_trace, [](const AnyTrace& trace) {
    return is_read_back(
        trace, [](const auto& one) { return trace_json(one); }, read_any_trace);
  });
}
