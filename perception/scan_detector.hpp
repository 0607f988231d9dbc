#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "perception/local_perceptual_map.hpp"
#include "perception/local_topology.hpp"
#include "perception/localiser.hpp"
#include "perception/place_detector.hpp"

namespace asterism {

struct ScanDetectorOptions {
  LpmOptions lpm = {};
  LocaliserOptions localiser = {};
  LocalTopologyOptions topology = {};
  double start_heading_rad = 0;  ///< of the robot in the map's frame, at the first scan

  // The map is redrawn where there is something new to see and nothing is blurred.
  double redraw_m = 0.2;
  double redraw_rad = 0.1;
  double blurred_rad = 0.12;  ///< a scan during which the robot turned more is not drawn

  // Place or path.
  double stay_m = 0.5;        ///< the robot stays while it keeps within this of one spot
  double stay_s = 4;          ///< ... for this long
  double hold_s = 2;          ///< a star counts once it was seen for so long
  double half_seen = 0.2;     ///< ... weighs this where a gateway's end is still unknown
  double memory_s = 10;       ///< ... a later look, which knows more, outweighs an earlier one
  double explored = 0.12;     ///< ... with no more than this share of the border unknown
  double leave_m = 2.0;       ///< so far out of a gateway the robot has left; nearer is a poke
  double turn_off_rad = 1.1;  ///< a place driven through counts if the robot turned off there
};

/// The detector that ships: local perceptual map, localisation, gateways, stars.
///                                                            [DESIGN §11] [BMK10, §4, §5]
class ScanDetector final : public PlaceDetector {
 public:
  explicit ScanDetector(const ScanDetectorOptions& options = {});

  std::string_view name() const noexcept override { return "scans"; }
  std::optional<DetectedVisit> observe(const Scan& scan) override;
  std::optional<DetectedVisit> finish() override;

  const LocalPerceptualMap& map() const noexcept { return map_; }
  const Pose2& map_from_robot() const noexcept { return robot_; }
  /// How the visit handed over last was seen.
  struct PlaceView {
    LocalTopology topology = {};
    Pose2 map_from_visit = {};
    std::vector<Point2> way = {};  ///< of the robot, in the map's frame
  };
  const std::optional<PlaceView>& last_place() const noexcept { return last_place_; }
  /// What the last scan's map says of the robot's surroundings.
  const LocalTopology& surroundings() const noexcept { return surroundings_; }

 private:
  // A point of the robot's way.
  struct Step {
    long long scan = 0;
    double stamp_s = 0;
    Pose2 map_from_robot = {};
  };
  // A star seen for some time, and its gateways as seen last.
  struct Sight {
    double seen_s = 0;  ///< what is long past, or was half seen, counts less
    LocalTopology topology = {};
    Point2 from = {};
  };
  struct Crossing {
    std::size_t gateway = 0;
    std::size_t inside = 0;  ///< step of the way just inside the gateway
  };

  void follow(const Scan& scan);
  void look(double passed_s);
  Sight& sight_of(const LocalTopology& seen);
  void forget();
  const Sight* best_sight() const;
  std::optional<std::size_t> outside(const Sight& place, Point2 point, double by_m) const;
  std::optional<Crossing> entered(const Sight& place, std::size_t before) const;
  std::optional<DetectedVisit> leave(const Sight& place, std::size_t gateway);
  DetectedVisit visit(const Sight& place, std::optional<Crossing> in, std::optional<Crossing> out);

  ScanDetectorOptions options_;
  LocalPerceptualMap map_;
  Localiser localiser_;
  Pose2 robot_ = {};
  LocalTopology surroundings_ = {};

  std::deque<Step> way_;  ///< since the last visit
  std::optional<Step> drawn_;
  std::optional<double> last_stamp_s_;

  Point2 anchor_ = {};  ///< the spot the robot stays at
  double stayed_s_ = 0;

  bool fixed_ = false;  ///< a possible place: the map does not scroll
  std::vector<Sight> sights_;
  double stayed_in_place_s_ = 0;     ///< how long the robot stayed while it saw a place
  std::optional<Pose2> last_visit_;  ///< map_from_visit
  std::optional<PlaceView> last_place_;
};

}  // namespace asterism
