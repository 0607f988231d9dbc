#include "io/json/json_writer.hpp"

#include <type_traits>

namespace asterism {

JsonWriter& JsonWriter::key(std::string_view key) {
  const bool is_line = is_line_;
  put(json_quoted(key));
  text_ += style_ == Style::compact && !is_line ? ":" : ": ";
  has_key_ = true;
  return *this;
}

void JsonWriter::value(const JsonValue& value) {
  std::visit(
      [this](const auto& content) {
        using Content = std::remove_cvref_t<decltype(content)>;
        if constexpr (std::same_as<Content, std::nullptr_t>)
          null();
        else if constexpr (std::same_as<Content, JsonValue::Real>)
          put(style_ == Style::compact ? json_real(content.value) : content.text);
        else if constexpr (std::same_as<Content, JsonValue::Object>)
          tight().object([&] {
            for (const auto& [key, member] : content) this->member(key, member);
          });
        else
          this->value(content);
      },
      value.content);
}

void JsonWriter::open(char bracket) {
  const bool is_tight = std::exchange(is_tight_, false) || style_ == Style::compact;
  put({&bracket, 1});
  open_.push_back({!is_tight});
}

void JsonWriter::close(char bracket) {
  const auto [is_wide, is_empty] = open_.back();
  open_.pop_back();
  if (std::exchange(is_line_, false))
    begin_line(open_.size());
  else if (is_wide && !is_empty)
    text_ += ' ';
  text_ += bracket;
}

void JsonWriter::separate() {
  if (std::exchange(has_key_, false) || open_.empty()) return;
  auto& [is_wide, is_empty] = open_.back();
  const bool is_first = std::exchange(is_empty, false);
  if (!is_first) text_ += ',';
  if (std::exchange(is_line_, false))
    begin_line(open_.size());
  else if (is_first ? is_wide : style_ == Style::spaced)
    text_ += ' ';
}

void JsonWriter::put(std::string_view token) {
  separate();
  text_ += token;
}

}  // namespace asterism
