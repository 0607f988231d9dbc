#pragma once

#include <string>

#include "core/pose_covariance.hpp"
#include "io/json_node.hpp"

namespace asterism {

/// The members x_m, y_m and heading_rad of an object, and its covariance: nine numbers, row by row.
/// @throws InputError, also of a covariance that is asymmetric or indefinite
Pose2 read_pose(const JsonNode& object);
PoseCovariance read_covariance(const JsonNode& object);

/// The same as members of an object, without its braces.
/// @throws std::invalid_argument if a number is not finite
std::string pose_members(const Pose2& pose, const PoseCovariance& covariance);

}  // namespace asterism
