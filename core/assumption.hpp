#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/id.hpp"

namespace asterism {

/// What a person knows of two visits: they were to one place, or to two. It can be taken back,
/// since no trace holds it.
struct Assumption {
  enum class Kind { same, differ };
  Kind kind = Kind::same;
  VisitId one, other;

  friend bool operator==(const Assumption&, const Assumption&) = default;
};

/// Whether it is so where these are the places of the two visits.
template <class Place>
bool agrees(const Assumption& assumption, const Place& one, const Place& other) {
  return (one == other) == (assumption.kind == Assumption::Kind::same);
}

/// "same(3, 9)", "differ(2, 5)"
inline std::string text_of(const Assumption& assumption) {
  return std::string(assumption.kind == Assumption::Kind::same ? "same(" : "differ(") +
         std::to_string(assumption.one.index()) + ", " + std::to_string(assumption.other.index()) +
         ')';
}

/// Several assumptions as text, with commas between: "same(3, 9), differ(2, 5)"
inline std::string text_of(std::span<const Assumption> assumptions) {
  std::string text;
  for (const Assumption& assumption : assumptions)
    text += (text.empty() ? "" : ", ") + text_of(assumption);
  return text;
}

}  // namespace asterism
