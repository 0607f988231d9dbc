#pragma once

#include <deque>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "perception/local_perceptual_map.hpp"
#include "perception/local_topology.hpp"
#include "perception/localiser.hpp"
#include "perception/place_detector.hpp"

namespace asterism {

/// When the map is redrawn, and what makes a place.
struct ScanDetectorOptions {
  LpmOptions lpm = {};
  LocaliserOptions localiser = {};
  LocalTopologyOptions topology = {};
  double start_heading_rad = 0;  ///< of the robot in the map's frame, at the first scan

  // The map is redrawn where there is something new to see and nothing is blurred.
  double redraw_m = 0.2;
  double redraw_rad = 0.1;
  double blurred_rad = 0.25;  ///< a scan during which the robot turned more is not drawn

  // Place or path.
  double stay_m = 0.5;       ///< the robot stops where it keeps within this of one spot
  double stay_s = 4;         ///< and does so for this long
  double corner_m = 3;       ///< the robot turns a corner where its way so far before and behind
  double corner_rad = 0.8;   ///< differs by this much in direction
  double near_m = 4;         ///< a place's star is looked at from the way so near to its spot
  double spot_m = 0.2;       ///< from points of the way so far apart
  double hold_s = 2;         ///< a star counts if it holds where the robot was for so long
  double drive_s_per_m = 4;  ///< a metre driven holding a star for as long as this
  double explored = 0.12;    ///< a star counts with no more than this share of the border unknown
  double leave_m = 2.0;      ///< so far out of a gateway the robot has left; nearer is a poke
};

/// The detector that ships: local perceptual map, localisation, gateways, stars.
///                                                            [theory §11] [BMK10, §4, §5]
/// For one thread at a time.
class ScanDetector final : public PlaceDetector {
 public:
  /// A detector that has seen nothing yet.
  explicit ScanDetector(const ScanDetectorOptions& options = {});

  std::string_view name() const noexcept override { return "scans"; }
  std::optional<DetectedVisit> observe(const Scan& scan) override;
  std::optional<DetectedVisit> finish() override;

  /// The local perceptual map after the last scan.
  const LocalPerceptualMap& map() const noexcept { return map_; }
  /// Where the robot was at the last scan, in the map's frame, which drifts.
  const Pose2& map_from_robot() const noexcept { return robot_; }
  /// A step of the wheels that was not believed.
  struct Jump {
    long long scan = 0;  ///< at which it ended
    Pose2 motion = {};   ///< by the wheels, in the frame of the robot before
  };
  /// Those so far, in order.
  std::span<const Jump> jumps() const noexcept { return jumps_; }
  /// How the visit handed over last was seen.
  struct PlaceView {
    LocalTopology topology = {};
    Pose2 map_from_visit = {};
    std::vector<Point2> way = {};  ///< of the robot, in the map's frame
  };
  /// Nothing before the first visit is handed over.
  const std::optional<PlaceView>& last_place() const noexcept { return last_place_; }

 private:
  // A point of the robot's way.
  struct Step {
    long long scan = 0;
    double stamp_s = 0;
    Pose2 map_from_robot = {};
    Drift drift = {};
    double passed_s = 0;   ///< until the next
    bool stopped = false;  ///< at a stop
  };
  // The place round a spot, as the map shows it.
  struct Place {
    LocalTopology topology = {};
    double held_s = 0;     ///< time, and way, from which its star is seen
    double stopped_s = 0;  ///< of that, at a stop
  };
  // Stars seen from the way, all by the last scan's map.
  struct Looks {
    std::vector<LocalTopology> stars = {};
    std::map<std::vector<std::size_t>, std::optional<std::size_t>> star_of_core = {};
  };
  struct Crossing {
    std::size_t gateway = 0;
    std::size_t inside = 0;  ///< step of the way just inside the gateway
  };

  double passed_since_last(double stamp_s);
  void follow(const Scan& scan);
  void look();
  std::vector<Point2> driven() const;
  void find_stop(double passed_s);
  void find_corner();
  void mark(Point2 spot);
  std::optional<Place> place_at(Point2 spot, Looks& looks) const;
  std::optional<std::size_t> star_seen_from(Point2 from, Looks& looks) const;
  std::optional<std::size_t> outside(const Place& place, Point2 point, double by_m) const;
  static bool is_inside(const Gateway& gateway, const Step& step);
  std::optional<Crossing> entered(const Place& place, std::size_t before) const;
  std::optional<DetectedVisit> leave(const Place& place, std::size_t gateway);
  DetectedVisit visit(const Place& place, std::optional<Crossing> in, std::optional<Crossing> out);

  ScanDetectorOptions options_;
  LocalPerceptualMap map_;
  Localiser localiser_;
  Pose2 robot_ = {};
  LocalTopology surroundings_ = {};  ///< what the last scan's map says of them

  std::deque<Step> way_;  ///< since the last visit
  std::optional<Step> drawn_;
  std::vector<Jump> jumps_;
  std::optional<double> last_stamp_s_;
  double clock_s_ = 0;  ///< below 0 where stamps run backwards

  Point2 anchor_ = {};  ///< the spot the robot stays at
  double stayed_s_ = 0;

  bool fixed_ = false;         ///< a possible place: the map does not scroll
  std::vector<Point2> spots_;  ///< since the last visit, where the robot stopped or turned a corner
  std::optional<Point2> judged_from_;  ///< where the robot was when the spots were looked at last
  std::optional<DriftingPose> last_visit_;  ///< map_from_visit
  std::optional<PlaceView> last_place_;
};

}  // namespace asterism
