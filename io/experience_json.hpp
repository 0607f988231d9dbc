#pragma once

#include <string>
#include <vector>

#include "core/experience.hpp"
#include "io/json_node.hpp"

namespace asterism {

/// Views and actions in turn, an array of strings.
struct Steps {
  std::vector<std::string> views;
  std::vector<Action> actions;
};

/// @throws InputError
Steps read_steps(const JsonNode& node);

/// Writes them, a view and an action to a line.
std::string steps_json(const Experience& experience);

}  // namespace asterism
