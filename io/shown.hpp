#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace asterism {

/// Text from a file as shown in a message: printable ASCII, '?' for any other byte, cut if long.
std::string printable(std::string_view text, std::size_t max_size);

/// Text from a file as shown in a message: printable() of 40 bytes, in quotes.
std::string shown(std::string_view text);

/// The shortest decimal, without exponent, that reads back as the same double.  @pre finite
std::string decimal(double value);

/// What the system says of an error number (errno), as part of a message.
std::string system_message(int error);

}  // namespace asterism
