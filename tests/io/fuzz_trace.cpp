#include "io/trace_file.hpp"
#include "tests/io/same.hpp"
#include "tests/support/fuzz.hpp"

/// Any text is a trace of either kind or refused; a trace is written, and read back, as it is.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asterism;
  const std::string text = fuzz_input(data, size);
  const auto trace = accepted("input", [&] { return read_any_trace(text, "input"); });
  if (!trace) return 0;
  std::visit(
      [](const auto& any) {
        const std::string written = trace_json(any);
        const AnyTrace again = read_any_trace(written, "written");
        require(same(again, any));
        require(std::visit([](const auto& back) { return trace_json(back); }, again) == written);
      },
      *trace);
  return 0;
}
