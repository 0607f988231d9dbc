#pragma once

#include <string>
#include <string_view>

#include "core/error.hpp"

namespace asterism {

/// Foreign text as part of a message: printable ASCII, '?' for any other byte, cut if long.
std::string one_line(std::string_view text, std::size_t max_size = 300);

/// The error with the message "plug-in: cause".
PluginError plugin_error(std::string_view plugin, std::string_view cause);
/// The error with the message "plug-in: found ...; expected ...".
PluginError plugin_error(std::string_view plugin, std::string_view found,
                         std::string_view expected);

}  // namespace asterism
