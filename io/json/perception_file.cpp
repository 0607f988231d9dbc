#include "io/json/perception_file.hpp"

#include <array>

#include "io/atomic_file.hpp"
#include "io/bounds.hpp"
#include "io/json/digest.hpp"
#include "io/json/json_node.hpp"
#include "io/json/json_writer.hpp"
#include "io/text_file.hpp"

namespace asterism {
namespace {

constexpr const char* format = "asterism/perception";

Pose2 read_pose(const JsonNode& node) {
  const auto numbers = node.items(3, "numbers, x, y and heading");
  for (const JsonNode& number : numbers) {
    const bool is_heading = &number == &numbers.back();
    if (!(is_heading ? heading_bounds_rad : position_bounds_m).contain(number.number()))
      number.refuse(is_heading ? "radians, at most 1e6 either way"
                               : "metres, at most 1e7 either way");
  }
  return {numbers[0].number(), numbers[1].number(), numbers[2].number()};
}

}  // namespace

PerceptionRecord read_perception(std::string_view json_text, const std::string& file) {
  const JsonDocument document{file, parse_json(json_text, file)};
  const JsonNode root(document);
  root.require_format(format);
  root.require_keys({"format", "version", "perceived_by", "trace", "scans", "remarks", "poses"});
  PerceptionRecord record{.perceived_by = root["perceived_by"].string(),
                          .trace_digest = read_digest(root["trace"]),
                          .scans_digest = read_digest(root["scans"])};
  record.remarks = root["remarks"].list(&JsonNode::string);
  record.map_from_robot = root["poses"].list(read_pose);
  return record;
}

PerceptionRecord read_perception_file(const std::string& file) {
  return read_perception(read_text_file(file, max_perception_bytes), file);
}

std::string perception_json(const PerceptionRecord& record) {
  for (const Pose2& pose : record.map_from_robot) require_writable(pose, "perception");
  return json_file(format, [&](JsonWriter& json) {
    json.line().member("perceived_by", record.perceived_by);
    json.line().member("trace", record.trace_digest, "scans", record.scans_digest);
    json.line().key("remarks").lines(record.remarks);
    json.line().key("poses").lines(record.map_from_robot, [](JsonWriter& to, const Pose2& pose) {
      to.value(std::array{pose.x_m, pose.y_m, pose.heading_rad});
    });
  });
}

void write_perception_file(const std::string& file, const PerceptionRecord& record) {
  write_atomically(file, perception_json(record));
}

}  // namespace asterism
