#pragma once

#include <iosfwd>
#include <memory>
#include <string>

#include "core/trajectory.hpp"

namespace asterism {

/// Reads a trajectory in TUM format, a pose a line, in the order of the file. The file may be
/// packed by gzip or xz; its content tells.
///
///   # a comment
///   stamp tx ty tz qx qy qz qw
///
/// Strict: just eight numbers, at least one pose; and planar ones: tz, qx and qy are 0 and the
/// quaternion is of length 1, up to 1e-3, since some write few digits.
///
/// @throws InputError "file:line: found ...; expected ..."
Trajectory read_trajectory_file(const std::string& file);

/// Reads a trajectory from a stream.
/// @param name  for messages
Trajectory read_trajectory(std::unique_ptr<std::istream> in, const std::string& name);

/// Reads a reference to hold a trajectory against: one in TUM format, or the poses of kind K of
///
///   # a comment
///   scan_index timestamp x y theta kind
///
/// where indices count from 0 and the kind is K (an estimate of a scan's pose), O or P (odometry
/// from the nearest K after or before it). The number of words in the first line with a pose tells
/// which.
///
/// @throws InputError as read_trajectory
Trajectory read_reference_file(const std::string& file);

/// Reads a reference from a stream.
/// @param name  for messages
Trajectory read_reference(std::unique_ptr<std::istream> in, const std::string& name);

/// Writes a trajectory in TUM format. Stamps and positions read back as they are, headings up to
/// rounding.
/// @throws std::invalid_argument if it could not be read back
void write_trajectory(std::ostream& out, const Trajectory& trajectory);

/// Writes a trajectory to a file, whole or not at all.
/// @throws std::invalid_argument as write_trajectory, Error if the file cannot be written
void write_trajectory_file(const std::string& file, const Trajectory& trajectory);

}  // namespace asterism
