#include <sstream>

#include "io/json/checkpoint_file.hpp"
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
  return fuzz_text(data, size, read_checkpoint, [](const Checkpoint& checkpoint) {
    const std::string written = text_of(checkpoint);
    return text_of(read_checkpoint(written, "written")) == written;
  });
}
