#include "simulation/laser.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace asterism {
namespace {

/// How far a beam goes to a person, if it meets one.
std::optional<double> distance_m(Point2 from, Point2 direction, const Person& person) {
  const Point2 offset = person.position - from;
  const double aside_m = cross(direction, offset);
  const double half_chord_squared = person.radius_m * person.radius_m - aside_m * aside_m;
  if (half_chord_squared < 0) return std::nullopt;
  const double along_m = dot(direction, offset) - std::sqrt(half_chord_squared);
  return along_m >= 0 ? std::optional(along_m) : std::nullopt;
}

double told_m(std::optional<RayCaster::Hit> hit, const LaserOptions& options,
              RandomEngine& engine) {
  const double max_m = options.layout.max_range_m;
  // Drawn for every beam, so that one beam more or less that returns leaves the others as they are.
  const double fate = uniform(engine);
  const double noise_m = options.noise_m * normal(engine);
  if (!hit || fate < (hit->is_glass ? options.missing_at_glass : options.missing)) return max_m;
  double range_m = hit->distance_m + noise_m;
  if (options.quantum_m > 0) range_m = options.quantum_m * std::round(range_m / options.quantum_m);
  return std::clamp(range_m, 0.0, max_m);
}

}  // namespace

std::vector<double> ranges_m(const RayCaster& walls, std::span<const Person> people,
                             const Pose2& world_from_laser, const LaserOptions& options,
                             RandomEngine& engine) {
  const Point2 from = world_from_laser.position();
  std::vector<double> result(options.beams);
  for (std::size_t beam = 0; beam < options.beams; ++beam) {
    const Point2 direction =
        unit_vector(world_from_laser.heading_rad + options.layout.beam_rad(beam));
    auto hit = walls.cast(from, direction, options.layout.max_range_m);
    for (const Person& person : people) {
      const auto there_m = distance_m(from, direction, person);
      if (there_m && *there_m < (hit ? hit->distance_m : options.layout.max_range_m))
        hit = RayCaster::Hit{*there_m, false};
    }
    result[beam] = told_m(hit, options, engine);
  }
  return result;
}

}  // namespace asterism
