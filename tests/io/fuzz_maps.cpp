#include <sstream>

#include "io/maps_file.hpp"
#include "tests/io/same.hpp"
#include "tests/support/fuzz.hpp"

namespace {

std::string text_of(const asterism::MapReport& report) {
  std::ostringstream out;
  asterism::write_maps(out, report);
  return out.str();
}

}  // namespace

/// Any text is a report or refused; a report is written, and read back, as it is.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asterism;
  const std::string text = fuzz_input(data, size);
  const auto report = accepted("input", [&] { return read_maps(text, "input"); });
  if (!report) return 0;
  const std::string written = text_of(*report);
  const MapReport again = read_maps(written, "written");
  require(same(again, *report) && text_of(again) == written);
  return 0;
}
