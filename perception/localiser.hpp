#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/grid.hpp"
#include "core/random.hpp"
#include "core/scan.hpp"
#include "perception/drift.hpp"
#include "perception/local_perceptual_map.hpp"
#include "perception/scan_fit.hpp"

namespace asterism {

/// How far the wheels and a scan are trusted.
struct LocaliserOptions {
  std::size_t particles = 80;
  std::size_t beams = 180;  ///< at most so many of a scan's returns are matched
  double usable_range_m = 20;

  // Odometry: standard deviations of one step.
  double noise_per_m = 0.10;      ///< of position, a metre driven
  double noise_m_per_rad = 0.05;  ///< of position, a radian turned: the laser stands off the axle
  double heading_noise_per_m_rad = 0.05;  ///< of heading, a metre driven
  double heading_noise_per_rad = 0.15;    ///< of heading, a radian turned
  double least_noise_m = 0.005;
  double least_heading_noise_rad = 0.002;

  // Where the wheels are not believed: they start again from zero, or slip.
  double jump_m = 0.5;         ///< a step is looked at that is longer than this, or turns more, and
  double jump_rad = 0.8;       ///< not believed if the walls say another, as far from it
  double most_m_per_s = 8;     ///< faster goes no robot,
  double most_rad_per_s = 10;  ///< nor does it turn
  double good_match = 0.6;  ///< mean field value of what contradicts a step of less than poor_match
  double bridge_m = 0.3;    ///< deviations of a step like the one before
  double bridge_rad = 0.2;

  double sigma_m = 0.10;     ///< likelihood field: deviation of a return from its wall
  double gain = 30;          ///< log-likelihood of a scan that fits perfectly
  double poor_match = 0.45;  ///< mean field value below which headings are searched widely
  double wide_heading_rad = 0.45;

  ScanFitOptions fit = {};
  /// Share of a fit's covariance that stays as drift, a metre driven: fits to the same walls go
  /// wrong alike. Like those of DriftOptions, set by simulated drives, whose true poses are known.
  double drift_per_m = 0.3;
};

/// Where the robot is in its local perceptual map: Bel(x_t) as weighted particles.
///
///   Bel(x_t) = η P(z_t | x_t, m) ∫ P(x_t | x_{t-1}, u_t) Bel(x_{t-1}) dx_{t-1}      [BMK10, §4.1]
///
/// P(z | x, m) is the likelihood field: a return fits by its distance to the nearest occupied cell.
/// The most likely pose, from which the map is drawn, is what the scan fits best from the best
/// particle, or from where the odometry says: see ScanFit. Where the wheels tell of a step that no
/// robot can do, or that this scan contradicts while it fits one like the step before, that one is
/// taken in its place. It draws from an engine of its own,
/// begun alike each time. For one thread at a time.
class Localiser {
 public:
  /// @param start  map_from_robot at the first scan
  Localiser(const LocaliserOptions& options, const Pose2& start);

  /// Where the robot is, and how well that is known.
  struct Estimate {
    Pose2 map_from_robot = {};       ///< most likely
    double match = 1;                ///< mean field value of the returns there, 0 to 1
    double turned_rad = 0;           ///< since the scan before
    Drift drift = {};                ///< of the pose, since the first scan: see covariance_between
    std::optional<Pose2> jump = {};  ///< what the wheels tell of this step and is not believed
  };

  /// Moves the particles by the odometry since the last scan and weighs them by this one.
  /// @param map  the one that poses are told in, which does not hold the scan yet
  Estimate observe(const Scan& scan, const LocalPerceptualMap& map);

 private:
  // One step of the odometry, and the deviations it is trusted to.
  struct Step {
    Pose2 motion = {};
    double sigma_m = 0;
    double sigma_rad = 0;
  };
  struct Particle {
    Pose2 pose;
    double weight;  ///< logarithm
  };

  Step step_to(const Pose2& odom_from_robot);
  std::optional<Step> bridge(const Step& by_wheels, double passed_s) const;
  ScanFit::Fit fit_near(const Pose2& start, const Pose2& by_odometry, const Step& step) const;
  void take_returns(const Scan& scan);
  ScanFit::Fit locate(const Step& step);
  Pose2 weigh(const Step& step, double heading_noise_rad);
  void draw_field(const Grid& map);
  double field_at(Point2 point) const;
  double match(const Pose2& map_from_robot) const;
  void resample();

  LocaliserOptions options_;
  ScanFit fit_;
  std::vector<float> kernel_;
  int reach_ = 0;  ///< of the kernel, in cells
  std::vector<Particle> particles_;
  std::optional<Pose2> odom_from_last_;
  double last_stamp_s_ = 0;
  Pose2 last_motion_ = {};
  Pose2 last_ = {};
  Drift drift_ = {};
  RandomEngine random_;

  // Of the map as drawn last.
  std::optional<std::uint64_t> version_;
  std::vector<float> field_;
  int width_ = 0;
  int height_ = 0;
  double resolution_m_ = 1;
  Point2 corner_ = {};
  // Of the scan at work.
  std::vector<Point2> returns_;  ///< in the robot's frame
  std::vector<Particle> particles_before_;
  std::vector<double> up_to_;  ///< working space of resample
};

}  // namespace asterism
