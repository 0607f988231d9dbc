#include "io/json/json_value.hpp"
#include "io/shown.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "core/error.hpp"

namespace asterism {
namespace {

using nlohmann::json;

constexpr std::size_t max_shown = 40;  // bytes of one string

/// Builds a JsonValue from the events of nlohmann's parser, which keeps to RFC 8259 and UTF-8.
class Builder : public nlohmann::json_sax<json> {
 public:
  Builder(std::string_view text, const std::string& file_name, bool is_line)
      : text_(text), file_(file_name), is_line_(is_line) {}

  JsonValue take() { return std::move(root_); }

  bool null() override { return add({nullptr}); }
  bool boolean(bool value) override { return add({value}); }
  bool number_integer(number_integer_t value) override {
    if (value == 0) return add({JsonValue::Real{-0.0, "-0"}});  // 0 itself comes as unsigned
    return add({std::int64_t{value}});
  }
  bool number_unsigned(number_unsigned_t value) override { return add({std::uint64_t{value}}); }
  bool number_float(number_float_t value, const string_t& text) override {
    return add({JsonValue::Real{value, text}});
  }
  bool string(string_t& value) override { return add({std::move(value)}); }
  bool binary(binary_t&) override { return false; }  // no part of JSON text

  bool start_object(std::size_t) override { return open({JsonValue::Object{}}); }
  bool start_array(std::size_t) override { return open({JsonValue::Array{}}); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& key) override {
    if (!open_.back().keys.insert(key).second)
      throw InputError(file_ + ":" + pointer() + json_pointer_step(key), "this key again",
                       "each key once");
    std::get<JsonValue::Object>(open_.back().value->content).push_back({std::move(key), {}});
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception& error) override {
    const std::string where = file_ + ":" + place_in_text(position);
    if (dynamic_cast<const json::out_of_range*>(&error))
      throw InputError(where, printable(token, max_shown), "a number that a double can hold");
    // "[...] parse error at ...: syntax error while parsing value - unexpected X; expected Y" or
    // "... - invalid literal; last read: 'X'"
    std::string found = error.what();
    if (const auto dash = found.find(" - "); dash != std::string::npos) found.erase(0, dash + 3);
    std::string expected = "valid JSON";
    if (const auto split = found.find("; expected "); split != std::string::npos)
      expected = found.substr(split + 11);
    found.erase(std::min(found.find("; "), found.size()));
    if (found.starts_with("unexpected ")) found.erase(0, 11);
    throw InputError(where, found, expected);
  }

  /// Line, unless the text is one, and column of the byte read last, `position` bytes into the
  /// text; all from 1.
  std::string place_in_text(std::size_t position) const {
    const std::string_view before = text_.substr(0, position > 0 ? position - 1 : 0);
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
    return (is_line_ ? "" : std::to_string(lines + 1) + ':') +
           std::to_string(before.size() - line_begin + 1);
  }

 private:
  struct Open {
    JsonValue* value;
    std::set<std::string> keys;
  };

  JsonValue& place(JsonValue&& value) {
    if (open_.empty()) return root_ = std::move(value);
    auto& content = open_.back().value->content;
    if (auto* array = std::get_if<JsonValue::Array>(&content))
      return array->emplace_back(std::move(value));
    return std::get<JsonValue::Object>(content).back().value = std::move(value);
  }

  bool add(JsonValue&& value) {
    place(std::move(value));
    return true;
  }

  // A container stays where it is while it is open: only the innermost one grows.
  bool open(JsonValue&& value) {
    const std::size_t max_depth = is_line_ ? max_json_line_depth : max_json_depth;
    if (open_.size() == max_depth)
      throw InputError(file_,
                       "nesting of arrays and objects deeper than " + std::to_string(max_depth),
                       "fewer levels");
    open_.push_back({&place(std::move(value)), {}});
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  std::string pointer() const {
    std::string result;
    for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
      const auto& content = open_[i].value->content;
      if (const auto* array = std::get_if<JsonValue::Array>(&content))
        result += '/' + std::to_string(array->size() - 1);
      else
        result += json_pointer_step(std::get<JsonValue::Object>(content).back().key);
    }
    return result;
  }

  std::string_view text_;
  std::string file_;
  bool is_line_;
  JsonValue root_;
  std::vector<Open> open_;
};

JsonValue parse(std::string_view text, const std::string& file_name, bool is_line) {
  Builder builder(text, file_name, is_line);
  if (text.starts_with("\xEF\xBB\xBF"))
    throw InputError(file_name + ':' + builder.place_in_text(1), "a byte order mark",
                     "JSON in UTF-8 without one");
  // The parser would take it for the end of the text.
  if (const auto nul = text.find('\0'); nul != std::string_view::npos)
    throw InputError(file_name + ':' + builder.place_in_text(nul + 1), "a NUL byte",
                     "JSON in UTF-8");
  json::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
}

void require_finite(double value) {
  if (!std::isfinite(value)) throw std::invalid_argument("found no finite number; expected one");
}

}  // namespace

JsonValue parse_json(std::string_view text, const std::string& file_name) {
  return parse(text, file_name, false);
}

JsonValue parse_json_line(std::string_view line, const std::string& where) {
  return parse(line, where, true);
}

std::string json_quoted(std::string_view text) {
  const auto is_plain = [](char c) { return c >= ' ' && c < '\x7f' && c != '"' && c != '\\'; };
  if (std::ranges::all_of(text, is_plain)) return '"' + std::string(text) + '"';
  try {
    return json(text).dump();
  } catch (const json::type_error&) {
    throw std::invalid_argument("found " + shown(text) + "; expected UTF-8");
  }
}

std::string json_number(double value) {
  require_finite(value);
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

std::string json_real(double value) {
  require_finite(value);
  return json(value).dump();
}

std::string json_parser_version() {
  return std::to_string(NLOHMANN_JSON_VERSION_MAJOR) + '.' +
         std::to_string(NLOHMANN_JSON_VERSION_MINOR) + '.' +
         std::to_string(NLOHMANN_JSON_VERSION_PATCH);
}

std::string json_pointer_step(std::string_view key) {
  std::string result = "/";
  for (const char c : printable(key, max_shown)) {
    if (c == '~')
      result += "~0";
    else if (c == '/')
      result += "~1";
    else
      result += c;
  }
  return result;
}

}  // namespace asterism
