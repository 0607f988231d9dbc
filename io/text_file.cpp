#include "io/text_file.hpp"

#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "io/byte_source.hpp"
#include "io/shown.hpp"

namespace asterism {

namespace {

void require_at_most(std::size_t bytes, std::size_t max_bytes, const std::string& file) {
  if (bytes > max_bytes)
    throw InputError(file, "more than " + std::to_string(max_bytes) + " bytes", "a smaller file");
}

}  // namespace

std::unique_ptr<std::istream> opened_file(const std::string& file) {
  std::error_code ignored;  // what cannot be asked for cannot be opened either
  if (std::filesystem::is_directory(file, ignored)) throw InputError(file, "a directory", "a file");
  errno = 0;
  auto in = std::make_unique<std::ifstream>(file, std::ios::binary);
  if (!*in) throw InputError(file, system_message(errno), "a file that can be read");
  return in;
}

std::string read_text_file(const std::string& file, std::size_t max_bytes) {
  const auto in = opened_file(file);
  std::string text;
  std::array<char, 65536> buffer;
  while (*in) {
    in->read(buffer.data(), buffer.size());
    text.append(buffer.data(), static_cast<std::size_t>(in->gcount()));
    require_at_most(text.size(), max_bytes, file);
  }
  if (in->bad()) throw InputError(file, system_message(errno), "a file that can be read");
  return text;
}

std::string read_unpacked_file(const std::string& file, std::size_t max_bytes) {
  try {
    ByteSource source(opened_file(file));
    std::string text;
    std::array<char, 65536> buffer;
    while (const std::size_t size = source.read(buffer)) {
      text.append(buffer.data(), size);
      require_at_most(text.size(), max_bytes, file);
    }
    return text;
  } catch (const CompressionError& error) {
    throw InputError(file, error.what(), error.expected);
  }
}

}  // namespace asterism
