#include "ritz/stages/derivatives.hpp"

#include "ritz/base/simd.hpp"
#include "ritz/fem/element.hpp"
#include "ritz/stages/each_cell.hpp"

namespace ritz::stages {
namespace {

constexpr int lanes = 8;  ///< modes side by side, so that one instruction serves several pairs

int padded(int modes) { return (modes + lanes - 1) / lanes * lanes; }

/// What the lanes of row i hold: j from i rounded down to the padded number of modes.
int first_lane(int i) { return i / lanes * lanes; }

/// Displacement gradients (9 rows) and stresses S(G) (6: xx yy zz xy yz zx) at one point, a column a mode.
using Modal = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct Point {
  Modal G, S;
};

/// One quadrature point of one cell: everything that the inner loop needs.
struct Inner {
  int vertices;
  const double* gradients;  ///< weight ∇N_a, 3 a vertex
  const fem::ElasticConstants& elastic;
  int width;  ///< padded number of modes
  const double *G, *S;
};

/// Adds what the constants of third order make of two strains e and h (xx yy zz xy yz zx), for a lane each, to P:
/// A (e h + h e) + 2B (tr e h + tr h e + e : h I) + 2C tr e tr h I.
template <class Lanes>
inline __attribute__((always_inline)) void add_third_order(const fem::ElasticConstants& c, const double (&e)[6],
                                                           const double* G, int w, int l, Lanes& P) {
  const double h[6] = {G[l],
                       G[4 * w + l],
                       G[8 * w + l],
                       (G[w + l] + G[3 * w + l]) / 2,
                       (G[5 * w + l] + G[7 * w + l]) / 2,
                       (G[2 * w + l] + G[6 * w + l]) / 2};
  const double of_e = e[0] + e[1] + e[2], of_h = h[0] + h[1] + h[2];
  const double product = e[0] * h[0] + e[1] * h[1] + e[2] * h[2] + 2 * (e[3] * h[3] + e[4] * h[4] + e[5] * h[5]);
  const double all = 2 * c.B * product + 2 * c.C * of_e * of_h;
  const double xx = 2 * (e[0] * h[0] + e[3] * h[3] + e[5] * h[5]), yy = 2 * (e[3] * h[3] + e[1] * h[1] + e[4] * h[4]),
               zz = 2 * (e[5] * h[5] + e[4] * h[4] + e[2] * h[2]);
  const double xy = e[0] * h[3] + e[3] * h[1] + e[5] * h[4] + h[0] * e[3] + h[3] * e[1] + h[5] * e[4];
  const double yz = e[3] * h[5] + e[1] * h[4] + e[4] * h[2] + h[3] * e[5] + h[1] * e[4] + h[4] * e[2];
  const double zx = e[5] * h[0] + e[4] * h[3] + e[2] * h[5] + h[5] * e[0] + h[4] * e[3] + h[2] * e[5];
  const double s[6] = {xx, yy, zz, xy, yz, zx};
  constexpr int place[9] = {0, 3, 5, 3, 1, 4, 5, 4, 2};  // row by row
  for (int r = 0; r < 9; ++r) {
    const int k = place[r];
    P[r][l] += c.A * s[k] + 2 * c.B * (of_e * h[k] + of_h * e[k]) + (r % 4 == 0 ? all : 0);
  }
}

/// Adds C of the strains q (xx yy zz 2xy 2yz 2zx), for a lane each, to P.
template <class Lanes>
inline __attribute__((always_inline)) void add_stress(const fem::Matrix<6, 6>& C, const Lanes (&q)[6], Lanes (&P)[9]) {
  constexpr int place[9] = {0, 3, 5, 3, 1, 4, 5, 4, 2};  // row by row
  for (int r = 0; r < 9; ++r)
    for (int k = 0; k < 6; ++k) {
      const double factor = C(place[r], k);
      for (int l = 0; l < lanes; ++l) P[r][l] += factor * q[k][l];
    }
}

/// Adds row i's pairs to `to`, 3 rows a vertex of the cell, `width` apart.
RITZ_WIDE void add_row(const Inner& in, int i, double* to, int stride) {
  const int start = first_lane(i);
  const double lambda = in.elastic.lambda, mu = in.elastic.mu;
  const bool third_order = in.elastic.has_third_order();
  double g[9], s[6];
  for (int r = 0; r < 9; ++r) g[r] = in.G[r * in.width + i];
  for (int r = 0; r < 6; ++r) s[r] = in.S[r * in.width + i];
  const double strain[6] = {g[0], g[4], g[8], (g[1] + g[3]) / 2, (g[5] + g[7]) / 2, (g[2] + g[6]) / 2};
  for (int j = start; j < in.width; j += lanes) {
    const double *G = in.G + j, *S = in.S + j;
    const int w = in.width;
    double P[9][lanes], q[6][lanes];  // q = G_iᵀ G_j, symmetrised; matrices are stored row by row
    for (int l = 0; l < lanes; ++l) {
      const double a[9] = {G[l],         G[w + l],     G[2 * w + l], G[3 * w + l], G[4 * w + l],
                           G[5 * w + l], G[6 * w + l], G[7 * w + l], G[8 * w + l]};
      const double t[6] = {S[l], S[w + l], S[2 * w + l], S[3 * w + l], S[4 * w + l], S[5 * w + l]};
      q[0][l] = g[0] * a[0] + g[3] * a[3] + g[6] * a[6];
      q[1][l] = g[1] * a[1] + g[4] * a[4] + g[7] * a[7];
      q[2][l] = g[2] * a[2] + g[5] * a[5] + g[8] * a[8];
      q[3][l] = g[0] * a[1] + g[3] * a[4] + g[6] * a[7] + g[1] * a[0] + g[4] * a[3] + g[7] * a[6];
      q[4][l] = g[1] * a[2] + g[4] * a[5] + g[7] * a[8] + g[2] * a[1] + g[5] * a[4] + g[8] * a[7];
      q[5][l] = g[2] * a[0] + g[5] * a[3] + g[8] * a[6] + g[0] * a[2] + g[3] * a[5] + g[6] * a[8];
      for (int r = 0; r < 3; ++r) {
        const double *b = g + 3 * r, *c = a + 3 * r;
        P[3 * r][l] = b[0] * t[0] + b[1] * t[3] + b[2] * t[5] + c[0] * s[0] + c[1] * s[3] + c[2] * s[5];
        P[3 * r + 1][l] = b[0] * t[3] + b[1] * t[1] + b[2] * t[4] + c[0] * s[3] + c[1] * s[1] + c[2] * s[4];
        P[3 * r + 2][l] = b[0] * t[5] + b[1] * t[4] + b[2] * t[2] + c[0] * s[5] + c[1] * s[4] + c[2] * s[2];
      }
    }
    if (in.elastic.moduli) add_stress(*in.elastic.moduli, q, P);
    else
      for (int l = 0; l < lanes; ++l) {
        const double trace = lambda * (q[0][l] + q[1][l] + q[2][l]);
        P[0][l] += trace + 2 * mu * q[0][l];
        P[4][l] += trace + 2 * mu * q[1][l];
        P[8][l] += trace + 2 * mu * q[2][l];
        P[1][l] += mu * q[3][l];
        P[3][l] += mu * q[3][l];
        P[5][l] += mu * q[4][l];
        P[7][l] += mu * q[4][l];
        P[2][l] += mu * q[5][l];
        P[6][l] += mu * q[5][l];
      }
    if (third_order)
      for (int l = 0; l < lanes; ++l) add_third_order(in.elastic, strain, G, w, l, P);
    for (int v = 0; v < in.vertices; ++v) {
      const double* n = in.gradients + 3 * v;
      for (int c = 0; c < 3; ++c) {
        double* sum = to + static_cast<std::ptrdiff_t>(3 * v + c) * stride + (j - start);
        for (int l = 0; l < lanes; ++l) sum[l] += n[0] * P[3 * c][l] + n[1] * P[3 * c + 1][l] + n[2] * P[3 * c + 2][l];
      }
    }
  }
}

/// Rows [first, last) of pairs, their lanes one after the other.
struct Rows {
  int first, last, modes;
  std::vector<int> starts;  ///< of each row among the columns
  int columns = 0;

  Rows(int first_row, int last_row, int count) : first(first_row), last(last_row), modes(count) {
    for (int i = first; i < last; ++i) {
      starts.push_back(columns);
      columns += padded(modes) - first_lane(i);
    }
  }
  int start(int i) const { return starts[static_cast<std::size_t>(i - first)]; }
};

void gradients_of(const fem::GradientsRef& shape, const Modal& u, const fem::ElasticConstants& elastic, Point& point) {
  for (int c = 0; c < 3; ++c)
    for (int d = 0; d < 3; ++d) {
      auto row = point.G.row(3 * c + d);
      row = shape(0, d) * u.row(c);
      for (int a = 1; a < shape.rows(); ++a) row += shape(a, d) * u.row(3 * a + c);
    }
  const auto& G = point.G;
  if (elastic.moduli) {
    Modal strain(6, G.cols());
    strain << G.row(0), G.row(4), G.row(8), G.row(1) + G.row(3), G.row(5) + G.row(7), G.row(2) + G.row(6);
    point.S.noalias() = *elastic.moduli * strain;
    return;
  }
  const Eigen::RowVectorXd trace = elastic.lambda * (G.row(0) + G.row(4) + G.row(8));
  for (int c = 0; c < 3; ++c) point.S.row(c) = trace + 2 * elastic.mu * G.row(4 * c);
  point.S.row(3) = elastic.mu * (G.row(1) + G.row(3));
  point.S.row(4) = elastic.mu * (G.row(5) + G.row(7));
  point.S.row(5) = elastic.mu * (G.row(2) + G.row(6));
}

/// The sums of one cell for all rows: 3 rows a vertex.
void cell_sums(const Cell& cell, mesh::LocalRef local, const Rows& rows, Modal& u, Point& point, Modal& sums) {
  const int vertices = cell.count();
  for (int a = 0; a < vertices; ++a)
    mesh::at_vertex(u.leftCols(rows.modes), a) = mesh::at_vertex(local, cell.vertex(a));
  // Differences from the first vertex: a cell that moves far as a whole is not strained.
  for (int a = vertices - 1; a >= 0; --a) mesh::at_vertex(u, a) -= mesh::at_vertex(u, 0);
  const fem::IntegrationPoints points(cell.type, cell.x);
  const auto elastic = cell.material.at_rest();
  sums.topRows(mesh::components * vertices).setZero();
  for (int q = 0; q < points.count(); ++q) {
    const auto shape = points.gradients(q);
    gradients_of(shape, u, elastic, point);
    const fem::CellVectors weighted = -points.weight(q) * shape.transpose();
    const Inner inner{vertices,       weighted.data(), elastic, static_cast<int>(point.G.cols()),
                      point.G.data(), point.S.data()};
    for (int i = rows.first; i < rows.last; ++i)
      add_row(inner, i, sums.data() + rows.start(i), static_cast<int>(sums.cols()));
  }
}

/// From lanes to pairs, and from owned vertices to free degrees of freedom.
mesh::FreeRows columns_of_pairs(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const Rows& rows, const Modal& sums) {
  const auto pairs = pairs_of_rows(rows.first, rows.last, rows.modes);
  algebra::Tall b(dofs.owned, static_cast<Eigen::Index>(pairs.size()));
  std::vector<Eigen::Index> place(static_cast<std::size_t>(dofs.owned));
  for (int v = 0; v < mesh.owned; ++v)
    for (int c = 0; c < mesh::components; ++c)
      if (!dofs.fixed(v, c)) place[static_cast<std::size_t>(dofs.number(v, c) - dofs.first)] = mesh::components * v + c;
  constexpr Eigen::Index strip = 64;  // rows that stay in cache while all their columns are taken
  for (Eigen::Index from = 0; from < b.rows(); from += strip)
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      const int column = rows.start(pairs[p].i) + pairs[p].j - first_lane(pairs[p].i);
      for (Eigen::Index row = from; row < std::min(from + strip, b.rows()); ++row)
        b(row, static_cast<Eigen::Index>(p)) = sums(place[static_cast<std::size_t>(row)], column);
    }
  return b;
}

}  // namespace

std::vector<Pair> pairs_of_rows(int first, int last, int modes) {
  std::vector<Pair> pairs;
  for (int i = first; i < last; ++i)
    for (int j = i; j < modes; ++j) pairs.push_back({i, j});
  return pairs;
}

mesh::FreeRows derivative_loads(const Problem& problem, mesh::LocalRef local, int first, int last) {
  const mesh::Mesh& mesh = problem.mesh;
  const Rows rows(first, last, static_cast<int>(local.cols()));
  const int width = padded(rows.modes);
  Modal sums = Modal::Zero(mesh::components * mesh.owned, rows.columns);
  Modal u = Modal::Zero(mesh::components * fem::max_cell_vertices, width),
        of_cell(3 * fem::max_cell_vertices, rows.columns);
  Point point{Modal(9, width), Modal(6, width)};
  each_cell(mesh, problem.materials, [&](const Cell& cell) {
    cell_sums(cell, local, rows, u, point, of_cell);
    for (int a = 0; a < cell.count(); ++a)
      if (const int v = cell.vertex(a); v < mesh.owned) mesh::at_vertex(sums, v) += mesh::at_vertex(of_cell, a);
  });
  return columns_of_pairs(mesh, problem.dofs, rows, sums);
}

}  // namespace ritz::stages
