#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/error.hpp"
#include "io/detector_lines.hpp"
#include "io/trace_file.hpp"

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

/// Any line is a visit or refused; a visit can become part of a trace as it is.
void check(std::string_view line) {
  Visit visit{.star = Star::parse("a+1 a-1")};
  try {
    visit = read_visit_line(line, "command:line 1");
  } catch (const InputError& error) {
    const std::string_view message = error.what();
    if (message.find('\n') != std::string_view::npos) std::abort();
    if (!message.starts_with("command:line 1")) std::abort();
    if (message.find(": found ") == std::string_view::npos) std::abort();
    if (message.find("; expected ") == std::string_view::npos) std::abort();
    return;
  }
  if (const auto again = read_back(visit); again && *again != visit) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  check({reinterpret_cast<const char*>(data), size});
  return 0;
}
