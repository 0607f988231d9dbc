#include "io/json/expect_file.hpp"
#include "io/json/json_difference.hpp"
#include "tests/support/fuzz.hpp"

/// Any text is an expectation or refused; one is written, and read back, as it is.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asterism;
  return fuzz_text(data, size, read_expectation, [](const Expectation& expectation) {
    const std::string written = expectation_json(expectation);
    return read_expectation(written, "written") == expectation &&
           differences(parse_json(written, "written"), parse_json(written, "again")).empty();
  });
}
