#include "io/text_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "core/error.hpp"

namespace asterism {

std::string read_text_file(const std::string& file, std::size_t max_bytes) {
  std::error_code ignored;  // what cannot be asked for cannot be opened either
  if (std::filesystem::is_directory(file, ignored)) throw InputError(file, "a directory", "a file");
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file, system_message(errno), "a file that can be read");

  std::string text;
  std::array<char, 65536> buffer;
  while (in) {
    in.read(buffer.data(), buffer.size());
    text.append(buffer.data(), static_cast<std::size_t>(in.gcount()));
    if (text.size() > max_bytes)
      throw InputError(file, "more than " + std::to_string(max_bytes) + " bytes", "a smaller file");
  }
  if (in.bad()) throw InputError(file, system_message(errno), "a file that can be read");
  return text;
}

std::string system_message(int error) {
  std::string message = std::generic_category().message(error);
  message.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(message.front())));
  return message;
}

}  // namespace asterism
