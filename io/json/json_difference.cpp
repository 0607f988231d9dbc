#include "io/json/json_difference.hpp"

#include <algorithm>

#include "io/json/json_writer.hpp"
#include "io/shown.hpp"

namespace asterism {
namespace {

constexpr std::size_t longest_shown = 160;

/// Lists as short as this are shown whole.
constexpr std::size_t short_list = 32;

bool is_simple(const JsonValue& value) {
  return !std::holds_alternative<JsonValue::Array>(value.content) &&
         !std::holds_alternative<JsonValue::Object>(value.content);
}

std::string shown(const JsonValue* value) {
  return value ? printable(json_of(*value), longest_shown) : "nothing";
}

const JsonValue* find(const JsonValue::Object& object, const std::string& key) {
  const auto member = std::ranges::find(object, key, &JsonMember::key);
  return member == object.end() ? nullptr : &member->value;
}

class Comparison {
 public:
  /// Either may be missing.
  void compare(const std::string& pointer, const JsonValue* found, const JsonValue* expected) {
    if (found && expected) {
      const auto* object = std::get_if<JsonValue::Object>(&found->content);
      const auto* wanted = std::get_if<JsonValue::Object>(&expected->content);
      if (object && wanted) return compare(pointer, *object, *wanted);
      const auto* array = std::get_if<JsonValue::Array>(&found->content);
      const auto* list = std::get_if<JsonValue::Array>(&expected->content);
      if (array && list && !are_short(*array, *list)) return compare(pointer, *array, *list);
      if (json_of(*found) == json_of(*expected)) return;
    }
    lines_.push_back(pointer + ": found " + shown(found) + "; expected " + shown(expected));
  }
  std::vector<std::string> lines() && { return std::move(lines_); }

 private:
  static bool are_short(const JsonValue::Array& one, const JsonValue::Array& other) {
    return std::max(one.size(), other.size()) <= short_list &&
           std::ranges::all_of(one, is_simple) && std::ranges::all_of(other, is_simple);
  }

  void compare(const std::string& pointer, const JsonValue::Object& found,
               const JsonValue::Object& expected) {
    for (const auto& [key, value] : found)
      compare(pointer + json_pointer_step(key), &value, find(expected, key));
    for (const auto& [key, value] : expected)
      if (find(found, key) == nullptr) compare(pointer + json_pointer_step(key), nullptr, &value);
  }

  void compare(const std::string& pointer, const JsonValue::Array& found,
               const JsonValue::Array& expected) {
    for (std::size_t i = 0; i < std::max(found.size(), expected.size()); ++i)
      compare(pointer + '/' + std::to_string(i), i < found.size() ? &found[i] : nullptr,
              i < expected.size() ? &expected[i] : nullptr);
  }

  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> differences(const JsonValue& found, const JsonValue& expected) {
  Comparison comparison;
  comparison.compare("", &found, &expected);
  return std::move(comparison).lines();
}

}  // namespace asterism
