#include "ritz/runtime/reconstruction.hpp"

#include <cstring>
#include <numeric>
#include <vector>

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

/// The rows of a panel.
template <class Scalar>
constexpr Index panel_rows = 4 * lanes<Scalar>;

/// A panel's rows are those of four registers: one number of x serves them all, and no sum crosses a register.
template <class Scalar>
RITZ_INLINE void multiply_each_panel(const Scalar* panels, Index rows, Index columns, const double* x, Scalar* y) {
  constexpr Index height = panel_rows<Scalar>, count = height / lanes<Scalar>;
  for (Index i = 0; i < rows; i += height) {
    Pack<Scalar> sums[count] = {};
    for (Index j = 0; j < columns; ++j, panels += height) {
      const auto factor = static_cast<Scalar>(x[j]);
      for (Index k = 0; k < count; ++k) sums[k] += packs(panels)[k] * factor;
    }
    if (i + height <= rows) std::memcpy(y + i, sums, sizeof(sums));
    else std::memcpy(y + i, sums, static_cast<std::size_t>(rows - i) * sizeof(Scalar));
  }
}

/// y = A x for an A in panels of panel_rows rows, each column by column and aligned to a cache line; the last one is
/// filled up with any rows. y has `rows` numbers.
RITZ_WIDE void multiply_panels(const double* panels, Index rows, Index columns, const double* x, double* y) {
  multiply_each_panel(panels, rows, columns, x, y);
}

RITZ_WIDE void multiply_panels(const float* panels, Index rows, Index columns, const double* x, float* y) {
  multiply_each_panel(panels, rows, columns, x, y);
}

}  // namespace

void reconstruct(const model::Basis& basis, Eigen::Ref<const Eigen::VectorXd> z, model::Points& displacements) {
  multiply_rows(basis.U.data(), basis.U.rows(), basis.U.cols(), z.data(), displacements.data());
}

template <class Scalar>
Reconstruction<Scalar> make_reconstruction(const model::Basis& basis, std::span<const std::int64_t> rows) {
  constexpr Eigen::Index height = panel_rows<Scalar>;
  const auto columns = basis.U.cols(), vertices = std::ssize(rows);
  const auto panels = (3 * vertices + height - 1) / height;
  Reconstruction<Scalar> copy{vertices, columns,
                              AlignedVector<Scalar>(static_cast<std::size_t>(panels * height * columns))};
  for (Eigen::Index i = 0; i < 3 * vertices; ++i) {
    const auto row = basis.U.row(3 * rows[static_cast<std::size_t>(i / 3)] + i % 3);
    auto* into = copy.panels.data() + i / height * height * columns + i % height;
    for (Eigen::Index j = 0; j < columns; ++j) into[j * height] = static_cast<Scalar>(row[j]);
  }
  return copy;
}

template <class Scalar>
Reconstruction<Scalar> make_reconstruction(const model::Basis& basis) {
  std::vector<std::int64_t> all(static_cast<std::size_t>(basis.U.rows() / 3));
  std::iota(all.begin(), all.end(), 0);
  return make_reconstruction<Scalar>(basis, all);
}

template <class Scalar>
void reconstruct(const Reconstruction<Scalar>& reconstruction, Eigen::Ref<const Eigen::VectorXd> z,
                 Displacements<Scalar>& displacements) {
  const auto& [vertices, columns, panels] = reconstruction;
  multiply_panels(panels.data(), 3 * vertices, columns, z.data(), displacements.data());
}

Eigen::MatrixXd mean_rows(const model::Basis& basis, std::span<const std::int64_t> rows) {
  Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(3, basis.U.cols());
  for (const auto row : rows) mean += basis.U.middleRows<3>(3 * row);
  return mean / static_cast<double>(rows.size());
}

#define RITZ_INSTANCE(S)                                                                              \
  template Reconstruction<S> make_reconstruction(const model::Basis&);                                \
  template Reconstruction<S> make_reconstruction(const model::Basis&, std::span<const std::int64_t>); \
  template void reconstruct(const Reconstruction<S>&, Eigen::Ref<const Eigen::VectorXd>, Displacements<S>&);
RITZ_INSTANCE(double)
RITZ_INSTANCE(float)
#undef RITZ_INSTANCE

}  // namespace ritz::runtime
