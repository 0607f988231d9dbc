#include <sstream>

#include "io/json/maps_file.hpp"
#include "tests/io/json/round_trip.hpp"
#include "tests/support/fuzz.hpp"

namespace {

template <class Report>
std::string text_of(const Report& report) {
  std::ostringstream out;
  asterism::write_maps(out, report);
  return out.str();
}

}  // namespace

/// Any text is a report of either kind or refused; a report is written, and read back, as it is.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asterism;
  return fuzz_text(data, size, read_any_maps, [](const AnyReport& report) {
    return is_read_back(
        report, [](const auto& one) { return text_of(one); }, read_any_maps);
  });
}
