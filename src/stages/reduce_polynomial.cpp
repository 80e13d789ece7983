#include "ritz/stages/reduce_polynomial.hpp"

#include <cmath>

#include "ritz/fem/dispatch.hpp"
#include "ritz/fem/strain.hpp"
#include "ritz/mesh/halo.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/petsc/gram.hpp"
#include "ritz/stages/vertex_graph.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr int strains = 6;
constexpr Index panel_rows = 192;  ///< strain rows that one `dsyrk` takes

Index pair_count(Index r) { return r * (r + 1) / 2; }

/// The place of (i, j), i ≤ j, among the pairs in lexicographic order.
Index pair(Index r, Index i, Index j) { return i * r - i * (i - 1) / 2 + (j - i); }

/// Six rows of numbers a strain is made of, whose squares sum up to weight S : E: for the material's energy
/// λ tr² + 2μ|E|², rows a E_ii + b tr with a = √(2μ), 3b² + 2ab = λ, and √(4μ) E_ij.
struct Metric {
  double direct, trace, shear;

  Metric(const fem::StVK& material, double weight) {
    const double root = std::sqrt(weight), a = std::sqrt(2 * material.mu());
    direct = root * a;
    trace = root * (std::sqrt(a * a + 3 * material.lambda()) - a) / 3;
    shear = root * std::sqrt(4 * material.mu());
  }
};

/// Rows of strains, transposed: a column of y's length a strain row, so that a cell writes contiguous numbers.
class Panel {
 public:
  explicit Panel(Index r) : gram(Eigen::MatrixXd::Zero(size(r), size(r))), r_(r), rows_(panel_rows, size(r)) {}

  Eigen::MatrixXd gram;  ///< upper triangle

  /// `G`: 9 x r, displacement gradients of all columns, row by row.
  void add(const RowMajor& G, const Metric& metric) {
    if (used_ + strains > panel_rows) flush();
    fill_linear(G, metric);
    for (Index i = 0; i < r_; ++i) fill_pairs(G, metric, i);
    used_ += strains;
  }

  void flush() {
    if (used_ == 0) return;
    block_ = rows_.topRows(used_);
    petsc::add_gram(gram, block_);
    used_ = 0;
  }

 private:
  static Index size(Index r) { return r + pair_count(r); }

  template <class A, class B, class C, class D, class E, class F>
  void store(Index column, Index count, const Metric& m, const A& xx, const B& yy, const C& zz, const D& xy,
             const E& yz, const F& zx) {
    trace_ = m.trace * (xx + yy + zz);
    rows_.row(used_).segment(column, count) = m.direct * xx + trace_;
    rows_.row(used_ + 1).segment(column, count) = m.direct * yy + trace_;
    rows_.row(used_ + 2).segment(column, count) = m.direct * zz + trace_;
    rows_.row(used_ + 3).segment(column, count) = m.shear * xy;
    rows_.row(used_ + 4).segment(column, count) = m.shear * yz;
    rows_.row(used_ + 5).segment(column, count) = m.shear * zx;
  }

  void fill_linear(const RowMajor& G, const Metric& m) {
    store(0, r_, m, G.row(0), G.row(4), G.row(8), (G.row(1) + G.row(3)) / 2, (G.row(5) + G.row(7)) / 2,
          (G.row(2) + G.row(6)) / 2);
  }

  /// Q_ij = sym(G_iᵀG_j) for j ≥ i; Q_ii = ½ G_iᵀG_i.
  void fill_pairs(const RowMajor& G, const Metric& m, Index i) {
    const Index count = r_ - i, column = r_ + pair(r_, i, i);
    const auto product = [&](Index a, Index b) {
      return G(a, i) * G.row(b).tail(count) + G(3 + a, i) * G.row(3 + b).tail(count) +
             G(6 + a, i) * G.row(6 + b).tail(count);
    };
    store(column, count, m, product(0, 0), product(1, 1), product(2, 2), (product(0, 1) + product(1, 0)) / 2,
          (product(1, 2) + product(2, 1)) / 2, (product(2, 0) + product(0, 2)) / 2);
    rows_.block(used_, column, strains, 1) /= 2;
  }

  Index r_;
  RowMajor rows_;
  Eigen::MatrixXd block_;
  Eigen::RowVectorXd trace_;
  Index used_ = 0;
};

template <class E>
void add_cell(const mesh::Mesh& mesh, int cell, const fem::StVK& material, const RowMajor& local, RowMajor& G,
              Panel& panel) {
  const auto vertices = mesh.cells.of(cell);
  const fem::Coordinates<E> x = fem::relative<E>(fem::Coordinates<E>(mesh.corners(cell)));
  const auto vertex = [&](int a) { return 3 * vertices[static_cast<std::size_t>(a)]; };
  for (const auto& sample : E::rule) {
    const auto [shape, weight] = fem::physical_gradients<E>(x, sample);
    G.setZero();
    for (int a = 1; a < E::vertices; ++a)
      for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d)
          G.row(3 * c + d) += shape(a, d) * (local.row(vertex(a) + c) - local.row(vertex(0) + c));
    panel.add(G, Metric(material, weight));
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

model::Polynomial reduce_polynomial(const mesh::Mesh& mesh, const std::vector<fem::StVK>& materials,
                                    const petsc::ConstTallRef& u) {
  const RowMajor local = mesh::with_ghosts(mesh, u);
  const Index r = u.cols();
  Panel panel(r);
  RowMajor G(9, r);
  for (const int c : file_order(mesh.cells)) {
    if (c >= mesh.cells.owned) continue;
    const auto n = static_cast<std::size_t>(c);
    const auto& material = materials[static_cast<std::size_t>(mesh.cells.regions[n])];
    fem::visit(mesh.cells.types[n], [&]<class E>(E) { add_cell<E>(mesh, c, material, local, G, panel); });
  }
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
