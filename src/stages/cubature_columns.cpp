#include "ritz/stages/cubature_columns.hpp"

#include "ritz/base/simd.hpp"
#include "ritz/runtime/polynomial_force.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The products of y with `count` columns, each of `rows` numbers.
RITZ_WIDE void multiply_columns(Index count, Index rows, const float* columns, const float* y, double* products) {
  constexpr Index width = 32;
  for (Index j = 0; j < count; ++j, columns += rows) {
    float sums[width] = {};
    Index i = 0;
    for (; i + width <= rows; i += width)
      for (Index l = 0; l < width; ++l) sums[l] += columns[i + l] * y[i + l];
    for (; i < rows; ++i) sums[0] += columns[i] * y[i];
    double sum = 0;
    for (Index l = 0; l < width; ++l) sum += static_cast<double>(sums[l]);
    products[j] = sum;
  }
}

}  // namespace

CubatureTargets CubatureTargets::of(Index first, Index count) const {
  return {z.middleCols(first, count), roots, scales.segment(first, count), sums.middleCols(first, count)};
}

MatrixXd CubatureTargets::scaled(const Eigen::Ref<const MatrixXd>& force) const {
  return roots.asDiagonal() * force * scales.asDiagonal();
}

CubatureTargets cubature_targets(const Poses& poses, const VectorXd& stiffness, const model::Polynomial& polynomial,
                                 model::Integrand integrand) {
  CubatureTargets targets{poses.z, stiffness.cwiseSqrt().cwiseInverse(), {}, poses.exact.forces};
  targets.scales = (targets.roots.asDiagonal() * targets.sums).colwise().norm().cwiseInverse();
  if (integrand == model::Integrand::energy) return targets;
  const auto force = runtime::make_polynomial_force<double>(polynomial);
  auto at = runtime::make_evaluation(force);
  for (Index s = 0; s < poses.z.cols(); ++s) {
    runtime::evaluate<double>(force, poses.z.col(s), at);
    targets.sums.col(s) -= at.force;
  }
  return targets;
}

CubatureColumns::CubatureColumns(const CellBasis& basis, model::Integrand integrand, const CubatureTargets& targets,
                                 const std::vector<int>& cells)
    : basis_(basis),
      integrand_(integrand),
      targets_(targets),
      cells_(cells),
      values_(targets.sums.size(), static_cast<Index>(cells.size())) {
  each_cell_force(basis, integrand, cells, targets.z, [&](Index place, const Eigen::Ref<const MatrixXd>& force) {
    values_.col(place) = targets.scaled(force).reshaped().cast<float>();
  });
  for (const int c : cells) {
    numbers_.push_back(basis.problem.mesh.cells.numbers[static_cast<std::size_t>(c)]);
    places_.emplace(numbers_.back(), places_.size());
  }
}

DistributedColumns CubatureColumns::distributed() const {
  DistributedColumns columns{numbers_, {}, {}};
  columns.products = [this](const VectorXd& y) {
    const Eigen::VectorXf rounded = y.cast<float>();
    VectorXd products(values_.cols());
    multiply_columns(values_.cols(), values_.rows(), values_.data(), rounded.data(), products.data());
    return products;
  };
  columns.columns = [this](const std::vector<Index>& places) {
    std::vector<int> cells;
    for (const Index place : places) cells.push_back(cells_[static_cast<std::size_t>(place)]);
    MatrixXd values(targets_.sums.size(), static_cast<Index>(cells.size()));
    each_cell_force(basis_, integrand_, cells, targets_.z, [&](Index place, const Eigen::Ref<const MatrixXd>& force) {
      values.col(place) = targets_.scaled(force).reshaped();
    });
    return values;
  };
  return columns;
}

std::vector<std::pair<int, double>> CubatureColumns::chosen(const NonnegativeFit& fit) const {
  std::vector<std::pair<int, double>> cells;
  for (std::size_t i = 0; i < fit.numbers.size(); ++i)
    if (const auto at = places_.find(fit.numbers[i]); at != places_.end())
      cells.emplace_back(cells_[at->second], fit.weights[static_cast<Index>(i)]);
  return cells;
}

}  // namespace ritz::stages
