#pragma once

#include <string>
#include <vector>

#include "core/assumption.hpp"

namespace asterism {

/// What was asked of every map of a trace, as files tell it: which `Theory` it was.
struct TheoryRecord {
  bool planar = false;
  std::string axioms = "shipped";                        ///< or the folder they were read from
  std::vector<std::string> optional_axioms = {};         ///< names, switched on; sorted
  std::vector<std::string> preference{"path", "place"};  ///< extents to minimise, in order
  std::vector<Assumption> assumptions = {};

  friend bool operator==(const TheoryRecord&, const TheoryRecord&) = default;
};

}  // namespace asterism
