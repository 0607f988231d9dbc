#pragma once

#include "core/topological_map.hpp"

namespace asterism {

/// Can places and segments be drawn in the plane at all, whatever the order round a place?
/// Boyer and Myrvold's test; every map that is_planar accepts passes it.            [DESIGN §7]
bool is_planar_graph(const TopologicalMap& map);

}  // namespace asterism
