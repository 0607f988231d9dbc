#pragma once

#include <cstddef>
#include <string>

namespace asterism {

/// The bytes of a file.
/// @throws InputError "file: found ...; expected ..." if it cannot be read or has more than
///         `max_bytes`
std::string read_text_file(const std::string& file, std::size_t max_bytes);

/// What the system says of an error number (errno), as part of a message.
std::string system_message(int error);

}  // namespace asterism
