#include "ritz/runtime/reconstruction.hpp"

#include "ritz/base/simd.hpp"

namespace ritz::runtime {
namespace {

using Index = std::ptrdiff_t;

/// A register that is read from anywhere.
typedef double Loose __attribute__((vector_size(32), aligned(8), may_alias));

RITZ_INLINE const Loose& load(const double* p) { return *reinterpret_cast<const Loose*>(p); }

RITZ_INLINE double sum(const Pack<double>& p) { return (p[0] + p[1]) + (p[2] + p[3]); }

/// y[k] = Σ_j A[k, j] x[j] for `count` rows at a time, so that each register of x serves them all.
template <Index count>
RITZ_INLINE void multiply_some(const double* A, Index columns, const double* x, double* y) {
  constexpr Index width = lanes<double>;
  Pack<double> sums[count] = {};
  Index j = 0;
  for (; j + width <= columns; j += width) {
    const Pack<double> factors = load(x + j);
    for (Index k = 0; k < count; ++k) sums[k] += load(A + k * columns + j) * factors;
  }
  double rest[count] = {};
  for (; j < columns; ++j)
    for (Index k = 0; k < count; ++k) rest[k] += A[k * columns + j] * x[j];
  for (Index k = 0; k < count; ++k) y[k] = sum(sums[k]) + rest[k];
}

/// y = A x for a row-major A, rows x columns, at the speed at which memory delivers A. No array needs an alignment.
RITZ_WIDE void multiply_rows(const double* A, Index rows, Index columns, const double* x, double* y) {
  constexpr Index count = 4;
  Index i = 0;
  for (; i + count <= rows; i += count) multiply_some<count>(A + i * columns, columns, x, y + i);
  for (; i < rows; ++i) multiply_some<1>(A + i * columns, columns, x, y + i);
}

}  // namespace

void reconstruct(const model::Basis& basis, Eigen::Ref<const Eigen::VectorXd> z, model::Points& displacements) {
  multiply_rows(basis.U.data(), basis.U.rows(), basis.U.cols(), z.data(), displacements.data());
}

Eigen::MatrixXd mean_rows(const model::Basis& basis, std::span<const std::int64_t> rows) {
  Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(3, basis.U.cols());
  for (const auto row : rows) mean += basis.U.middleRows<3>(3 * row);
  return mean / static_cast<double>(rows.size());
}

}  // namespace ritz::runtime
