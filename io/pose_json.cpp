#include "io/pose_json.hpp"

#include <algorithm>

#include "core/trace.hpp"

namespace asterism {

Pose2 read_pose(const JsonNode& object) {
  return {object["x_m"].number(), object["y_m"].number(), object["heading_rad"].number()};
}

PoseCovariance read_covariance(const JsonNode& object) {
  const JsonNode node = object["covariance"];
  const auto numbers = node.items(9, "numbers");
  PoseCovariance covariance{};
  std::ranges::transform(numbers, covariance.begin(), &JsonNode::number);
  if (!is_covariance(covariance))
    node.refuse("an asymmetric or indefinite matrix",
                "a symmetric, positive semi-definite matrix, row by row");
  return covariance;
}

std::string pose_members(const Pose2& pose, const PoseCovariance& covariance) {
  std::string text = "\"x_m\": " + json_number(pose.x_m) + ", \"y_m\": " + json_number(pose.y_m) +
                     ", \"heading_rad\": " + json_number(pose.heading_rad) + ", \"covariance\": [";
  for (const double& number : covariance)
    text += (&number == covariance.data() ? "" : ", ") + json_number(number);
  return text + ']';
}

}  // namespace asterism
