#include "io/grid/map_yaml.hpp"

#include <algorithm>
#include <charconv>
#include <functional>
#include <istream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "core/error.hpp"
#include "io/line_words.hpp"
#include "io/shown.hpp"

namespace asterism {
namespace {

constexpr std::string_view blanks = " \t\r";
// What would make a name without quotes something else to YAML.
constexpr std::string_view indicators = "-?:,[]{}#&*!|>'\"%@`";
constexpr double max_resolution_m = 1000;

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

bool has_control(std::string_view text) {
  return std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
}

/// One line, "key: value".
class YamlLine {
 public:
  YamlLine(std::string_view text, const LineReader& lines) : lines_(&lines) {
    const auto colon = text.find(':');
    const bool is_pair =
        colon != std::string_view::npos &&
        (colon + 1 == text.size() || blanks.find(text[colon + 1]) != std::string_view::npos);
    if (!is_pair || blanks.find(text.front()) != std::string_view::npos)
      refuse(text, "a key without indentation, a colon and a value");
    key_ = text.substr(0, colon);
    value_ = trimmed(text.substr(colon + 1));
  }

  const std::string& key() const noexcept { return key_; }

  std::string name() const {
    const std::string expected = key_ + ", a name, with quotes if it is an odd one";
    if (value_.starts_with('"') || value_.starts_with('\'')) {
      const char quote = value_.front();
      const auto end = value_.find(quote, 1);
      const std::string name = value_.substr(1, end == std::string::npos ? end : end - 1);
      if (end == std::string::npos || !without_comment(value_.substr(end + 1)).empty() ||
          name.empty() || name.find('\\') != std::string::npos || has_control(name))
        refuse(value_, expected);
      return name;
    }
    const std::string_view name = without_comment(value_);
    if (name.empty() || indicators.find(name.front()) != std::string_view::npos ||
        name.find(": ") != std::string_view::npos || name.ends_with(':') || has_control(name))
      refuse(name, expected);
    return std::string(name);
  }

  double number(Bounds bounds, const std::string& expected) const {
    return number_of(without_comment(value_), bounds, expected);
  }

  Pose2 pose() const {
    std::string_view list = without_comment(value_);
    const std::string expected = key_ + ", [x, y, yaw]";
    if (!list.starts_with('[') || !list.ends_with(']') || std::ranges::count(list, ',') != 2)
      refuse(list, expected);
    list = list.substr(1, list.size() - 2);
    const auto next = [&](Bounds bounds) {
      const auto comma = std::min(list.find(','), list.size());
      const double value = number_of(trimmed(list.substr(0, comma)), bounds, expected);
      list.remove_prefix(std::min(comma + 1, list.size()));
      return value;
    };
    const double x_m = next(position_bounds_m);
    const double y_m = next(position_bounds_m);
    return {x_m, y_m, wrapped(next(heading_bounds_rad))};
  }

  bool truth() const {
    const std::string_view word = without_comment(value_);
    if (word == "0" || word == "false") return false;
    if (word == "1" || word == "true") return true;
    refuse(word, key_ + ", 0 or 1");
  }

  [[noreturn]] void refuse(std::string_view found, const std::string& expected) const {
    throw InputError(lines_->where(), found.empty() ? "nothing" : shown(found), expected);
  }

 private:
  /// A comment begins with # at the start or after a blank.
  static std::string_view without_comment(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == '#' && (i == 0 || blanks.find(text[i - 1]) != std::string_view::npos))
        return trimmed(text.substr(0, i));
    return trimmed(text);
  }

  double number_of(std::string_view word, Bounds bounds, const std::string& expected) const {
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_number = error == std::errc() && end == word.data() + word.size();
    if (!is_number || !bounds.contain(value)) refuse(word, expected);
    return value;
  }

  const LineReader* lines_;
  std::string key_;
  std::string value_;
};

const std::map<std::string, std::function<void(MapYaml&, const YamlLine&)>, std::less<>> keys{
    {"image", [](MapYaml& yaml, const YamlLine& line) { yaml.image = line.name(); }},
    {"resolution",
     [](MapYaml& yaml, const YamlLine& line) {
       yaml.resolution_m =
           line.number({above_0.low, max_resolution_m}, "resolution, metres above 0, at most 1000");
     }},
    {"origin", [](MapYaml& yaml, const YamlLine& line) { yaml.map_from_grid = line.pose(); }},
    {"negate", [](MapYaml& yaml, const YamlLine& line) { yaml.is_negated = line.truth(); }},
    {"occupied_thresh",
     [](MapYaml& yaml, const YamlLine& line) {
       yaml.occupied_threshold = line.number({0, 1}, "occupied_thresh, a number from 0 to 1");
     }},
    {"free_thresh",
     [](MapYaml& yaml, const YamlLine& line) {
       yaml.free_threshold = line.number({0, 1}, "free_thresh, a number from 0 to 1");
     }},
    {"mode",
     [](MapYaml&, const YamlLine& line) {
       if (const auto mode = line.name(); mode != "trinary") line.refuse(mode, "mode trinary");
     }},
};

}  // namespace

MapYaml read_map_yaml(std::unique_ptr<std::istream> in, const std::string& name) {
  LineReader lines(std::move(in), name);
  MapYaml yaml;
  std::set<std::string, std::less<>> seen;
  while (const auto text = lines.next()) {
    const auto first = trimmed(*text);
    if (first.empty() || first.starts_with('#') || (seen.empty() && first == "---")) continue;
    const YamlLine line(*text, lines);
    const auto key = keys.find(line.key());
    if (key == keys.end())
      line.refuse(line.key(),
                  "one of image resolution origin negate occupied_thresh free_thresh mode");
    if (!seen.insert(line.key()).second) line.refuse(line.key(), "each key once");
    key->second(yaml, line);
  }
  for (const auto& [key, read] : keys)
    if (key != "mode" && !seen.contains(key)) throw InputError(name, "no key " + key, "one");
  if (!(yaml.free_threshold < yaml.occupied_threshold))
    throw InputError(name, "free_thresh " + decimal(yaml.free_threshold),
                     "less than occupied_thresh, " + decimal(yaml.occupied_threshold));
  return yaml;
}

std::string map_yaml(const MapYaml& yaml) {
  require_writable(yaml.map_from_grid, "map");
  if (!(yaml.resolution_m > 0 && yaml.resolution_m <= max_resolution_m))
    throw std::invalid_argument("map: found no resolution; expected metres above 0");
  const bool is_plain = std::ranges::all_of(yaml.image, [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '.' ||
           c == '_';
  });
  std::string text = "image: " + (is_plain ? yaml.image : '"' + yaml.image + '"');
  text += "\nmode: trinary\nresolution: " + decimal(yaml.resolution_m);
  text += "\norigin: [" + decimal(yaml.map_from_grid.x_m) + ", " + decimal(yaml.map_from_grid.y_m) +
          ", " + decimal(yaml.map_from_grid.heading_rad) + ']';
  text += std::string("\nnegate: ") + (yaml.is_negated ? '1' : '0');
  text += "\noccupied_thresh: " + decimal(yaml.occupied_threshold);
  text += "\nfree_thresh: " + decimal(yaml.free_threshold) + '\n';
  try {
    // The reader is the judge of what may be written.
    read_map_yaml(std::make_unique<std::istringstream>(text), "map");
  } catch (const InputError& error) {
    throw std::invalid_argument(error.what());
  }
  return text;
}

}  // namespace asterism
