#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/id.hpp"
#include "io/json/json_value.hpp"

namespace asterism {

/// Writes a JSON text from front to back: where commas, colons, spaces and line breaks go, how
/// numbers and strings are spelt. Lines are indented by two spaces a level.
///
///   JsonWriter json;
///   json.object([&] {
///     json.member("visits", 3);
///     json.line().key("maps").lines(maps, write_map);
///   });
///   return json.take();
///
/// What is written must be of one value; each member of an object begins with its key. One thread
/// at a time.
class JsonWriter {
 public:
  enum class Style {
    spaced,  ///< { "a": 1, "b": [2, 3] }
    compact  ///< {"a":1.0,"b":[2,3]}, a real number with a point or an exponent. A key that begins
             ///< a line has a space before its value even so.
  };
  explicit JsonWriter(Style style = Style::spaced) : style_(style) {}

  /// What comes next begins a line: a member, an element, or the bracket that closes.
  JsonWriter& line() { return is_line_ = true, *this; }
  /// The brackets that open next have no space inside: {"a": 1}.
  JsonWriter& tight() { return is_tight_ = true, *this; }

  /// The key of the next value.
  JsonWriter& key(std::string_view key);
  /// A key and its value, and more of them.
  template <class Value, class... More>
  void member(std::string_view key, const Value& value, const More&... more) {
    this->key(key).value(value);
    if constexpr (sizeof...(More) > 0) member(more...);
  }
  /// A key and its value, if there is one.
  template <class Value>
  void member_if(std::string_view key, const Value& value) {
    if (value) member(key, *value);
  }

  /// A truth value, a number, a string, an id's number, what has a text(), what is optional or
  /// null, a pair or a list of these, and what there is a function write_json(JsonWriter&, value)
  /// for.
  /// @throws std::invalid_argument if a number is not finite or a string is not UTF-8
  template <class Value>
  void value(const Value& value);
  /// A value as it was read; compact, its real numbers as all others.
  void value(const JsonValue& value);
  void null() { put("null"); }

  /// An object. `body` writes its members.
  template <class Body>
  void object(Body body) {
    open('{');
    body();
    close('}');
  }
  /// An object of these members.
  template <class Value, class... More>
  void object(std::string_view key, const Value& value, const More&... more) {
    object([&] { member(key, value, more...); });
  }
  /// An array. `body` writes its elements.
  template <class Body>
  void array(Body body) {
    open('[');
    body();
    close(']');
  }
  /// An array on one line.
  /// @param write  given this writer and an element
  template <class Range, class Write>
  void list(const Range& elements, Write write);
  template <class Range>
  void list(const Range& elements) {
    list(elements, [](JsonWriter& json, const auto& element) { json.value(element); });
  }
  /// An array of an element a line.
  /// @param write  given this writer and an element
  template <class Range, class Write>
  void lines(const Range& elements, Write write);
  template <class Range>
  void lines(const Range& elements) {
    lines(elements, [](JsonWriter& json, const auto& element) { json.value(element); });
  }

  /// Parts with what was written so far; the rest can follow.
  std::string take() { return std::exchange(text_, {}); }

 private:
  struct Open {
    bool is_wide;  ///< spaces inside its brackets
    bool is_empty = true;
  };

  void open(char bracket);
  void close(char bracket);
  void begin_line(std::size_t level) { text_.append("\n").append(2 * level, ' '); }
  void separate();
  void put(std::string_view token);

  Style style_;
  std::string text_ = {};
  std::vector<Open> open_ = {};
  bool is_line_ = false;
  bool is_tight_ = false;
  bool has_key_ = false;
};

/// What `write` writes to a writer of its own.
template <class Write>
std::string json_written(Write write, JsonWriter::Style style = JsonWriter::Style::spaced) {
  JsonWriter json(style);
  write(json);
  return json.take();
}

/// A value on one line.
template <class Value>
std::string json_of(const Value& value) {
  return json_written([&](JsonWriter& json) { json.value(value); });
}

/// The content of a file: an object that tells its format and version 1, then what `body` writes.
template <class Body>
std::string json_file(std::string_view format, Body body,
                      JsonWriter::Style style = JsonWriter::Style::spaced) {
  const auto write = [&](JsonWriter& json) {
    json.object([&] {
      json.member("format", format, "version", 1);
      body(json);
    });
  };
  return json_written(write, style) + '\n';
}

// Implementation.

template <class Value>
void JsonWriter::value(const Value& value) {
  if constexpr (std::same_as<Value, bool>)
    put(value ? "true" : "false");
  else if constexpr (std::integral<Value>)
    put(std::to_string(value));
  else if constexpr (std::floating_point<Value>)
    put(style_ == Style::compact ? json_real(value) : json_number(value));
  else if constexpr (std::convertible_to<Value, std::string_view>)
    put(json_quoted(value));
  else if constexpr (requires { std::string_view(value.text()); })
    put(json_quoted(value.text()));
  else if constexpr (requires { Value(value.index()); })
    put(std::to_string(value.index()));
  else if constexpr (requires { write_json(*this, value); })
    write_json(*this, value);
  else if constexpr (requires { value.first, value.second; })
    tight().array([&] {
      this->value(value.first);
      this->value(value.second);
    });
  else if constexpr (requires { value.has_value(); })
    value ? this->value(*value) : null();
  else
    list(value);
}

template <class Range, class Write>
void JsonWriter::list(const Range& elements, Write write) {
  tight().array([&] {
    for (const auto& element : elements) write(*this, element);
  });
}

template <class Range, class Write>
void JsonWriter::lines(const Range& elements, Write write) {
  array([&] {
    for (const auto& element : elements) write(line(), element);
  });
}

}  // namespace asterism
