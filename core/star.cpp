#include "core/star.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

namespace asterism {
namespace {

std::invalid_argument wrong(const std::string& found, const std::string& expected) {
  return std::invalid_argument("found " + found + "; expected " + expected);
}

bool is_label_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Input is quoted whole while it is short; control characters never reach a terminal.
std::string quoted(std::string_view text) {
  std::string shown;
  for (const char c : text.substr(0, 40)) shown += (c < ' ' || c > '~') ? '?' : c;
  return '"' + shown + (text.size() > 40 ? "...\"" : "\"");
}

Arm parse_arm(std::string_view word) {
  const auto malformed = [&] {
    return wrong(quoted(word),
                 "an arm like a+1: label of letters, digits and _, then + or -, then 0 or 1");
  };
  if (word.size() < 3) throw malformed();
  const std::string_view label = word.substr(0, word.size() - 2);
  const char sign = word[word.size() - 2];
  const char alpha = word.back();
  if (!std::all_of(label.begin(), label.end(), is_label_character)) throw malformed();
  if ((sign != '+' && sign != '-') || (alpha != '0' && alpha != '1')) throw malformed();
  return {std::string(label), sign, alpha == '1'};
}

std::vector<std::size_t> opposites(const std::vector<Arm>& arms) {
  if (arms.size() > Star::max_arms)
    throw wrong(std::to_string(arms.size()) + " arms", "at most " + std::to_string(Star::max_arms));
  if (arms.empty()) throw wrong("no arms", "at least two, the directions of one local-path");
  std::map<std::pair<std::string_view, char>, std::size_t> position;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    const auto& [label, sign, has_gateway] = arms[i];
    if (label.empty() || !std::all_of(label.begin(), label.end(), is_label_character))
      throw wrong("label " + quoted(label), "letters, digits and _");
    if (sign != '+' && sign != '-') throw wrong(quoted(std::string(1, sign)), "+ or -");
    if (!position.emplace(std::pair(std::string_view(label), sign), i).second)
      throw wrong("arm " + label + sign + " twice", "each direction of a local-path once");
  }
  std::vector<std::size_t> result;
  for (const auto& [label, sign, has_gateway] : arms) {
    const char other = sign == '+' ? '-' : '+';
    const auto opposite = position.find(std::pair(std::string_view(label), other));
    if (opposite == position.end())
      throw wrong("arm " + label + sign + " alone", "its opposite " + label + other + " as well");
    if (!has_gateway && !arms[opposite->second].has_gateway)
      throw wrong("local-path " + label + " without a gateway", "α = 1 in at least one direction");
    result.push_back(opposite->second);
  }
  return result;
}

}  // namespace

Star::Star(std::vector<Arm> arms) : arms_(std::move(arms)), opposite_(opposites(arms_)) {}

Star Star::parse(std::string_view text) {
  std::vector<Arm> arms;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    if (end == begin) throw wrong(quoted(text), "arms with one space between them");
    arms.push_back(parse_arm(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return Star(std::move(arms));
}

std::string Star::text() const {
  std::string result;
  for (const auto& [label, sign, has_gateway] : arms_) {
    if (!result.empty()) result += ' ';
    result += label + sign + (has_gateway ? '1' : '0');
  }
  return result;
}

std::optional<std::size_t> Star::find(std::string_view arm_name) const {
  for (std::size_t i = 0; i < size(); ++i)
    if (name(i) == arm_name) return i;
  return std::nullopt;
}

std::vector<std::size_t> Star::view(std::size_t i) const {
  std::vector<std::size_t> result;
  for (std::size_t step = 0; step < size(); ++step) {
    const std::size_t arm = clockwise(i, step);
    const std::size_t to_opposite = (opposite_[arm] + size() - arm) % size();
    result.push_back(2 * to_opposite + (arms_[arm].has_gateway ? 1 : 0));
  }
  return result;
}

}  // namespace asterism
