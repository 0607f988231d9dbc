#include "metric/layout_covariance.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <stdexcept>

#include "metric/layout_residual.hpp"

namespace asterism {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Sparse = Eigen::SparseMatrix<double>;
using Factor = Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Eigen::NaturalOrdering<int>>;

std::size_t at(Index index) { return static_cast<std::size_t>(index); }

// In which order to eliminate the places but the first, so that the factor stays sparse: by place,
// its turn. Of places, not of their coordinates: then a place's three stay together.
std::vector<Index> turns(std::size_t places, std::span<const PlaceDisplacement> displacements) {
  std::vector<Eigen::Triplet<double>> neighbours;
  for (const auto& [from, to, displacement] : displacements) {
    if (from.index() == 0 || to.index() == 0) continue;
    neighbours.emplace_back(from.index() - 1, to.index() - 1, 1);
    neighbours.emplace_back(to.index() - 1, from.index() - 1, 1);
  }
  // Without itself among its neighbours, a place would be taken for one joined to all.
  const auto others = static_cast<Index>(places - 1);
  for (Index place = 0; place < others; ++place) neighbours.emplace_back(place, place, 1);
  Sparse graph(others, others);
  graph.setFromTriplets(neighbours.begin(), neighbours.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> place_by_turn;
  Eigen::AMDOrdering<int>()(graph, place_by_turn);
  std::vector<Index> result(places, 0);
  for (Index turn = 0; turn < others; ++turn) result[at(place_by_turn.indices()[turn]) + 1] = turn;
  return result;
}

// Sum of Jᵀ J over the displacements, lower half; the first place, being certain, has no rows.
Sparse curvature(std::span<const Pose2> layout_from_place,
                 std::span<const PlaceDisplacement> displacements,
                 const std::vector<Index>& turns) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(displacements.size() * 27);
  const auto add = [&](std::size_t row_place, std::size_t column_place,
                       const Eigen::Matrix3d& block) {
    if (row_place == 0 || column_place == 0) return;
    for (Index row = 0; row < 3; ++row) {
      for (Index column = 0; column < 3; ++column) {
        const Index i = 3 * turns[row_place] + row;
        const Index j = 3 * turns[column_place] + column;
        if (i >= j) entries.emplace_back(i, j, block(row, column));
      }
    }
  };
  for (const auto& [from, to, displacement] : displacements) {
    const auto value = LayoutResidual(displacement)(layout_from_place[from.index()],
                                                    layout_from_place[to.index()]);
    add(from.index(), from.index(), value.by_from.transpose() * value.by_from);
    add(to.index(), to.index(), value.by_to.transpose() * value.by_to);
    add(from.index(), to.index(), value.by_from.transpose() * value.by_to);
    add(to.index(), from.index(), value.by_to.transpose() * value.by_from);
  }
  const auto size = static_cast<Index>(3 * (layout_from_place.size() - 1));
  Sparse result(size, size);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

// The numbers of Z = (L D Lᵀ)⁻¹ near its diagonal, from the last columns back             [TFC73].
// Columns J of L that follow each other and have the same rows R below them are done at once:
//
//   Z_RJ = -Z_RR U,   Z_JJ = L_JJ⁻ᵀ D_J⁻¹ L_JJ⁻¹ - Uᵀ Z_RJ,   U = L_RJ L_JJ⁻¹
//
// All of Z_RR is known by then: it is part of what was worked out for the first of R.
class SparseInverse {
 public:
  explicit SparseInverse(const Factor& factor)
      : lower_(factor.matrixL().nestedExpression()), pivots_(factor.vectorD()) {
    find_groups();
    block_of_.resize(at(lower_.cols()) / 3);
    position_.resize(at(lower_.cols()));
    for (std::size_t group = groups_.size(); group-- > 0;) invert(group);
  }

  /// Three by three numbers on the diagonal.
  const Eigen::Matrix3d& block(Index index) const { return block_of_[at(index)]; }

 private:
  struct Group {
    Index begin = 0;
    Index end = 0;
    std::size_t waiting = 0;  ///< groups whose Z_RR is part of this one's Z
    MatrixXd inverse = {};    ///< Z of J and R, kept as long as any waits for it
  };

  Index rows_below(Index column) const {
    return lower_.outerIndexPtr()[column + 1] - lower_.outerIndexPtr()[column];
  }
  std::span<const int> rows(Index column) const {
    return {lower_.innerIndexPtr() + lower_.outerIndexPtr()[column], at(rows_below(column))};
  }
  // The rows of a group below its columns.
  std::span<const int> rows(const Group& group) const { return rows(group.end - 1); }

  void find_groups() {
    group_of_.resize(at(lower_.cols()));
    for (Index column = 0; column < lower_.cols(); ++column) {
      // Rows below are always among those of the first of them, so that counting them is enough.
      const bool goes_on = column > 0 && rows_below(column - 1) == rows_below(column) + 1 &&
                           rows(column - 1).front() == column;
      if (!goes_on) groups_.push_back({column, column});
      groups_.back().end = column + 1;
      group_of_[at(column)] = groups_.size() - 1;
    }
    for (const Group& group : groups_)
      if (!rows(group).empty()) ++above(group).waiting;
  }

  Group& above(const Group& group) { return groups_[group_of_[at(rows(group).front())]]; }

  void invert(std::size_t which) {
    Group& group = groups_[which];
    const Index columns = group.end - group.begin;
    const auto below = static_cast<Index>(rows(group).size());
    MatrixXd unit = MatrixXd::Identity(columns, columns);  // L_JJ
    MatrixXd u(below, columns);                            // L_RJ, to begin with
    for (Index k = 0; k < columns; ++k) {
      const double* const values = lower_.valuePtr() + lower_.outerIndexPtr()[group.begin + k];
      const Index inside = columns - k - 1;
      unit.col(k).tail(inside) = Eigen::Map<const Eigen::VectorXd>(values, inside);
      u.col(k) = Eigen::Map<const Eigen::VectorXd>(values + inside, below);
    }
    const auto triangle = unit.triangularView<Eigen::UnitLower>();
    if (below > 0) triangle.solveInPlace<Eigen::OnTheRight>(u);
    const MatrixXd root = triangle.solve(MatrixXd::Identity(columns, columns));

    MatrixXd z(columns + below, columns + below);
    if (below > 0) {
      z.bottomRightCorner(below, below) = taken_from_above(group);
      z.bottomLeftCorner(below, columns).noalias() = -z.bottomRightCorner(below, below) * u;
      z.topRightCorner(columns, below) = z.bottomLeftCorner(below, columns).transpose();
    }
    z.topLeftCorner(columns, columns).noalias() =
        root.transpose() * pivots_.segment(group.begin, columns).cwiseInverse().asDiagonal() * root;
    if (below > 0)
      z.topLeftCorner(columns, columns).noalias() -=
          u.transpose() * z.bottomLeftCorner(below, columns);
    for (Index k = 0; k < columns; k += 3)
      block_of_[at((group.begin + k) / 3)] = z.block<3, 3>(k, k);
    if (group.waiting > 0) group.inverse = std::move(z);
  }

  // Z_RR. The last to ask lets go of where it is from.
  MatrixXd taken_from_above(const Group& group) {
    Group& from = above(group);
    for (Index column = from.begin; column < from.end; ++column)
      position_[at(column)] = column - from.begin;
    Index next = from.end - from.begin;
    for (const int row : rows(from)) position_[at(row)] = next++;
    std::vector<Index> here;
    for (const int row : rows(group)) here.push_back(position_[at(row)]);
    MatrixXd result = from.inverse(here, here);
    if (--from.waiting == 0) from.inverse.resize(0, 0);
    return result;
  }

  const Sparse& lower_;  ///< L, strictly below the diagonal
  Eigen::VectorXd pivots_;
  std::vector<Group> groups_;
  std::vector<std::size_t> group_of_;  ///< of each column
  std::vector<Index> position_;        ///< of each row, in the Z that is taken from
  std::vector<Eigen::Matrix3d> block_of_;
};

}  // namespace

LayoutCovariance::LayoutCovariance(std::span<const Pose2> layout_from_place,
                                   std::span<const PlaceDisplacement> displacements)
    : layout_from_place_(layout_from_place.begin(), layout_from_place.end()),
      turns_(turns(layout_from_place.size(), displacements)) {
  if (layout_from_place.size() < 2) return;
  factor_.compute(curvature(layout_from_place, displacements, turns_));
  if (factor_.info() != Eigen::Success)
    throw std::invalid_argument("the displacements do not fix all places");
}

std::vector<PoseCovariance> LayoutCovariance::of_places() const {
  std::vector<PoseCovariance> result(layout_from_place_.size(), PoseCovariance{});
  if (result.size() < 2) return result;
  const SparseInverse inverse(factor_);
  for (std::size_t place = 1; place < result.size(); ++place) {
    const Point2 facing = unit_vector(layout_from_place_[place].heading_rad);
    LayoutResidual::Matrix3 motion_by_coordinates;
    motion_by_coordinates << facing.x_m, facing.y_m, 0, -facing.y_m, facing.x_m, 0, 0, 0, 1;
    Eigen::Map<LayoutResidual::Matrix3>{result[place].data()} =
        motion_by_coordinates * inverse.block(turns_[place]) * motion_by_coordinates.transpose();
  }
  return result;
}

// S = A H⁻¹ Aᵀ, where A is the slope by the places' coordinates and H the curvature.
PlaneCovariance LayoutCovariance::seen_from(const PlacePoint& one, const PlacePoint& other) const {
  if (layout_from_place_.size() < 2) return {};
  MatrixXd slope = MatrixXd::Zero(factor_.rows(), 2);  // Aᵀ
  const auto add = [&](PlaceId place, double sign, Point2 lever) {
    if (place.index() == 0) return;
    const Index first = 3 * turns_[place.index()];
    slope(first, 0) += sign;
    slope(first + 1, 1) += sign;
    slope(first + 2, 0) -= sign * lever.y_m;
    slope(first + 2, 1) += sign * lever.x_m;
  };
  const Pose2& from = layout_from_place_[one.place.index()];
  const Pose2& to = layout_from_place_[other.place.index()];
  const Point2 seen = to * other.point;
  add(one.place, -1, seen - from.position());  // all turns with who looks
  add(other.place, 1, seen - to.position());
  const Eigen::Matrix2d covariance = slope.transpose() * factor_.solve(slope);
  return {covariance(0, 0), (covariance(0, 1) + covariance(1, 0)) / 2, covariance(1, 1)};
}

}  // namespace asterism
