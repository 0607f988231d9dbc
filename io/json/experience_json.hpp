#pragma once

#include <string>
#include <vector>

#include "core/experience.hpp"
#include "io/json/json_node.hpp"
#include "io/json/json_writer.hpp"

namespace asterism {

/// Views and actions in turn, an array of strings.
struct Steps {
  std::vector<std::string> views;
  std::vector<Action> actions;
};

/// Reads views and actions.  @throws InputError
Steps read_steps(const JsonNode& node);

/// Writes the views and actions of an experience in turn, a view and an action to a line.
void write_steps(JsonWriter& json, const Experience& experience);

}  // namespace asterism
