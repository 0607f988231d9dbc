#include "io/json/digest.hpp"

#include <bit>
#include <cstdint>

#include "io/json/json_node.hpp"
#include "io/json/trace_file.hpp"

namespace asterism {
namespace {

class Hash {
 public:
  void add_byte(std::uint8_t byte) { hash_ = (hash_ ^ byte) * 0x100000001b3; }
  // Byte by byte: of words multiplied as a whole, two that differ in their signs alone would
  // cancel.
  void add(std::uint64_t word) {
    for (int shift = 0; shift < 64; shift += 8) add_byte(static_cast<std::uint8_t>(word >> shift));
  }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  void add(const Pose2& pose) {
    for (const double number : {pose.x_m, pose.y_m, pose.heading_rad}) add(number);
  }
  std::string text() const {
    std::string digits;
    for (int shift = 60; shift >= 0; shift -= 4) digits += "0123456789abcdef"[hash_ >> shift & 15];
    return digits;
  }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

}  // namespace

std::string digest(const Trace& trace) {
  Hash hash;
  for (const char byte : trace_json(trace)) hash.add_byte(static_cast<std::uint8_t>(byte));
  return hash.text();
}

std::string digest(std::span<const Scan> scans) {
  Hash hash;
  for (const Scan& scan : scans) {
    hash.add(static_cast<std::uint64_t>(scan.number));
    hash.add(scan.stamp_s);
    hash.add(scan.odom_from_robot);
    const LaserLayout& laser = scan.laser;
    for (const double number : {laser.first_beam_rad, laser.beam_step_rad, laser.max_range_m})
      hash.add(number);
    hash.add(laser.robot_from_laser);
    hash.add(std::uint64_t{scan.ranges_m.size()});
    for (const double range_m : scan.ranges_m) hash.add(range_m);
  }
  return hash.text();
}

std::string read_digest(const JsonNode& node) {
  const std::string& text = node.string();
  if (text.size() != 16 || text.find_first_not_of("0123456789abcdef") != std::string::npos)
    node.refuse("16 hexadecimal digits");
  return text;
}

}  // namespace asterism
