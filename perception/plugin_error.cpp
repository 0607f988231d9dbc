#include "perception/plugin_error.hpp"

namespace asterism {

std::string one_line(std::string_view text, std::size_t max_size) {
  std::string result;
  for (const char c : text.substr(0, max_size)) result += (c < ' ' || c > '~') ? '?' : c;
  return text.size() > max_size ? result + "..." : result;
}

PluginError plugin_error(std::string_view plugin, std::string_view cause) {
  return PluginError(std::string(plugin) + ": " + std::string(cause));
}

PluginError plugin_error(std::string_view plugin, std::string_view found,
                         std::string_view expected) {
  return plugin_error(plugin,
                      "found " + std::string(found) + "; expected " + std::string(expected));
}

}  // namespace asterism
