#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace asterism {

/// Members of a conflict, less those that can be spared: tried one by one, each beside those that
/// are still there. What is needed beside more is needed beside fewer, so none that stays can be
/// spared, as far as `conflict` knows.
///
/// @param members   that cannot be together; all different
/// @param order     in which they are tried
/// @param conflict  conflict(others): some of the others that cannot be together, or nothing
template <class Member, class Conflict>
std::vector<Member> spare_one_by_one(std::vector<Member> members, const std::vector<Member>& order,
                                     Conflict&& conflict) {
  for (const Member& candidate : order) {
    if (std::ranges::find(members, candidate) == members.end()) continue;
    std::vector<Member> others = members;
    std::erase(others, candidate);
    if (std::optional<std::vector<Member>> smaller = conflict(others))
      members = *std::move(smaller);
  }
  return members;
}

}  // namespace asterism
