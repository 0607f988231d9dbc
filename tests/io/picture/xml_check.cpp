#include "tests/io/picture/xml_check.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace asterism {
namespace {

constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
constexpr std::string_view digits = "0123456789";

/// Takes XML apart from the front. Not by a regular expression: the library's own goes deeper with
/// every character, and pictures in a page are long.
class Scanner {
 public:
  explicit Scanner(std::string_view rest) : rest_(rest) {}

  bool is_at_end() const { return rest_.empty(); }
  bool skip(std::string_view prefix) {
    if (!rest_.starts_with(prefix)) return false;
    rest_.remove_prefix(prefix.size());
    return true;
  }
  /// As long as there are characters of this set.
  std::string_view take(const std::string& set) {
    const std::string_view taken = rest_.substr(0, rest_.find_first_not_of(set));
    rest_.remove_prefix(taken.size());
    return taken;
  }
  bool space() { return !take(" \n").empty(); }
  std::string_view name() {
    return rest_.empty() || letters.find(rest_.front()) == std::string_view::npos
               ? std::string_view()
               : take(std::string(letters) + std::string(digits) + ":-");
  }
  /// Text up to one of these; escaped as it has to be.
  bool text(std::string_view until) {
    while (!rest_.empty() && until.find(rest_.front()) == std::string_view::npos) {
      constexpr std::array entities{"&amp;", "&lt;", "&gt;", "&quot;"};
      if (rest_.front() == '&') {
        if (std::ranges::none_of(entities, [&](const char* one) { return skip(one); }))
          return false;
      } else if (rest_.front() == '<') {
        return false;
      } else {
        rest_.remove_prefix(1);
      }
    }
    return true;
  }
  bool attribute() { return !name().empty() && skip("=\"") && text("\"") && skip("\""); }

 private:
  std::string_view rest_;
};

}  // namespace

bool is_well_formed(const std::string& xml) {
  Scanner scanner(xml);
  scanner.skip("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
  scanner.skip("<!DOCTYPE html>\n");
  std::vector<std::string_view> open;
  while (!scanner.is_at_end()) {
    if (!scanner.text("<>")) return false;
    if (scanner.is_at_end()) break;
    const bool is_end = scanner.skip("</");
    if (!is_end && !scanner.skip("<")) return false;
    const std::string_view name = scanner.name();
    if (name.empty()) return false;
    if (is_end) {
      if (open.empty() || open.back() != name || !scanner.skip(">")) return false;
      open.pop_back();
      continue;
    }
    while (true) {
      const bool has_space = scanner.space();
      if (scanner.skip("/>")) break;
      if (scanner.skip(">")) {
        open.push_back(name);
        break;
      }
      if (!has_space || !scanner.attribute()) return false;
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
