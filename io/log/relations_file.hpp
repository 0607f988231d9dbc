#pragma once

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "core/relation.hpp"

namespace asterism {

/// Reads surveyed relations, one a line. The file may be packed by gzip or xz; its content tells.
///
///   # a comment
///   t1 t2 x y z roll pitch yaw
///
/// the pose of the robot at t2 in its frame at t1. Strict: just eight numbers, z, roll and pitch
/// being 0 up to 1e-3; at least one relation.
///
/// @throws InputError "file:line: found ...; expected ..."
std::vector<Relation> read_relations_file(const std::string& file);

/// Reads surveyed relations from a stream.
/// @param name  for messages
std::vector<Relation> read_relations(std::unique_ptr<std::istream> in, const std::string& name);

}  // namespace asterism
