#include <sstream>

#include "io/ssh_maps_file.hpp"
#include "tests/io/same.hpp"
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
  const std::string text = fuzz_input(data, size);
  const auto report = accepted("input", [&] { return read_any_maps(text, "input"); });
  if (!report) return 0;
  std::visit(
      [](const auto& any) {
        const std::string written = text_of(any);
        const AnyReport again = read_any_maps(written, "written");
        require(same(again, any));
        require(std::visit([](const auto& back) { return text_of(back); }, again) == written);
      },
      *report);
  return 0;
}
