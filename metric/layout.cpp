#include "metric/layout.hpp"

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <optional>
#include <queue>
#include <stdexcept>

#include "metric/layout_covariance.hpp"
#include "metric/layout_residual.hpp"

namespace asterism {
namespace {

// Up to here a dense solver is faster.
constexpr std::size_t most_dense_places = 8;

using Parameters = std::array<double, 3>;  // x_m, y_m, heading_rad of one place

Pose2 pose(const double* parameters) { return {parameters[0], parameters[1], parameters[2]}; }

class Cost final : public ceres::SizedCostFunction<3, 3, 3> {
 public:
  explicit Cost(const Displacement& displacement) : residual_(displacement) {}

  bool Evaluate(double const* const* places, double* residuals, double** jacobians) const override {
    const LayoutResidual::Value value = residual_(pose(places[0]), pose(places[1]));
    Eigen::Map<Eigen::Vector3d>{residuals} = value.residual;
    if (jacobians == nullptr) return true;
    if (jacobians[0] != nullptr) Eigen::Map<LayoutResidual::Matrix3>{jacobians[0]} = value.by_from;
    if (jacobians[1] != nullptr) Eigen::Map<LayoutResidual::Matrix3>{jacobians[1]} = value.by_to;
    return true;
  }

 private:
  LayoutResidual residual_;
};

void require_valid(std::size_t places, std::span<const PlaceDisplacement> displacements) {
  if (places == 0) throw std::invalid_argument("a layout has at least one place");
  for (const auto& [from, to, displacement] : displacements) {
    if (from.index() >= places || to.index() >= places)
      throw std::invalid_argument("a displacement names a place that is not there");
    if (from == to) throw std::invalid_argument("a displacement joins a place to itself");
    if (!std::isfinite(displacement.x_m) || !std::isfinite(displacement.y_m) ||
        !std::isfinite(displacement.heading_rad) || !is_covariance(displacement.covariance))
      throw std::invalid_argument("a displacement is not finite, or has no covariance");
  }
}

// Where the chain of displacements with the least variance puts each place that has no pose yet.
void place_others(std::vector<std::optional<Pose2>>& poses,
                  std::span<const PlaceDisplacement> displacements) {
  std::vector<std::vector<std::size_t>> at_place(poses.size());
  for (std::size_t k = 0; k < displacements.size(); ++k) {
    at_place[displacements[k].from.index()].push_back(k);
    at_place[displacements[k].to.index()].push_back(k);
  }
  struct Reached {
    double variance;
    std::size_t place;
    Pose2 pose;
    bool operator>(const Reached& other) const {
      return std::pair(variance, place) > std::pair(other.variance, other.place);
    }
  };
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> reached;
  std::vector<bool> done(poses.size(), false);
  const auto go_on = [&](std::size_t place, double variance) {
    done[place] = true;
    for (const std::size_t k : at_place[place]) {
      const auto& [from, to, d] = displacements[k];
      const Pose2 moved = d.left_from_reached();
      const bool forwards = from.index() == place;
      const std::size_t next = forwards ? to.index() : from.index();
      if (done[next]) continue;
      const double more = d.covariance[0] + d.covariance[4] + d.covariance[8];
      reached.push({variance + more, next, *poses[place] * (forwards ? moved : inverse(moved))});
    }
  };
  for (std::size_t place = 0; place < poses.size(); ++place) {
    if (poses[place]) go_on(place, 0);
  }
  while (!reached.empty()) {
    const Reached next = reached.top();
    reached.pop();
    if (done[next.place]) continue;
    poses[next.place] = next.pose;
    go_on(next.place, next.variance);
  }
  for (const auto& pose : poses) {
    if (!pose) throw std::invalid_argument("the displacements do not join all places");
  }
}

ceres::Solver::Options solver_options(std::size_t places) {
  ceres::Solver::Options options;
  options.linear_solver_type =
      places <= most_dense_places ? ceres::DENSE_NORMAL_CHOLESKY : ceres::SPARSE_NORMAL_CHOLESKY;
  // Of those that Ceres knows, this one never makes threads of its own.
  options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  // Begins as good as undamped: damped from the start, the slow bends of a large map take twice as
  // many steps.
  options.initial_trust_region_radius = 1e14;
  options.max_num_iterations = 100;
  // So close that the order of the input does not show.
  options.function_tolerance = 1e-13;
  options.gradient_tolerance = 1e-9;
  options.parameter_tolerance = 1e-11;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  return options;
}

// Ceres logs a step that fails, and who has not set up a log finds that on the standard error.
// The log's header comes with Ceres' own.
class WithoutLog {
 public:
  WithoutLog() { FLAGS_minloglevel = google::GLOG_FATAL; }
  ~WithoutLog() { FLAGS_minloglevel = before_; }
  WithoutLog(const WithoutLog&) = delete;
  WithoutLog& operator=(const WithoutLog&) = delete;

 private:
  int before_ = FLAGS_minloglevel;
};

}  // namespace

Layout lay_out(std::size_t places, std::span<const PlaceDisplacement> displacements,
               const LayoutOptions& options) {
  require_valid(places, displacements);
  std::vector<std::optional<Pose2>> start(places);
  for (std::size_t i = 0; i < std::min(places, options.start.size()); ++i)
    start[i] = options.start[i];
  if (!start[0]) start[0] = Pose2{};
  place_others(start, displacements);

  std::vector<Parameters> parameters;
  for (const auto& at : start) parameters.push_back({at->x_m, at->y_m, at->heading_rad});
  std::deque<Cost> costs;
  ceres::Problem::Options problem_options;
  problem_options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  problem_options.disable_all_safety_checks = true;
  ceres::Problem problem(problem_options);
  for (const auto& [from, to, displacement] : displacements)
    problem.AddResidualBlock(&costs.emplace_back(displacement), nullptr,
                             parameters[from.index()].data(), parameters[to.index()].data());
  Layout layout;
  if (!displacements.empty()) {
    problem.SetParameterBlockConstant(parameters[0].data());
    ceres::Solver::Summary summary;
    const WithoutLog silence;
    ceres::Solve(solver_options(places), &problem, &summary);
    // Where the numbers are too large or too small to be squared.
    if (!summary.IsSolutionUsable() || !std::isfinite(summary.final_cost))
      throw std::invalid_argument("the displacements cannot be laid out: " + summary.message);
    layout.chi_squared = 2 * summary.final_cost;
  }
  for (const auto& [x_m, y_m, heading_rad] : parameters)
    layout.layout_from_place.push_back({x_m, y_m, wrapped(heading_rad)});
  if (options.with_covariances)
    layout.covariances = LayoutCovariance(layout.layout_from_place, displacements).of_places();
  return layout;
}

}  // namespace asterism
