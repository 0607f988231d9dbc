#pragma once

#include "core/id.hpp"

namespace asterism {

/// What an engine finds when it follows a branch of the tree as long as there is no choice.
struct ForcedRun {
  VisitId end;  ///< the level after the last that leaves none
  bool lives;   ///< or nothing explains `end`
};

}  // namespace asterism
