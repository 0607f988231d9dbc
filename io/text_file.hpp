#pragma once

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <string>

namespace asterism {

/// The bytes of a file.
/// @throws InputError "file: found ...; expected ..." if it cannot be read or has more than
///         `max_bytes`
std::string read_text_file(const std::string& file, std::size_t max_bytes);

/// The bytes of a file, unpacked if it is packed by gzip or xz; the bound holds for what is
/// unpacked.
/// @throws InputError as read_text_file, and where what is packed is damaged
std::string read_unpacked_file(const std::string& file, std::size_t max_bytes);

/// A file to read from.
/// @throws InputError "file: found ...; expected ..." if it is a directory or cannot be opened
std::unique_ptr<std::istream> opened_file(const std::string& file);

}  // namespace asterism
