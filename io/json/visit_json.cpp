#include "io/json/visit_json.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "io/shown.hpp"

namespace asterism {
namespace {

/// Integers up to here are exact wherever JSON numbers are doubles.
constexpr std::uint64_t max_scan = (std::uint64_t{1} << 53) - 1;

std::size_t read_arm(const JsonNode& node, const Star& star) {
  if (const auto arm = star.find(node.string())) return *arm;
  node.refuse("an arm of the star, like " + star.name(0));
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
    item.require_keys({"arm", "x_m", "y_m", "heading_rad", "width_m"});
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

void write_gateway(JsonWriter& json, const MeasuredGateway& gateway) {
  json.object("arm", gateway.arm, "x_m", gateway.x_m, "y_m", gateway.y_m, "heading_rad",
              gateway.heading_rad, "width_m", gateway.width_m);
}

}  // namespace

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

Displacement read_displacement(const JsonNode& object) {
  const Pose2 pose = read_pose(object);
  return make_displacement(pose, read_covariance(object));
}

void write_pose(JsonWriter& json, const Pose2& pose, const PoseCovariance& covariance) {
  json.member("x_m", pose.x_m, "y_m", pose.y_m, "heading_rad", pose.heading_rad, "covariance",
              covariance);
}

void write_displacement(JsonWriter& json, const Displacement& displacement) {
  const auto& [x_m, y_m, heading_rad, covariance] = displacement;
  write_pose(json, {x_m, y_m, heading_rad}, covariance);
}

Visit read_visit(const JsonNode& node) {
  node.require_keys({"star", "entered_by", "left_by", "true_place", "displacement", "scans",
                     "stamps_s", "lpm", "gateways"},
                    JsonNode::Extensions::allowed);
  Visit visit{.star = node["star"].star()};
  const auto arm = [&](const JsonNode& name) { return read_arm(name, visit.star); };
  const auto gateways = [&](const JsonNode& list) { return read_gateways(list, visit.star); };
  visit.entered_by = node["entered_by"].if_exists(arm);
  visit.left_by = node["left_by"].if_exists(arm);
  visit.true_place = node["true_place"].if_exists(&JsonNode::string);
  visit.displacement = node["displacement"].if_exists([](const JsonNode& object) {
    object.require_keys({"x_m", "y_m", "heading_rad", "covariance"});
    return read_displacement(object);
  });
  visit.scans = node["scans"].if_exists(read_scans);
  visit.stamps_s = node["stamps_s"].if_exists(read_stamps);
  visit.lpm = node["lpm"].if_exists(read_lpm);
  visit.gateways = node["gateways"].if_exists(gateways).value_or(visit.gateways);
  visit.extensions = node.extensions();
  return visit;
}

void write_visit(JsonWriter& json, const Visit& visit) {
  json.object([&] {
    json.member("star", visit.star);
    if (visit.entered_by) json.member("entered_by", visit.star.name(*visit.entered_by));
    if (visit.left_by) json.member("left_by", visit.star.name(*visit.left_by));
    json.member_if("true_place", visit.true_place);
    if (visit.displacement)
      json.line().key("displacement").object([&] {
        write_displacement(json, *visit.displacement);
      });
    if (visit.scans) json.line().member("scans", *visit.scans);
    if (visit.stamps_s) json.line().member("stamps_s", *visit.stamps_s);
    if (visit.lpm) json.line().member("lpm", *visit.lpm);
    if (!visit.gateways.empty()) json.line().key("gateways").lines(visit.gateways, write_gateway);
    write_extensions(json, visit.extensions);
  });
}

void write_extensions(JsonWriter& json, const std::string& object) {
  const JsonValue value = parse_json(object, "extensions");
  const auto* members = std::get_if<JsonValue::Object>(&value.content);
  if (!members)
    throw std::invalid_argument("extensions: found " + shown(object) + "; expected an object");
  for (const auto& [key, content] : *members) json.line().member(key, content);
}

}  // namespace asterism
