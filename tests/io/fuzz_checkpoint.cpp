#include <sstream>

#include "io/checkpoint_file.hpp"
#include "tests/support/fuzz.hpp"

namespace {

std::string text_of(const asterism::Checkpoint& checkpoint) {
  std::ostringstream out;
  write_checkpoint(out, checkpoint);
  return out.str();
}

}  // namespace

/// Any text is a checkpoint or refused; one is written, and read back, as it is.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asterism;
  const std::string text = fuzz_input(data, size);
  const auto checkpoint = accepted("input", [&] { return read_checkpoint(text, "input"); });
  if (!checkpoint) return 0;
  const std::string written = text_of(*checkpoint);
  require(text_of(read_checkpoint(written, "written")) == written);
  return 0;
}
