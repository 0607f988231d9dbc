#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace asterism {

/// What a robot of the basic SSH does from one dstate to the next.        [BMK10, §3.2] [theory §2]
struct Action {
  enum class Kind { travel, turn_around, turn };
  Kind kind = Kind::travel;
  std::string turn = {};  ///< name of a turn, "right"

  /// Reads "travel", "turn_around" or "turn:right".
  /// @throws std::invalid_argument "found ...; expected ..."
  static Action parse(std::string_view text);
  /// The action as parse() reads it, "turn:right".
  std::string text() const;

  friend auto operator<=>(const Action&, const Action&) = default;
};

/// A trace of the basic SSH: views and actions in turn, v0 a1 v1 a2 v2 ...   [BMK10, §3.2]
///
/// A view is a bare symbol. Readers guarantee: views that are told from actions, at least one, and
/// one more than there are actions.
struct Experience {
  std::string name;
  std::vector<std::string> views;
  std::vector<Action> actions;    ///< actions[k] leads from view k to view k + 1
  std::string extensions = "{}";  ///< the keys that start with x_, a JSON object

  friend bool operator==(const Experience&, const Experience&) = default;
};

/// Whether a text may be a view: not empty, and nothing that an action is called.
bool is_view(std::string_view text);

/// Checks what readers guarantee of an experience.
/// @throws std::invalid_argument "/experience/3: found ...; expected ..." if a guarantee does not
///         hold
void require_valid(const Experience& experience);

}  // namespace asterism
