#pragma once

#include "core/pose_covariance.hpp"
#include "core/trace.hpp"
#include "io/json/json_node.hpp"
#include "io/json/json_writer.hpp"

namespace asterism {

/// Reads the members x_m, y_m and heading_rad of an object.  @throws InputError
Pose2 read_pose(const JsonNode& object);

/// Reads the member "covariance" of an object: nine numbers, row by row.
/// @throws InputError, also if it is asymmetric or indefinite
PoseCovariance read_covariance(const JsonNode& object);

/// Reads all these members of an object.  @throws InputError
Displacement read_displacement(const JsonNode& object);

/// Writes these members of an object.  @throws std::invalid_argument if a number is not finite
void write_pose(JsonWriter& json, const Pose2& pose, const PoseCovariance& covariance);

/// Writes these members of an object.  @throws std::invalid_argument if a number is not finite
void write_displacement(JsonWriter& json, const Displacement& displacement);

/// One visit of a trace, by itself: what the visits before and after it demand is not checked.
/// @throws InputError as read_trace
Visit read_visit(const JsonNode& node);

/// Writes a visit of a trace as an object.
/// @throws std::invalid_argument if a number is not finite or an extension no JSON object
void write_visit(JsonWriter& json, const Visit& visit);

/// Writes the members of a JSON object, given as text, in lines of their own.
/// @throws std::invalid_argument unless it is one
void write_extensions(JsonWriter& json, const std::string& object);

}  // namespace asterism
