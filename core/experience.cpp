#include "core/experience.hpp"

#include <algorithm>
#include <stdexcept>

namespace asterism {
namespace {

constexpr std::string_view turn_prefix = "turn:";

bool is_label(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

std::string place_in(std::size_t position) { return "/experience/" + std::to_string(position); }

}  // namespace

Action Action::parse(std::string_view text) {
  if (text == "travel") return {Kind::travel};
  if (text == "turn_around") return {Kind::turn_around};
  const std::string_view name = text.substr(std::min(turn_prefix.size(), text.size()));
  if (!text.starts_with(turn_prefix) || !is_label(name))
    throw std::invalid_argument(
        "found another text; expected \"travel\", \"turn_around\" or \"turn:\" and a name of "
        "letters, digits and _");
  return {Kind::turn, std::string(name)};
}

std::string Action::text() const {
  switch (kind) {
    case Kind::travel:
      return "travel";
    case Kind::turn_around:
      return "turn_around";
    case Kind::turn:
      break;
  }
  return std::string(turn_prefix) + turn;
}

bool is_view(std::string_view text) {
  return !text.empty() && text != "travel" && text != "turn_around" &&
         !text.starts_with(turn_prefix);
}

void require_valid(const Experience& experience) {
  const auto& [name, views, actions, extensions] = experience;
  if (views.size() != actions.size() + 1)
    throw std::invalid_argument("/experience: found " + std::to_string(views.size()) +
                                " views and " + std::to_string(actions.size()) +
                                " actions; expected one view more than actions");
  for (std::size_t k = 0; k < views.size(); ++k)
    if (!is_view(views[k]))
      throw std::invalid_argument(place_in(2 * k) + ": found another text; expected a view");
  for (std::size_t k = 0; k < actions.size(); ++k) {
    const bool is_turn = actions[k].kind == Action::Kind::turn;
    if (is_turn ? !is_label(actions[k].turn) : !actions[k].turn.empty())
      throw std::invalid_argument(place_in(2 * k + 1) + ": found another text; expected a turn");
  }
}

}  // namespace asterism
