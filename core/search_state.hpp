#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/id.hpp"

namespace asterism {

/// Where a search for minimal models stands: all it takes to go on.
struct SearchState {
  /// The place of `arm` is that of `same`, arm on arm; or it differs from all settled before it.
  struct Decision {
    ArmId arm;
    std::optional<ArmId> same = {};
    friend bool operator==(const Decision&, const Decision&) = default;
  };
  /// What is yet to be tried: each of `next` after all of `decided`.
  struct Branch {
    std::vector<Decision> decided;
    std::vector<Decision> next;
    friend bool operator==(const Branch&, const Branch&) = default;
  };
  /// For each visit, the arm by which it was entered, of the star of the place's first visit.
  using Model = std::vector<ArmId>;

  bool is_level_begun = false;     ///< else no branch has been looked at
  std::uint64_t limit = 0;         ///< what is preferred less is not looked at
  std::uint64_t refused = 0;       ///< the most preferred that was refused for the limit
  std::optional<Model> incumbent;  ///< a map found on the way
  std::vector<Model> models;       ///< of the best found under the limit
  std::vector<Branch> branches;
};

}  // namespace asterism
