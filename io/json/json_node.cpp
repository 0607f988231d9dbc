#include "io/json/json_node.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/error.hpp"
#include "io/json/json_writer.hpp"
#include "io/shown.hpp"

namespace asterism {
namespace {

bool is_extension(const JsonMember& member) { return member.key.starts_with("x_"); }

/// JSON pointer to a value of the document, looked for only when there is something to complain of.
std::optional<std::string> pointer_to(const JsonValue& wanted, const JsonValue& from) {
  if (&from == &wanted) return "";
  if (const auto* array = std::get_if<JsonValue::Array>(&from.content))
    for (std::size_t i = 0; i < array->size(); ++i)
      if (const auto rest = pointer_to(wanted, (*array)[i])) return '/' + std::to_string(i) + *rest;
  if (const auto* object = std::get_if<JsonValue::Object>(&from.content))
    for (const auto& [key, value] : *object)
      if (const auto rest = pointer_to(wanted, value)) return json_pointer_step(key) + *rest;
  return std::nullopt;
}

std::string where(const JsonDocument& document, const JsonValue& value, const std::string& rest) {
  const std::string pointer = pointer_to(value, document.root).value_or("") + rest;
  return pointer.empty() ? document.file_name : document.file_name + ':' + pointer;
}

}  // namespace

bool JsonNode::is_null() const noexcept {
  return exists() && std::holds_alternative<std::nullptr_t>(value_->content);
}

void JsonNode::require(std::string_view json) const {
  if (!exists() || text() != json) refuse(std::string(json));
}

void JsonNode::require_implied(const std::string& json) const {
  constexpr std::size_t max_shown = 80;
  if (!exists() || text() != json)
    refuse(exists() ? printable(text(), max_shown) : found(), printable(json, max_shown));
}

bool JsonNode::boolean() const {
  const bool* value = exists() ? std::get_if<bool>(&value_->content) : nullptr;
  if (!value) refuse("true or false");
  return *value;
}

double JsonNode::number() const {
  if (exists()) {
    if (const auto* value = std::get_if<JsonValue::Real>(&value_->content)) return value->value;
    if (const auto* value = std::get_if<std::int64_t>(&value_->content))
      return static_cast<double>(*value);
    if (const auto* value = std::get_if<std::uint64_t>(&value_->content))
      return static_cast<double>(*value);
  }
  refuse("a number");
}

std::uint64_t JsonNode::count(std::uint64_t largest) const {
  const auto* value = exists() ? std::get_if<std::uint64_t>(&value_->content) : nullptr;
  if (!value || *value > largest)
    refuse("an integer from 0 to " +
           (largest == UINT64_MAX ? "2^64 - 1" : std::to_string(largest)));
  return *value;
}

const std::string& JsonNode::string() const {
  const auto* value = exists() ? std::get_if<std::string>(&value_->content) : nullptr;
  if (!value) refuse("a string");
  return *value;
}

Star JsonNode::star() const {
  const std::string& text = string();
  try {
    return Star::parse(text);
  } catch (const std::invalid_argument& error) {
    throw InputError(where(*document_, *value_, "") + ": " + error.what());
  }
}

std::vector<JsonNode> JsonNode::items() const {
  const auto* array = exists() ? std::get_if<JsonValue::Array>(&value_->content) : nullptr;
  if (!array) refuse("an array");
  std::vector<JsonNode> result;
  result.reserve(array->size());
  for (const JsonValue& value : *array) result.push_back(JsonNode(*document_, &value));
  return result;
}

std::vector<JsonNode> JsonNode::items(std::size_t size, const std::string& expected) const {
  auto result = items();
  if (result.size() != size)
    refuse("an array of " + std::to_string(result.size()), std::to_string(size) + ' ' + expected);
  return result;
}

const JsonValue::Object& JsonNode::object() const {
  const auto* object = exists() ? std::get_if<JsonValue::Object>(&value_->content) : nullptr;
  if (!object) refuse("an object");
  return *object;
}

JsonNode JsonNode::operator[](std::string_view key) const {
  const auto& members = object();
  const auto member = std::ranges::find(members, key, &JsonMember::key);
  if (member == members.end()) return JsonNode(*document_, nullptr, value_, key);
  return JsonNode(*document_, &member->value);
}

void JsonNode::require_format(const std::string& format) const {
  (*this)["format"].require('"' + format + '"');
  (*this)["version"].require("1");
}

void JsonNode::require_keys(std::initializer_list<std::string_view> keys,
                            Extensions extensions) const {
  for (const JsonMember& member : object()) {
    if (std::ranges::find(keys, member.key) != keys.end()) continue;
    if (extensions == Extensions::allowed && is_extension(member)) continue;
    std::string expected = "one of";
    for (const std::string_view key : keys) expected += ' ' + std::string(key);
    if (extensions == Extensions::allowed) expected += ", or a key that starts with x_";
    throw InputError(where(*document_, member.value, ""), "an unknown key", expected);
  }
}

std::string JsonNode::extensions() const {
  JsonValue::Object kept;
  std::ranges::copy_if(object(), std::back_inserter(kept), is_extension);
  return json_of(JsonValue{std::move(kept)});
}

std::string JsonNode::found() const {
  if (!exists()) return "nothing";
  if (std::holds_alternative<JsonValue::Array>(value_->content)) return "array";
  if (std::holds_alternative<JsonValue::Object>(value_->content)) return "object";
  if (const auto* value = std::get_if<std::string>(&value_->content)) return shown(*value);
  return printable(text(), 40);
}

std::string JsonNode::text() const { return json_of(*value_); }

void JsonNode::refuse(const std::string& found, const std::string& expected) const {
  throw InputError(exists() ? where(*document_, *value_, "")
                            : where(*document_, *parent_, json_pointer_step(key_)),
                   found, expected);
}

}  // namespace asterism
