#include "io/shown.hpp"

#include <array>
#include <cctype>
#include <charconv>
#include <system_error>

namespace asterism {

std::string printable(std::string_view text, std::size_t max_size) {
  std::string result;
  for (const char c : text.substr(0, max_size)) result += (c < ' ' || c > '~') ? '?' : c;
  return text.size() > max_size ? result + "..." : result;
}

std::string shown(std::string_view text) { return '"' + printable(text, 40) + '"'; }

std::string decimal(double value) {
  std::array<char, 512> buffer{};  // a double has at most some 350 digits
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed)
          .ptr;
  return {buffer.data(), end};
}

std::string system_message(int error) {
  std::string message = std::generic_category().message(error);
  message.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(message.front())));
  return message;
}

}  // namespace asterism
