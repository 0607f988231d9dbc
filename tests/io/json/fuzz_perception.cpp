#include "io/json/perception_file.hpp"
#include "tests/support/fuzz.hpp"

/// Any text is refused, or is what was perceived; that is written, and read back, as it is.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asterism;
  return fuzz_text(data, size, read_perception, [](const PerceptionRecord& record) {
    return read_perception(perception_json(record), "written") == record;
  });
}
