#include <stdexcept>

#include "io/json/detector_lines.hpp"
#include "io/json/trace_file.hpp"
#include "tests/support/fuzz.hpp"

namespace {

using namespace asterism;

/// The visit as the only one of a trace, written and read back; nothing where it is not valid by
/// itself.
std::optional<Visit> read_back(const Visit& visit) {
  const Trace trace{"", {visit}};
  try {
    require_valid(trace);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
  return read_trace(trace_json(trace), "written").visits.front();
}

}  // namespace

/// Any line is a visit or refused; a visit can become part of a trace as it is.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string line = fuzz_input(data, size);
  const auto visit =
      accepted("command:line 1", [&] { return read_visit_line(line, "command:line 1"); });
  if (!visit) return 0;
  if (const auto again = read_back(*visit)) require(*again == *visit);
  return 0;
}
