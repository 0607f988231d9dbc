#include "perception/localiser.hpp"

#include <algorithm>
#include <cmath>

namespace asterism {
namespace {

constexpr float kOccupied = 0.5F;  // log-odds from which a cell is taken for a wall

}  // namespace

Localiser::Localiser(const LocaliserOptions& options, const Pose2& start)
    : options_(options),
      particles_(options.particles, Particle{start, 0}),
      last_(start),
      random_(1) {}

Localiser::Estimate Localiser::observe(const Scan& scan, const Grid& map) {
  returns_.clear();
  const std::size_t step = std::max<std::size_t>(1, scan.ranges_m.size() / options_.beams);
  for (std::size_t beam = 0; beam < scan.ranges_m.size(); beam += step) {
    const double range_m = scan.ranges_m[beam];
    if (range_m >= scan.laser.max_range_m || range_m > options_.usable_range_m) continue;
    returns_.push_back(scan.laser.robot_from_laser *
                       (range_m * unit_vector(scan.laser.beam_rad(beam))));
  }
  if (!odom_from_last_) {
    odom_from_last_ = scan.odom_from_robot;
    return {last_, 1, 0};
  }
  draw_field(map);

  const Pose2 step_taken = inverse(*odom_from_last_) * scan.odom_from_robot;
  odom_from_last_ = scan.odom_from_robot;
  const Pose2 by_odometry = last_ * step_taken;
  const double driven_m = norm(step_taken.position());
  const double sigma_m = options_.least_noise_m + options_.noise_per_m * driven_m;
  const double sigma_rad = options_.least_heading_noise_rad +
                           options_.heading_noise_per_m_rad * driven_m +
                           options_.heading_noise_per_rad * std::abs(step_taken.heading_rad);
  const auto moved = [&](const Pose2& from, double width_rad) {
    return from * Pose2{step_taken.x_m + sigma_m * normal(random_),
                        step_taken.y_m + sigma_m * normal(random_),
                        wrapped(step_taken.heading_rad + width_rad * normal(random_))};
  };
  const auto weigh = [&](double width_rad) {
    std::size_t best = 0;
    std::vector<double> matches(particles_.size());
    for (std::size_t i = 0; i < particles_.size(); ++i) {
      // The first particle follows the odometry from the most likely pose, without noise.
      particles_[i].pose = i == 0 ? by_odometry : moved(particles_[i].pose, width_rad);
      matches[i] = match(particles_[i].pose);
      if (matches[i] > matches[best]) best = i;
    }
    for (std::size_t i = 0; i < particles_.size(); ++i) {
      particles_[i].weight = options_.gain * matches[i];
    }
    return std::pair{particles_[best].pose, matches[best]};
  };
  const std::vector<Particle> before = particles_;
  auto [best, best_match] = weigh(sigma_rad);
  best = climb(best, by_odometry, best_match);
  if (best_match < options_.poor_match && !returns_.empty()) {
    particles_ = before;
    auto [other, other_match] = weigh(std::max(sigma_rad, options_.wide_heading_rad));
    other = climb(other, by_odometry, other_match);
    if (other_match > best_match) {
      best = other;
      best_match = other_match;
    }
  }
  resample();
  particles_.back().pose = best;

  const double turned_rad = wrapped(best.heading_rad - last_.heading_rad);
  last_ = best;
  return {best, best_match, turned_rad};
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
      if (map.log_odds[map.index({column, row})] < kOccupied) continue;
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

// Uphill from the best particle, towards a better match that the odometry leaves likely.
Pose2 Localiser::climb(Pose2 best, const Pose2& by_odometry, double& best_match) const {
  const auto score = [&](const Pose2& pose, double fit) {
    const Pose2 off = inverse(by_odometry) * pose;
    return fit - options_.prior_per_m2 * dot(off.position(), off.position()) -
           options_.prior_per_rad2 * off.heading_rad * off.heading_rad;
  };
  double step_m = 0.05;
  double step_rad = 0.02;
  double best_score = score(best, best_match);
  for (int halvings = 0; halvings < 4;) {
    bool better = false;
    for (const Pose2& step :
         {Pose2{step_m, 0, 0}, Pose2{-step_m, 0, 0}, Pose2{0, step_m, 0}, Pose2{0, -step_m, 0},
          Pose2{0, 0, step_rad}, Pose2{0, 0, -step_rad}}) {
      const Pose2 pose = best * step;
      const double fit = match(pose);
      if (score(pose, fit) <= best_score) continue;
      best_score = score(pose, fit);
      best_match = fit;
      best = pose;
      better = true;
    }
    if (better) continue;
    step_m /= 2;
    step_rad /= 2;
    ++halvings;
  }
  return best;
}

// Systematic: one draw, equal steps.
void Localiser::resample() {
  double most = particles_.front().weight;
  for (const Particle& particle : particles_) most = std::max(most, particle.weight);
  std::vector<double> upto;
  double sum = 0;
  for (const Particle& particle : particles_) {
    sum += std::exp(particle.weight - most);
    upto.push_back(sum);
  }
  std::vector<Particle> next;
  const double start = uniform(random_);
  std::size_t from = 0;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const double at = (start + static_cast<double>(i)) / static_cast<double>(particles_.size());
    while (from + 1 < upto.size() && upto[from] < at * sum) ++from;
    next.push_back({particles_[from].pose, 0});
  }
  particles_ = std::move(next);
}

}  // namespace asterism
