#include "io/log/trajectory_file.hpp"

#include <cmath>
#include <istream>
#include <optional>
#include <ostream>
#include <stdexcept>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/line_words.hpp"
#include "io/shown.hpp"
#include "io/text_file.hpp"

namespace asterism {
namespace {

constexpr double length_tolerance = 1e-3;  // of a quaternion: four digits are usual
constexpr std::size_t reference_words = 6;

TimedPose read_pose(LineWords& line) {
  TimedPose pose;
  pose.stamp_s = line.number("stamp");
  pose.layout_from_robot.x_m = line.number("tx", position_bounds_m);
  pose.layout_from_robot.y_m = line.number("ty", position_bounds_m);
  line.planar_zero("tz");
  const double qx = line.planar_zero("qx");
  const double qy = line.planar_zero("qy");
  const double qz = line.number("qz");
  const double qw = line.number("qw");
  line.end("qw");
  const double length = std::hypot(std::hypot(qx, qy), std::hypot(qz, qw));
  if (!(std::abs(length - 1) <= length_tolerance))
    line.complain("a quaternion of length " + decimal(length), "one of length 1");
  pose.layout_from_robot.heading_rad = wrapped(2 * std::atan2(qz, qw));
  return pose;
}

/// A pose of kind K; nothing of another kind.
std::optional<TimedPose> read_scan_pose(LineWords& line, std::uint64_t index) {
  const auto found = line.integer("scan_index", UINT64_MAX);
  if (found != index)
    line.refuse(std::to_string(found), "scan_index " + std::to_string(index) + ", counted from 0");
  const double stamp_s = line.number("timestamp");
  const Pose2 pose = line.pose("");
  const std::string_view kind = line.word("kind, K, O or P");
  if (kind != "K" && kind != "O" && kind != "P") line.refuse(kind, "kind, K, O or P");
  line.end("kind");
  if (kind != "K") return std::nullopt;
  return TimedPose{stamp_s, pose};
}

std::size_t words_of(LineWords line) {
  std::size_t words = 0;
  while (!line.next_word().empty()) ++words;
  return words;
}

Trajectory read(std::unique_ptr<std::istream> in, const std::string& name, bool may_tell_scans) {
  LineReader lines(std::move(in), name);
  std::optional<bool> tells_scans;
  std::uint64_t index = 0;
  Trajectory result;
  while (auto line = next_data_line(lines)) {
    if (!tells_scans) tells_scans = may_tell_scans && words_of(*line) == reference_words;
    if (!*tells_scans)
      result.push_back(read_pose(*line));
    else if (const auto pose = read_scan_pose(*line, index++))
      result.push_back(*pose);
  }
  if (result.empty())
    throw InputError(name, index > 0 ? "no pose of kind K" : "no pose", "at least one");
  return result;
}

}  // namespace

Trajectory read_trajectory(std::unique_ptr<std::istream> in, const std::string& name) {
  return read(std::move(in), name, false);
}
Trajectory read_trajectory_file(const std::string& file) {
  return read_trajectory(opened_file(file), file);
}

Trajectory read_reference(std::unique_ptr<std::istream> in, const std::string& name) {
  return read(std::move(in), name, true);
}
Trajectory read_reference_file(const std::string& file) {
  return read_reference(opened_file(file), file);
}

void write_trajectory(std::ostream& out, const Trajectory& trajectory) {
  if (trajectory.empty())
    throw std::invalid_argument("trajectory: found no pose; expected at least one");
  for (const auto& [stamp_s, pose] : trajectory) {
    require_writable(pose, "trajectory");
    if (!Bounds().contain(stamp_s))
      throw std::invalid_argument("trajectory: found no finite stamp; expected seconds");
  }
  out << "# stamp tx ty tz qx qy qz qw\n";
  for (const auto& [stamp_s, pose] : trajectory)
    out << decimal(stamp_s) << ' ' << decimal(pose.x_m) << ' ' << decimal(pose.y_m) << " 0 0 0 "
        << decimal(std::sin(pose.heading_rad / 2)) << ' ' << decimal(std::cos(pose.heading_rad / 2))
        << '\n';
}

void write_trajectory_file(const std::string& file, const Trajectory& trajectory) {
  write_atomically(file, [&](std::ostream& out) { write_trajectory(out, trajectory); });
}

}  // namespace asterism
