#include "mapping/place_pictures.hpp"

#include <fmt/format.h>

#include "io/atomic_file.hpp"

namespace asterism {
namespace {

constexpr double way_step_m = 0.1;  // the way keeps no points closer than this

// The arms of a star where its gateways ground them: without a gateway, on across the place.
std::vector<PlacePicture::Arm> arms_of(const LocalTopology& topology) {
  const LocalStar& local = *topology.star;
  const std::vector<Gateway>& gateways = topology.neighbourhood->gateways;
  std::vector<PlacePicture::Arm> arms;
  for (std::size_t i = 0; i < gateways.size(); ++i) {
    const Gateway& gateway = gateways[i];
    const std::size_t arm = local.arm_of_gateway[i];
    arms.push_back(
        {local.star.name(arm) + "1", gateway.middle, gateway.outward_rad, gateway.width_m});
    const std::size_t opposite = local.star.opposite(arm);
    if (!local.star.has_gateway(opposite)) {
      arms.push_back({local.star.name(opposite) + "0",
                      gateway.middle,
                      wrapped(gateway.outward_rad + std::numbers::pi),
                      {}});
    }
  }
  return arms;
}

}  // namespace

void PlacePictures::follow(const ScanDetector& detector) {
  const Point2 robot = detector.map_from_robot().position();
  if (way_.empty() || norm(way_.back() - robot) > way_step_m) way_.push_back(robot);
}

void PlacePictures::add(const DetectedVisit& detected, const ScanDetector& detector) {
  const ScanDetector::PlaceView& seen = *detector.last_place();
  PlacePicture picture{.map = *detected.place_map, .arms = arms_of(seen.topology), .way = seen.way};
  picture.title =
      fmt::format("visit {}, scans {} to {}: {}", pictures_.size(), (*detected.visit.scans)[0],
                  (*detected.visit.scans)[1], detected.visit.star.text());
  picture.map.frame_from_grid = seen.map_from_visit * picture.map.frame_from_grid;
  const Skeleton& skeleton = seen.topology.skeleton;
  const Grid& frame = seen.topology.space.frame;
  for (std::size_t i = 0; i < skeleton.points.size(); ++i) {
    const Point2 at = frame.centre(skeleton.points[i].cell);
    (skeleton.is_critical(i) ? picture.pruned : picture.skeleton).push_back(at);
  }
  for (const std::size_t f : seen.topology.neighbourhood->core) {
    picture.core.push_back({frame.centre(skeleton.points[f].cell), skeleton.points[f].radius_m});
  }
  visits_.push_back({pictures_.size(), seen.map_from_visit.position()});
  pictures_.push_back(std::move(picture));
}

void PlacePictures::write(const std::filesystem::path& folder, const std::string& log) const {
  make_folder(folder);
  for (std::size_t i = 0; i < pictures_.size(); ++i) {
    write_atomically((folder / fmt::format("visit-{}.svg", i)).string(), place_svg(pictures_[i]));
  }
  remove_from(folder, "visit-{}.svg", pictures_.size());
  write_atomically((folder / "visits.svg").string(), strip_svg(pictures_, log + ": the visits"));
  write_atomically((folder / "way.svg").string(),
                   way_svg(way_, visits_, log + ": the way, as localised; no loop is closed"));
}

}  // namespace asterism
