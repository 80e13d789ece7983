#include "ritz/stages/reduce_polynomial.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "ritz/algebra/dense.hpp"
#include "ritz/fem/element.hpp"
#include "ritz/mesh/dofs.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/each_cell.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr int strains_count = 6;
constexpr Index panel_columns = 192;  ///< strains that one `dsyrk` takes

Index pair_count(Index r) { return r * (r + 1) / 2; }

/// The place of (i, j), i ≤ j, among the pairs in lexicographic order.
Index pair(Index r, Index i, Index j) { return i * r - i * (i - 1) / 2 + (j - i); }

using StrainColumns = Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;  ///< six columns: xx yy zz 2xy 2yz 2zx

/// Makes of strains six numbers each, whose squares sum up to weight S : E.
class Metric {
 public:
  Metric(const fem::ElasticConstants& law, double weight) : root_(std::sqrt(weight)) {
    if (law.moduli) factor_ = law.moduli->llt().matrixU();
    else isotropic_ = {law.lambda, law.mu};
  }

  void apply(StrainColumns strains) const {
    if (factor_) strains = (root_ * strains * factor_->transpose()).eval();
    else apply_isotropic(strains);
  }

 private:
  struct Isotropic {
    double lambda, mu;
  };

  /// λ tr² + 2μ|E|² by a E_ii + b tr with a = √(2μ), 3b² + 2ab = λ, and √(4μ) E_ij: where λ is much larger than μ,
  /// strains without a change of volume keep their digits.
  void apply_isotropic(StrainColumns strains) const {
    const double a = std::sqrt(2 * isotropic_.mu), b = (std::sqrt(a * a + 3 * isotropic_.lambda) - a) / 3;
    for (Index row = 0; row < strains.rows(); ++row) {
      const double trace = root_ * b * (strains(row, 0) + strains(row, 1) + strains(row, 2));
      for (int c = 0; c < 3; ++c) strains(row, c) = root_ * a * strains(row, c) + trace;
      for (int c = 3; c < strains_count; ++c) strains(row, c) *= root_ * std::sqrt(isotropic_.mu);
    }
  }

  double root_;
  Isotropic isotropic_{};
  std::optional<fem::Matrix<6, 6>> factor_;
};

/// The strains Q_ij for j = i ... r-1, into six columns `stride` apart. G: 9 x r, row by row.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
__attribute__((target_clones("arch=x86-64-v3", "default")))
#endif
void fill_pairs(const double* G, Index r, Index i, double* to, Index stride) {
  double g[9];
  for (int k = 0; k < 9; ++k) g[k] = G[k * r + i];
  double *s0 = to, *s1 = s0 + stride, *s2 = s1 + stride, *s3 = s2 + stride, *s4 = s3 + stride, *s5 = s4 + stride;
#pragma GCC ivdep
  for (Index j = i; j < r; ++j) {
    const double *a = G + j, *b = a + 3 * r, *c = b + 3 * r;
    const double ax = a[0], ay = a[r], az = a[2 * r], bx = b[0], by = b[r], bz = b[2 * r], cx = c[0], cy = c[r],
                 cz = c[2 * r];
    s0[j - i] = g[0] * ax + g[3] * bx + g[6] * cx;
    s1[j - i] = g[1] * ay + g[4] * by + g[7] * cy;
    s2[j - i] = g[2] * az + g[5] * bz + g[8] * cz;
    s3[j - i] = g[0] * ay + g[3] * by + g[6] * cy + g[1] * ax + g[4] * bx + g[7] * cx;
    s4[j - i] = g[1] * az + g[4] * bz + g[7] * cz + g[2] * ay + g[5] * by + g[8] * cy;
    s5[j - i] = g[2] * ax + g[5] * bx + g[8] * cx + g[0] * az + g[3] * bz + g[6] * cz;
  }
}

/// Strains as columns as long as y, until there are enough of them for one `dsyrk`.
class Panel {
 public:
  explicit Panel(Index r) : gram(Eigen::MatrixXd::Zero(size(r), size(r))), r_(r), strains_(size(r), panel_columns) {}

  Eigen::MatrixXd gram;  ///< upper triangle

  /// `G`: 9 x r, displacement gradients of all columns, row by row.
  void add(const RowMajor& G, const Metric& metric) {
    if (used_ + strains_count > panel_columns) flush();
    fill_linear(G);
    for (Index i = 0; i < r_; ++i) {
      const Index start = r_ + pair(r_, i, i);
      fill_pairs(G.data(), r_, i, &strains_(start, used_), size(r_));
      strains_.block(start, used_, 1, strains_count) /= 2;  // Q_ii = ½ G_iᵀG_i
    }
    metric.apply(strains_.middleCols(used_, strains_count));
    used_ += strains_count;
  }

  void flush() {
    algebra::add_gram(gram, strains_.leftCols(used_));
    used_ = 0;
  }

 private:
  static Index size(Index r) { return r + pair_count(r); }

  void fill_linear(const RowMajor& G) {
    auto to = strains_.block(0, used_, r_, strains_count);
    for (int c = 0; c < 3; ++c) to.col(c) = G.row(4 * c).transpose();
    to.col(3) = (G.row(1) + G.row(3)).transpose();
    to.col(4) = (G.row(5) + G.row(7)).transpose();
    to.col(5) = (G.row(2) + G.row(6)).transpose();
  }

  Index r_;
  Eigen::MatrixXd strains_;
  Index used_ = 0;
};

void add_cell(const Cell& cell, const fem::ElasticConstants& law, const RowMajor& local, RowMajor& G, Panel& panel) {
  const fem::IntegrationPoints points(cell.type, cell.x);
  for (int q = 0; q < points.count(); ++q) {
    const auto shape = points.gradients(q);
    G.setZero();
    for (int a = 1; a < cell.count(); ++a)
      for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d)
          G.row(3 * c + d) += shape(a, d) * (local.row(mesh::components * cell.vertex(a) + c) -
                                             local.row(mesh::components * cell.vertex(0) + c));
    panel.add(G, Metric(law, points.weight(q)));
  }
}

/// The derivatives of s_ab = z_a z_b by z_a and z_b.
double twice_if_square(Index a, Index b) { return a == b ? 2 : 1; }

Eigen::VectorXd quadratic(const Eigen::MatrixXd& gram, Index r) {
  Eigen::VectorXd A(pair_count(r));
  for (Index i = 0, n = 0; i < r; ++i)
    for (Index j = i; j < r; ++j) A[n++] = gram(i, j);
  return A;
}

/// B_ijk = D_i,jk + D_j,ik + D_k,ij with D_m,ab = ∂³(z_m G_m,ab s_ab).
Eigen::VectorXd cubic(const Eigen::MatrixXd& gram, Index r) {
  const auto D = [&](Index m, Index a, Index b) { return gram(m, r + pair(r, a, b)) * twice_if_square(a, b); };
  Eigen::VectorXd B(pair_count(r) * (r + 2) / 3);
  Index n = 0;
  for (Index i = 0; i < r; ++i)
    for (Index j = i; j < r; ++j)
      for (Index k = j; k < r; ++k) B[n++] = D(i, j, k) + D(j, i, k) + D(k, i, j);
  return B;
}

/// C_ijkl = S_ij,kl + S_ik,jl + S_il,jk, the three ways to make two pairs of four indices.
Eigen::VectorXd quartic(const Eigen::MatrixXd& gram, Index r) {
  const auto S = [&](Index a, Index b, Index c, Index d) {
    const Index p = r + pair(r, a, b), q = r + pair(r, c, d);
    return gram(std::min(p, q), std::max(p, q)) * twice_if_square(a, b) * twice_if_square(c, d);
  };
  Eigen::VectorXd C(pair_count(r) * (r + 2) / 3 * (r + 3) / 4);
  Index n = 0;
  for (Index i = 0; i < r; ++i)
    for (Index j = i; j < r; ++j)
      for (Index k = j; k < r; ++k)
        for (Index l = k; l < r; ++l) C[n++] = S(i, j, k, l) + S(i, k, j, l) + S(i, l, j, k);
  return C;
}

}  // namespace

std::optional<PolynomialLaws> polynomial_laws(const fem::Materials& materials) {
  if (!fem::force_degree(materials)) return std::nullopt;
  return laws_at_rest(materials);
}

PolynomialLaws laws_at_rest(const fem::Materials& materials) {
  PolynomialLaws laws;
  for (const auto& material : materials) laws.push_back(material.at_rest());
  return laws;
}

model::Polynomial reduce_polynomial(const Problem& problem, const PolynomialLaws& laws, mesh::VertexRef u) {
  const mesh::Mesh& mesh = problem.mesh;
  const RowMajor local = mesh::with_ghosts(mesh, u, mesh::components);
  const Index r = u.cols();
  Panel panel(r);
  RowMajor G(9, r);
  each_owned_cell(mesh, problem.materials, [&](const Cell& cell) {
    add_cell(cell, laws[static_cast<std::size_t>(cell.region)], local, G, panel);
  });
  panel.flush();
  model::Polynomial polynomial{r, quadratic(panel.gram, r), cubic(panel.gram, r), quartic(panel.gram, r)};
  for (auto* part : {&polynomial.quadratic, &polynomial.cubic, &polynomial.quartic}) {
    Eigen::MatrixXd sums = *part;
    parallel::sum_in_place(mesh.comm, sums);
    *part = sums;
  }
  return polynomial;
}

}  // namespace ritz::stages
