#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string_view>

#include "core/error.hpp"
#include "io/maps_file.hpp"
#include "tests/io/same.hpp"

namespace {

std::string text_of(const asterism::MapReport& report) {
  std::ostringstream out;
  asterism::write_maps(out, report);
  return out.str();
}

/// Any text is a report or refused; a report is written, and read back, as it is.
void check(std::string_view text) {
  using namespace asterism;
  MapReport report;
  try {
    report = read_maps(text, "input");
  } catch (const InputError& error) {
    const std::string_view message = error.what();
    if (message.find('\n') != std::string_view::npos) std::abort();
    if (message.find(": found ") == std::string_view::npos) std::abort();
    if (message.find("; expected ") == std::string_view::npos) std::abort();
    return;
  }
  const std::string written = text_of(report);
  const MapReport again = read_maps(written, "written");
  if (!same(again, report) || text_of(again) != written) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  check({reinterpret_cast<const char*>(data), size});
  return 0;
}
