#include "io/expect_file.hpp"
#include "io/json_difference.hpp"
#include "tests/support/fuzz.hpp"

/// Any text is an expectation or refused; one is written, and read back, as it is.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asterism;
  const std::string text = fuzz_input(data, size);
  const auto expectation = accepted("input", [&] { return read_expectation(text, "input"); });
  if (!expectation) return 0;
  const std::string written = expectation_json(*expectation);
  require(read_expectation(written, "written") == *expectation);
  require(differences(parse_json(written, "written"), parse_json(written, "again")).empty());
  return 0;
}
