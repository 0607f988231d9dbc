#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace asterism {

struct JsonMember;

/// A JSON value. Objects keep the order of their keys.
struct JsonValue {
  /// A number with a fraction, an exponent or more digits than fit an integer; as it was written,
  /// so that what is only carried along comes out as it went in.
  struct Real {
    double value;
    std::string text;
  };
  using Array = std::vector<JsonValue>;
  using Object = std::vector<JsonMember>;

  std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, Real, std::string, Array, Object>
      content;
};

/// A member of an object.
struct JsonMember {
  std::string key;
  JsonValue value;
};

/// Arrays and objects in one another, at most.
inline constexpr std::size_t max_json_depth = 64;
/// In a line, which can become an element of a list of a file.
inline constexpr std::size_t max_json_line_depth = max_json_depth - 2;

/// Reads one JSON text [RFC 8259], strictly: UTF-8, no byte order mark, no key twice in an object,
/// numbers that are finite doubles, at most max_json_depth levels, nothing after the value.
/// @throws InputError "file:line:column: found ...; expected ...", or the JSON pointer for a key
///         found twice
JsonValue parse_json(std::string_view text, const std::string& file_name);

/// Reads one JSON text that is a line of a file, of at most max_json_line_depth levels: `where`
/// names file and line, and only the column follows it in messages.
JsonValue parse_json_line(std::string_view line, const std::string& where);

/// A JSON string.  @throws std::invalid_argument if `text` is not UTF-8
std::string json_quoted(std::string_view text);

/// The shortest decimal that reads back as the same double.
/// @throws std::invalid_argument if it is not finite
std::string json_number(double value);

/// A decimal that reads back as the same double, with a point or an exponent.
/// @throws std::invalid_argument if it is not finite
std::string json_real(double value);

/// The version of the parser behind parse_json, "3.11.2".
std::string json_parser_version();

/// One step of a JSON pointer [RFC 6901], "/key", as shown in a message.
std::string json_pointer_step(std::string_view key);

}  // namespace asterism
