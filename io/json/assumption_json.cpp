#include "io/json/assumption_json.hpp"

#include <charconv>
#include <optional>

namespace asterism {
namespace {

/// Takes a number off the front of a text.
std::optional<VisitId> take_visit(std::string_view& text) {
  std::size_t visit = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), visit);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return VisitId(visit);
}

std::optional<Assumption> assumption_of(std::string_view text) {
  const std::string_view whole = text;
  const auto kind = text.starts_with("same") ? Assumption::Kind::same : Assumption::Kind::differ;
  text.remove_prefix(std::min(text.size(), text.find('(') + 1));
  const auto one = take_visit(text);
  if (!one || !text.starts_with(", ")) return std::nullopt;
  text.remove_prefix(2);
  const auto other = take_visit(text);
  if (!other) return std::nullopt;
  const Assumption assumption{kind, *one, *other};
  if (text_of(assumption) != whole) return std::nullopt;
  return assumption;
}

}  // namespace

std::vector<std::string> assumption_texts(std::span<const Assumption> assumptions) {
  std::vector<std::string> texts;
  for (const Assumption& assumption : assumptions) texts.push_back(text_of(assumption));
  return texts;
}

void write_assumptions(JsonWriter& json, std::span<const Assumption> assumptions) {
  if (!assumptions.empty()) json.member("assumptions", assumption_texts(assumptions));
}

std::vector<Assumption> read_assumptions(const JsonNode& node) {
  if (!node.exists()) return {};
  auto result = node.list([](const JsonNode& item) {
    const auto assumption = assumption_of(item.string());
    if (!assumption) item.refuse("\"same(I, J)\" or \"differ(I, J)\" of two visits");
    return *assumption;
  });
  if (result.empty()) node.refuse("an empty array", "an assumption, or no such key");
  return result;
}

}  // namespace asterism
