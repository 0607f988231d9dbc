#include "perception/localiser.hpp"

#include <algorithm>
#include <cmath>

#include "core/squared.hpp"

namespace asterism {
namespace {

constexpr float wall_log_odds = 0.5F;  // log-odds from which a cell is taken for a wall

}  // namespace

Localiser::Localiser(const LocaliserOptions& options, const Pose2& start)
    : options_(options),
      fit_(options.fit),
      particles_(options.particles, Particle{start, 0}),
      last_(start),
      random_(1) {}

Localiser::Estimate Localiser::observe(const Scan& scan, const LocalPerceptualMap& map) {
  take_returns(scan);
  if (!odom_from_last_) {
    odom_from_last_ = scan.odom_from_robot;
    last_stamp_s_ = scan.stamp_s;
    return {.map_from_robot = last_};
  }
  if (version_ != map.version()) {
    version_ = map.version();
    draw_field(map.grid());
    fit_.draw(map);
  }
  Step step = step_to(scan.odom_from_robot);
  const auto bridged = bridge(step, std::abs(scan.stamp_s - last_stamp_s_));
  last_stamp_s_ = scan.stamp_s;
  Estimate estimate;
  if (bridged) {
    estimate.jump = step.motion;
    step = *bridged;
  }
  last_motion_ = step.motion;
  const ScanFit::Fit found = locate(step);

  estimate.map_from_robot = found.map_from_robot;
  estimate.match = match(found.map_from_robot);
  const Pose2 moved = inverse(last_) * found.map_from_robot;
  estimate.turned_rad = moved.heading_rad;
  StepDrift drift{found.covariance, left_to_wheels(found.covariance, step.motion, step.sigma_m),
                  norm(moved.position())};
  for (double& entry : drift.by_chance) entry *= options_.drift_per_m * drift.driven_m;
  drift_ = drifted(drift_, found.map_from_robot, drift);
  estimate.drift = drift_;
  last_ = found.map_from_robot;
  return estimate;
}

void Localiser::take_returns(const Scan& scan) {
  returns_.clear();
  const std::size_t step = std::max<std::size_t>(1, scan.ranges_m.size() / options_.beams);
  for (std::size_t beam = 0; beam < scan.ranges_m.size(); beam += step) {
    const double range_m = scan.ranges_m[beam];
    if (range_m >= scan.laser.max_range_m || range_m > options_.usable_range_m) continue;
    returns_.push_back(scan.laser.robot_from_laser *
                       (range_m * unit_vector(scan.laser.beam_rad(beam))));
  }
}

Localiser::Step Localiser::step_to(const Pose2& odom_from_robot) {
  const Pose2 motion = inverse(*odom_from_last_) * odom_from_robot;
  odom_from_last_ = odom_from_robot;
  const double driven_m = norm(motion.position());
  const double turned_rad = std::abs(motion.heading_rad);
  return {motion,
          options_.least_noise_m + options_.noise_per_m * driven_m +
              options_.noise_m_per_rad * turned_rad,
          options_.least_heading_noise_rad + options_.heading_noise_per_m_rad * driven_m +
              options_.heading_noise_per_rad * turned_rad};
}

std::optional<Localiser::Step> Localiser::bridge(const Step& by_wheels, double passed_s) const {
  const auto is_far = [&](const Pose2& motion) {
    return norm(motion.position()) > options_.jump_m ||
           std::abs(motion.heading_rad) > options_.jump_rad;
  };
  if (!is_far(by_wheels.motion)) return std::nullopt;
  const Step as_before{last_motion_, options_.bridge_m, options_.bridge_rad};
  const double most_m = options_.most_m_per_s * passed_s;
  const double most_rad = options_.most_rad_per_s * passed_s;
  if (passed_s > 0 && (norm(by_wheels.motion.position()) > most_m ||
                       std::abs(by_wheels.motion.heading_rad) > most_rad))
    return as_before;
  if (returns_.empty()) return std::nullopt;
  const auto fitted = [&](const Step& step) {
    const Pose2 there = last_ * step.motion;
    return fit_near(there, there, step).map_from_robot;
  };
  if (match(fitted(by_wheels)) >= options_.poor_match) return std::nullopt;
  const Pose2 other = fitted(as_before);
  const bool is_contradicted =
      match(other) > options_.good_match && is_far(inverse(last_ * by_wheels.motion) * other);
  return is_contradicted ? std::optional(as_before) : std::nullopt;
}

ScanFit::Fit Localiser::fit_near(const Pose2& start, const Pose2& by_odometry,
                                 const Step& step) const {
  const double per_m2 = 1 / squared(step.sigma_m);
  return fit_.fit(returns_, start, by_odometry, {per_m2, per_m2, 1 / squared(step.sigma_rad)});
}

ScanFit::Fit Localiser::locate(const Step& step) {
  const Pose2 by_odometry = last_ * step.motion;
  particles_before_ = particles_;
  const Pose2 likeliest = weigh(step, step.sigma_rad);
  ScanFit::Fit best{.map_from_robot = by_odometry};
  for (std::size_t i = 0; i < 3; ++i) {
    best.covariance[4 * i] = squared(i < 2 ? step.sigma_m : step.sigma_rad);
  }
  if (!returns_.empty()) {
    const auto fit_from = [&](const Pose2& start) { return fit_near(start, by_odometry, step); };
    const auto cheaper = [](const ScanFit::Fit& a, const ScanFit::Fit& b) {
      return a.cost < b.cost ? a : b;
    };
    best = cheaper(fit_from(likeliest), fit_from(by_odometry));
    if (match(best.map_from_robot) < options_.poor_match) {
      std::vector<Particle> narrow = particles_;
      particles_ = particles_before_;
      const ScanFit::Fit wide =
          fit_from(weigh(step, std::max(step.sigma_rad, options_.wide_heading_rad)));
      if (wide.cost < best.cost) {
        best = wide;
      } else {
        particles_ = std::move(narrow);
      }
    }
  }
  resample();
  particles_.back().pose = best.map_from_robot;
  return best;
}

// Moves the particles and weighs them; the likeliest. The first follows the odometry from the most
// likely pose, without noise.
Pose2 Localiser::weigh(const Step& step, double heading_noise_rad) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    Particle& particle = particles_[i];
    if (i == 0) {
      particle.pose = last_ * step.motion;
    } else {
      const double x_m = step.motion.x_m + step.sigma_m * normal(random_);
      const double y_m = step.motion.y_m + step.sigma_m * normal(random_);
      particle.pose =
          particle.pose *
          Pose2{x_m, y_m, wrapped(step.motion.heading_rad + heading_noise_rad * normal(random_))};
    }
    particle.weight = options_.gain * match(particle.pose);
    if (particle.weight > particles_[best].weight) best = i;
  }
  return particles_[best].pose;
}

void Localiser::draw_field(const Grid& map) {
  if (kernel_.empty()) {
    reach_ = static_cast<int>(std::ceil(3 * options_.sigma_m / map.resolution_m));
    for (int row = -reach_; row <= reach_; ++row) {
      for (int column = -reach_; column <= reach_; ++column) {
        const double away_m = std::hypot(row, column) * map.resolution_m;
        kernel_.push_back(
            static_cast<float>(std::exp(-0.5 * std::pow(away_m / options_.sigma_m, 2))));
      }
    }
  }
  width_ = map.width;
  height_ = map.height;
  resolution_m_ = map.resolution_m;
  corner_ = map.frame_from_grid.position();
  field_.assign(map.log_odds.size(), 0.0F);
  for (int row = reach_; row < height_ - reach_; ++row) {
    for (int column = reach_; column < width_ - reach_; ++column) {
      if (map.log_odds[map.index({column, row})] < wall_log_odds) continue;
      const float* value = kernel_.data();
      for (int y = row - reach_; y <= row + reach_; ++y) {
        float* const cells = &field_[map.index({column - reach_, y})];
        for (int x = 0; x <= 2 * reach_; ++x) cells[x] = std::max(cells[x], *value++);
      }
    }
  }
}

// Between the middles of four cells, bilinear.
double Localiser::field_at(Point2 point) const {
  const double x = (point.x_m - corner_.x_m) / resolution_m_ - 0.5;
  const double y = (point.y_m - corner_.y_m) / resolution_m_ - 0.5;
  const int column = static_cast<int>(std::floor(x));
  const int row = static_cast<int>(std::floor(y));
  if (column < 0 || row < 0 || column + 1 >= width_ || row + 1 >= height_) return 0;
  const double right = x - column;
  const double up = y - row;
  const float* const cell =
      &field_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
              static_cast<std::size_t>(column)];
  return (1 - up) * ((1 - right) * cell[0] + right * cell[1]) +
         up * ((1 - right) * cell[width_] + right * cell[width_ + 1]);
}

double Localiser::match(const Pose2& map_from_robot) const {
  if (returns_.empty()) return 0;
  const double c = std::cos(map_from_robot.heading_rad);
  const double s = std::sin(map_from_robot.heading_rad);
  double sum = 0;
  for (const Point2 p : returns_) {
    sum += field_at(
        {map_from_robot.x_m + c * p.x_m - s * p.y_m, map_from_robot.y_m + s * p.x_m + c * p.y_m});
  }
  return sum / static_cast<double>(returns_.size());
}

// Systematic: one draw, equal steps.
void Localiser::resample() {
  double most = particles_.front().weight;
  for (const Particle& particle : particles_) most = std::max(most, particle.weight);
  up_to_.clear();
  double sum = 0;
  for (const Particle& particle : particles_) {
    sum += std::exp(particle.weight - most);
    up_to_.push_back(sum);
  }
  particles_before_ = particles_;
  const double start = uniform(random_);
  std::size_t from = 0;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const double at = (start + static_cast<double>(i)) / static_cast<double>(particles_.size());
    while (from + 1 < up_to_.size() && up_to_[from] < at * sum) ++from;
    particles_[i] = {particles_before_[from].pose, 0};
  }
}

}  // namespace asterism
