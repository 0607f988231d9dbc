#include "io/trace_file.hpp"
#include "tests/io/same.hpp"
#include "tests/support/fuzz.hpp"

/// Any text is a trace or refused; a trace is written, and read back, as it is.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asterism;
  const std::string text = fuzz_input(data, size);
  const auto trace = accepted("input", [&] { return read_trace(text, "input"); });
  if (!trace) return 0;
  const std::string written = trace_json(*trace);
  const Trace again = read_trace(written, "written");
  require(same(again, *trace) && trace_json(again) == written);
  return 0;
}
