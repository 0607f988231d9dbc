#pragma once

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace asterism {

/// The bytes that libFuzzer hands out.
inline std::string fuzz_input(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Ends the program, a finding, unless this holds.
inline void require(bool holds) {
  if (!holds) std::abort();
}

/// What `read` makes of an input; nothing if it refuses it, which must be in one line, "where:
/// found ...; expected ...", that starts with `where`.
template <class Read>
auto accepted(std::string_view where, Read read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const InputError& error) {
    const std::string_view message = error.what();
    require(message.starts_with(where));
    require(message.find('\n') == std::string_view::npos);
    require(message.find(": found ") != std::string_view::npos);
    require(message.find("; expected ") != std::string_view::npos);
    return std::nullopt;
  }
}

/// Any text is refused, or read as something of which this holds.
/// @return what a fuzz target returns
template <class Read, class Holds>
int fuzz_text(const std::uint8_t* data, std::size_t size, Read read, Holds holds) {
  const std::string text = fuzz_input(data, size);
  if (const auto value = accepted("input", [&] { return read(text, "input"); }))
    require(holds(*value));
  return 0;
}

}  // namespace asterism
