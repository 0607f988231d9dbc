#include "tests/io_svg/xml_check.hpp"

#include <regex>
#include <vector>

namespace asterism {

bool is_well_formed(const std::string& xml) {
  static const std::regex token(
      R"(<\?xml[^<>]*\?>|<(/?)([a-z]+)((?:\s+[a-zA-Z0-9:-]+="[^"<&]*")*)\s*(/?)>|(?:[^<>&]|&(?:amp|lt|gt|quot);))",
      std::regex::optimize);
  std::vector<std::string> open;
  auto at = xml.cbegin();
  for (std::smatch match; at != xml.cend(); at = match.suffix().first) {
    if (!std::regex_search(at, xml.cend(), match, token, std::regex_constants::match_continuous))
      return false;
    if (!match[2].matched || match[4].length() > 0) continue;
    if (match[1].length() == 0) {
      open.push_back(match[2]);
    } else {
      if (open.empty() || open.back() != match[2]) return false;
      open.pop_back();
    }
  }
  return open.empty();
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace asterism
