#pragma once

#include <iosfwd>
#include <memory>
#include <string>

#include "core/pose_graph.hpp"

namespace asterism {

/// Pose graphs in the plane as g2o and those who took over its format have them, a part a line:
///
///   VERTEX_SE2 id x y theta
///   EDGE_SE2 i j dx dy dtheta I11 I12 I13 I22 I23 I33
///   FIX id ...
///   # a comment
///
/// I is the information matrix, the inverse of the covariance, row by row without what lies below
/// its diagonal; m, m, rad, in the frame of the place reached, j, as ours is.
///
/// Reading is strict: no other tags, no vertex twice, edges and FIX of vertices that are there, no
/// edge from a vertex to itself, information that is positive definite. Ids are any integers from
/// 0; the place of the smallest is the first and so on, however the lines are ordered.
///
/// @throws InputError "file:line: found ...; expected ..."
PoseGraph read_pose_graph_file(const std::string& file);

/// Reads a pose graph from a stream.
/// @param name  for messages
PoseGraph read_pose_graph(std::unique_ptr<std::istream> in, const std::string& name);

/// Writes a pose graph. Poses read back as they are, covariances up to rounding.
/// @throws std::invalid_argument if it could not be read back
void write_pose_graph(std::ostream& out, const PoseGraph& graph);

/// Writes a pose graph to a file, whole or not at all.
/// @throws std::invalid_argument as write_pose_graph, Error if the file cannot be written
void write_pose_graph_file(const std::string& file, const PoseGraph& graph);

}  // namespace asterism
