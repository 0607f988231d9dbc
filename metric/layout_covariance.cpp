#include <Eigen/SparseCholesky>
#include <algorithm>
#include <stdexcept>

#include "metric/layout_residual.hpp"

namespace asterism {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Order = Eigen::AMDOrdering<int>;
using Factor = Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Order>;

// Sum of Jᵀ J over the displacements, lower half; the first place, being certain, has no rows.
Sparse curvature(std::span<const Pose2> layout_from_place,
                 std::span<const PlaceDisplacement> displacements) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(displacements.size() * 27);
  const auto add = [&](std::size_t row_place, std::size_t column_place,
                       const Eigen::Matrix3d& block) {
    if (row_place == 0 || column_place == 0) return;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        const int i = static_cast<int>(3 * (row_place - 1)) + row;
        const int j = static_cast<int>(3 * (column_place - 1)) + column;
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
  const auto size = static_cast<Eigen::Index>(3 * (layout_from_place.size() - 1));
  Sparse result(size, size);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

// The entries of (L D Lᵀ)⁻¹ where L has entries, and the diagonal: from the last column back,
//   Z_ij = -Σ_k Z_ik L_kj,   Z_jj = 1 / D_j - Σ_k L_kj Z_kj   (i, k > j, L_kj ≠ 0)         [TFC73]
// Every Z_ik that this asks for lies on L's own pattern.
class SparseInverse {
 public:
  explicit SparseInverse(const Factor& factor)
      : inverse_(factor.matrixL().nestedExpression()), diagonal_(factor.vectorD().cwiseInverse()) {
    const auto size = static_cast<std::size_t>(inverse_.cols());
    std::vector<double> factor_column(size, 0);  // L_kj of the column j in work, elsewhere 0
    std::vector<double> sum(size, 0);            // Σ_k Z_ik L_kj, where L_ij is not 0
    for (int j = static_cast<int>(size) - 1; j >= 0; --j) {
      for (Sparse::InnerIterator l(inverse_, j); l; ++l) factor_column[at(l.row())] = l.value();
      for (Sparse::InnerIterator l(inverse_, j); l; ++l) {
        const auto k = static_cast<int>(l.row());
        sum[at(k)] += diagonal_[k] * l.value();
        for (Sparse::InnerIterator z(inverse_, k); z; ++z) {
          if (factor_column[at(z.row())] == 0) continue;
          sum[at(z.row())] += z.value() * l.value();
          sum[at(k)] += z.value() * factor_column[at(z.row())];
        }
      }
      for (Sparse::InnerIterator z(inverse_, j); z; ++z) {
        const std::size_t i = at(z.row());
        diagonal_[j] += factor_column[i] * sum[i];
        z.valueRef() = -sum[i];
        sum[i] = 0;
        factor_column[i] = 0;
      }
    }
  }

  double operator()(int row, int column) const {
    if (row == column) return diagonal_[row];
    return inverse_.coeff(std::max(row, column), std::min(row, column));
  }

 private:
  static std::size_t at(Eigen::Index row) { return static_cast<std::size_t>(row); }

  Sparse inverse_;  ///< strictly below the diagonal; begins as L
  Eigen::VectorXd diagonal_;
};

}  // namespace

std::vector<PoseCovariance> place_covariances(std::span<const Pose2> layout_from_place,
                                              std::span<const PlaceDisplacement> displacements) {
  std::vector<PoseCovariance> result(layout_from_place.size(), PoseCovariance{});
  if (layout_from_place.size() < 2) return result;
  const Factor factor(curvature(layout_from_place, displacements));
  if (factor.info() != Eigen::Success)
    throw std::invalid_argument("the displacements do not fix all places");
  const SparseInverse inverse(factor);
  const auto& position = factor.permutationP().indices();
  for (std::size_t place = 1; place < result.size(); ++place) {
    for (std::size_t i = 0; i < 9; ++i) {
      const auto row = static_cast<Eigen::Index>(3 * (place - 1) + i / 3);
      const auto column = static_cast<Eigen::Index>(3 * (place - 1) + i % 3);
      result[place][i] = inverse(position[row], position[column]);
    }
  }
  return result;
}

}  // namespace asterism
