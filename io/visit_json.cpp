#include "io/visit_json.hpp"

#include <algorithm>
#include <set>

#include "io/pose_json.hpp"

namespace asterism {
namespace {

using Extensions = JsonNode::Extensions;

/// Integers up to here are exact wherever JSON numbers are doubles.
constexpr std::uint64_t max_scan = (std::uint64_t{1} << 53) - 1;

std::size_t read_arm(const JsonNode& node, const Star& star) {
  if (const auto arm = star.find(node.string())) return *arm;
  node.refuse("an arm of the star, like " + star.name(0));
}

Displacement read_displacement(const JsonNode& node) {
  node.require_keys({"x_m", "y_m", "heading_rad", "covariance"}, Extensions::refused);
  const Pose2 pose = read_pose(node);
  return {pose.x_m, pose.y_m, pose.heading_rad, read_covariance(node)};
}

std::array<long long, 2> read_scans(const JsonNode& node) {
  const auto scans = node.items(2, "scans, the first and the last");
  const auto first = scans[0].count(max_scan);
  const auto last = scans[1].count(max_scan);
  if (first > last) scans[1].refuse("no scan before the first, " + std::to_string(first));
  return {static_cast<long long>(first), static_cast<long long>(last)};
}

std::array<double, 2> read_stamps(const JsonNode& node) {
  const auto stamps = node.items(2, "stamps, in and out");
  const std::array result{stamps[0].number(), stamps[1].number()};
  if (result[0] > result[1]) stamps[1].refuse("no stamp before the first, " + stamps[0].found());
  return result;
}

std::vector<MeasuredGateway> read_gateways(const JsonNode& node, const Star& star) {
  std::vector<MeasuredGateway> result;
  std::set<std::size_t> measured;
  for (const JsonNode& item : node.items()) {
    item.require_keys({"arm", "x_m", "y_m", "heading_rad", "width_m"}, Extensions::refused);
    const JsonNode name = item["arm"];
    const std::size_t arm = read_arm(name, star);
    if (!star.has_gateway(arm))
      name.refuse(name.string() + ", which has no gateway", "an arm with α = 1");
    if (!measured.insert(arm).second) name.refuse(name.string() + " again", "each arm once");
    const JsonNode width = item["width_m"];
    if (!(width.number() > 0)) width.refuse("a width above 0");
    result.push_back({name.string(), item["x_m"].number(), item["y_m"].number(),
                      item["heading_rad"].number(), width.number()});
  }
  return result;
}

std::string read_lpm(const JsonNode& node) {
  const std::string& file = node.string();
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20; };
  if (file.empty() || file.starts_with('/') || std::ranges::any_of(file, is_control))
    node.refuse("a file relative to the trace");
  return file;
}

}  // namespace

Visit read_visit(const JsonNode& node) {
  node.require_keys({"star", "entered_by", "left_by", "true_place", "displacement", "scans",
                     "stamps_s", "lpm", "gateways"},
                    Extensions::allowed);
  Visit visit{.star = node["star"].star()};
  if (const auto arm = node["entered_by"]; arm.exists())
    visit.entered_by = read_arm(arm, visit.star);
  if (const auto arm = node["left_by"]; arm.exists()) visit.left_by = read_arm(arm, visit.star);
  if (const auto place = node["true_place"]; place.exists()) visit.true_place = place.string();
  if (const auto displacement = node["displacement"]; displacement.exists())
    visit.displacement = read_displacement(displacement);
  if (const auto scans = node["scans"]; scans.exists()) visit.scans = read_scans(scans);
  if (const auto stamps = node["stamps_s"]; stamps.exists()) visit.stamps_s = read_stamps(stamps);
  if (const auto lpm = node["lpm"]; lpm.exists()) visit.lpm = read_lpm(lpm);
  if (const auto gateways = node["gateways"]; gateways.exists())
    visit.gateways = read_gateways(gateways, visit.star);
  visit.extensions = node.extensions();
  return visit;
}

}  // namespace asterism
