#include "io/json/experience_json.hpp"

#include <stdexcept>

namespace asterism {

Steps read_steps(const JsonNode& node) {
  const auto items = node.items();
  if (items.size() % 2 == 0)
    node.refuse("an array of " + std::to_string(items.size()),
                "an odd number: views and actions in turn, from view to view");
  Steps steps;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string& text = items[i].string();
    if (i % 2 == 0) {
      if (!is_view(text)) items[i].refuse("a view, which is not empty and no action");
      steps.views.push_back(text);
      continue;
    }
    try {
      steps.actions.push_back(Action::parse(text));
    } catch (const std::invalid_argument&) {
      items[i].refuse(
          "an action: travel, turn_around or turn: and a name of letters, digits and _");
    }
  }
  return steps;
}

void write_steps(JsonWriter& json, const Experience& experience) {
  json.array([&] {
    for (std::size_t k = 0; k < experience.views.size(); ++k) {
      json.line().value(experience.views[k]);
      if (k < experience.actions.size()) json.value(experience.actions[k].text());
    }
  });
}

}  // namespace asterism
