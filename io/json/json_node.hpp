#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/star.hpp"
#include "io/json/json_value.hpp"

namespace asterism {

/// A parsed file, with its name for messages.
struct JsonDocument {
  std::string file_name;
  JsonValue root;
};

/// A value in a document, or the lack of one where a key is missing; asked for what it must be.
///
/// Every question throws InputError where the value is something else: "file:/json/pointer: found
/// ...; expected ...". The document must outlive it.
class JsonNode {
 public:
  explicit JsonNode(const JsonDocument& document) : JsonNode(document, &document.root) {}

  bool exists() const noexcept { return value_ != nullptr; }
  bool is_null() const noexcept;

  /// Refuses what is not this string or integer, given as JSON.
  void require(std::string_view json) const;
  /// Refuses what is not this JSON, which follows from other parts of the document.
  void require_implied(const std::string& json) const;
  bool boolean() const;
  double number() const;
  /// An integer from 0 to `largest`, written without fraction and exponent.
  std::uint64_t count(std::uint64_t largest = UINT64_MAX) const;
  const std::string& string() const;
  /// A string that tells a star.
  Star star() const;
  /// The elements of an array.
  std::vector<JsonNode> items() const;
  /// The elements of an array of that many. `expected` says what they are.
  std::vector<JsonNode> items(std::size_t size, const std::string& expected) const;
  /// The value of a key of an object. `key` must outlive the result.
  JsonNode operator[](std::string_view key) const;

  /// What `read` makes of each element of an array.
  template <class Read>
  auto list(Read read) const {
    std::vector<std::remove_cvref_t<std::invoke_result_t<Read, const JsonNode&>>> result;
    for (const JsonNode& item : items()) result.push_back(std::invoke(read, item));
    return result;
  }
  /// What `read` makes of the value, or nothing where there is none.
  template <class Read>
  auto if_exists(Read read) const {
    using Result = std::optional<std::remove_cvref_t<std::invoke_result_t<Read, const JsonNode&>>>;
    return exists() ? Result(std::invoke(read, *this)) : Result();
  }

  /// Refuses an object that is not of this format, version 1.
  void require_format(const std::string& format) const;
  enum class Extensions { refused, allowed };
  /// Refuses keys that are not listed, unless they start with x_ and these are allowed.
  void require_keys(std::initializer_list<std::string_view> keys,
                    Extensions extensions = Extensions::refused) const;
  /// The members of an object whose keys start with x_, as the text of a JSON object.
  std::string extensions() const;

  /// The value itself in a message: a scalar as it is, "array", "object", or "nothing".
  std::string found() const;
  /// The value on one line. It must exist.
  std::string text() const;
  [[noreturn]] void refuse(const std::string& expected) const { refuse(found(), expected); }
  [[noreturn]] void refuse(const std::string& found, const std::string& expected) const;

 private:
  JsonNode(const JsonDocument& document, const JsonValue* value, const JsonValue* parent = nullptr,
           std::string_view key = {})
      : document_(&document), value_(value), parent_(parent), key_(key) {}

  const JsonValue::Object& object() const;

  const JsonDocument* document_;
  const JsonValue* value_;
  const JsonValue* parent_;  ///< of a missing value, and its key
  std::string_view key_;
};

}  // namespace asterism
