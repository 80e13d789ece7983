#include "ritz/stages/patch_recovery.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "ritz/algebra/dense.hpp"
#include "ritz/fem/cell_matrices.hpp"
#include "ritz/fem/element.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/each_cell.hpp"
#include "ritz/stages/strain.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;

constexpr Index at_a_time = 8;             ///< columns of u at a time
constexpr int quadratic_from = 8;          ///< cells around a corner: of fewer, quadratic fits go astray outside
constexpr double least_determined = 1e-4;  ///< eigenvalue of the fit, relative to the largest
constexpr int of_strain = 6;               ///< xx yy zz xy yz zx of the tensor
constexpr int corners = 4;                 ///< of a tetrahedron
using Strains6 = Eigen::Matrix<double, of_strain, Eigen::Dynamic>;  ///< a column a place

/// 1, x, y, z and, if they are wanted, the six products of two, a row a place.
Eigen::MatrixXd monomials(const Eigen::Matrix3Xd& x, Index count) {
  Eigen::MatrixXd all(x.cols(), 10);
  all.col(0).setOnes();
  for (Index i = 0, at = 4; i < 3; ++i) {
    all.col(1 + i) = x.row(i);
    for (Index j = i; j < 3; ++j) all.col(at++) = x.row(i).cwiseProduct(x.row(j));
  }
  return all.leftCols(count);
}

/// Least squares: the matrix that takes values at the places of B's rows to the coefficients of B's columns.
Eigen::MatrixXd least_squares(const Eigen::MatrixXd& B) {
  const auto [values, vectors] = algebra::symmetric_eigen(B.transpose() * B);
  const double least = least_determined * values[values.size() - 1];
  const Eigen::VectorXd inverse = (values.array() > least).select(values.array().inverse(), 0.0);
  return vectors * inverse.asDiagonal() * vectors.transpose() * B.transpose();
}

/// The points of stiffness of some cells.
struct Samples {
  Eigen::Matrix3Xd places;  ///< m
  Strains6 values;          ///< of all columns of u, one after the other
};

Samples sample(const Problem& problem, const std::vector<int>& cells, const mesh::LocalRows& local) {
  const auto& rule = fem::element(fem::CellType::tet10).rule;
  const Index total = std::ssize(cells) * rule.count();
  Samples samples{Eigen::Matrix3Xd(3, total), Strains6(of_strain, total * local.cols())};
  Index at = 0;
  for (const int c : cells) {
    const Cell cell = cell_of(problem.mesh, problem.materials, c);
    const fem::IntegrationPoints points(cell.type, cell.x);
    for (int q = 0; q < points.count(); ++q, ++at) {
      samples.places.col(at) = cell.x * Eigen::Map<const Eigen::VectorXd>(
                                            &rule.values[static_cast<std::size_t>(cell.count() * q)], cell.count());
      for (Index j = 0; j < local.cols(); ++j)
        samples.values.col(total * j + at) = strain(cell.gather(local, j), points.gradients(q));
    }
  }
  return samples;
}

/// The share of one corner in ε* at the corner itself and in the middles of the edges there, all columns of u side by
/// side in a row a place.
struct Share {
  std::vector<int> vertices;
  Eigen::MatrixXd values;
};

Share share_of_corner(const Problem& problem, int corner, const std::vector<int>& cells, const mesh::LocalRows& local) {
  const mesh::Mesh& mesh = problem.mesh;
  const Samples samples = sample(problem, cells, local);
  const Eigen::Vector3d origin = mesh.points.col(corner);
  const Eigen::Matrix3Xd away = samples.places.colwise() - origin;
  const double size = away.cwiseAbs().maxCoeff();
  const Index terms = std::ssize(cells) < quadratic_from ? 4 : 10;

  std::set<int> middles;
  for (const int c : cells) {
    const auto vertices = mesh.cells.of(c);
    for (std::size_t e = 0; e < fem::detail::tet_edges.size(); ++e)
      for (const int end : fem::detail::tet_edges[e])
        if (vertices[static_cast<std::size_t>(end)] == corner) middles.insert(vertices[corners + e]);
  }
  Share share{{corner}, {}};
  share.vertices.insert(share.vertices.end(), middles.begin(), middles.end());
  const Eigen::Matrix3Xd to = (mesh.points(Eigen::all, share.vertices).colwise() - origin) / size;
  Eigen::MatrixXd weights = monomials(to, terms) * least_squares(monomials(away / size, terms));
  weights.bottomRows(weights.rows() - 1) /= 2;  // the other end of the edge has the other half

  share.values.resize(weights.rows(), of_strain * local.cols());
  for (Index j = 0; j < local.cols(); ++j)
    share.values.middleCols(of_strain * j, of_strain) =
        weights * samples.values.middleCols(away.cols() * j, away.cols()).transpose();
  return share;
}

/// ε* at all local vertices, six rows for each, over cells of one class of stiffness. *Collective*.
mesh::LocalRows recovered(const Problem& problem, int stiffness, const mesh::LocalRows& local) {
  const mesh::Mesh& mesh = problem.mesh;
  std::vector<std::vector<int>> around(static_cast<std::size_t>(mesh.owned));
  each_cell(mesh, problem.materials, [&](const Cell& cell) {
    for (int a = 0; a < corners && octave(cell.material) == stiffness; ++a)
      if (cell.vertex(a) < mesh.owned) around[static_cast<std::size_t>(cell.vertex(a))].push_back(cell.number);
  });
  std::vector<std::int64_t> numbers;
  std::vector<Eigen::MatrixXd> blocks;
  for (int v = 0; v < mesh.owned; ++v) {
    const auto& cells = around[static_cast<std::size_t>(v)];
    if (cells.empty()) continue;
    auto [vertices, values] = share_of_corner(problem, v, cells, local);
    for (const int w : vertices) numbers.push_back(mesh.global[static_cast<std::size_t>(w)]);
    blocks.push_back(std::move(values));
  }
  algebra::Tall rows(std::ssize(numbers), of_strain * local.cols());
  Index at = 0;
  for (const auto& block : blocks) {
    rows.middleRows(at, block.rows()) = block;
    at += block.rows();
  }
  const algebra::Tall sums = algebra::accumulate(mesh.comm, numbers, rows, mesh.owned);
  mesh::VertexRows by_vertex(of_strain * mesh.owned, local.cols());
  for (Index v = 0; v < mesh.owned; ++v)
    for (Index j = 0; j < local.cols(); ++j)
      by_vertex.col(j).segment<of_strain>(of_strain * v) = sums.row(v).segment<of_strain>(of_strain * j).transpose();
  return mesh::with_ghosts(mesh, by_vertex, of_strain);
}

/// Adds the energies of one cell.
void add_lacking(const Cell& cell, const mesh::LocalRows& local, const mesh::LocalRows& smooth,
                 Eigen::Ref<Eigen::VectorXd> energies) {
  const fem::IntegrationPoints at_vertices(fem::element(cell.type).at_vertices, cell.x);
  const fem::VertexMatrix products = fem::mass(cell.type, cell.x, 1);  // ∫ N_a N_b
  const fem::Matrix<6, 6> C = cell.material.at_rest().hooke();
  for (Index j = 0; j < local.cols(); ++j) {
    const fem::CellVectors u = cell.gather(local, j);
    Strains6 e(of_strain, cell.count());
    for (int a = 0; a < cell.count(); ++a)
      e.col(a) = smooth.col(j).segment<of_strain>(of_strain * cell.vertex(a)) - strain(u, at_vertices.gradients(a));
    e.bottomRows<3>() *= 2;  // as C takes shears
    energies[j] += (C * e * products).cwiseProduct(e).sum();
  }
}

}  // namespace

Eigen::VectorXd lacking_energies(const Problem& problem, mesh::VertexRef u) {
  const mesh::Mesh& mesh = problem.mesh;
  std::set<int> classes;
  for (const auto& material : problem.materials) classes.insert(octave(material));
  Eigen::MatrixXd energies = Eigen::MatrixXd::Zero(u.cols(), 1);
  for (Index first = 0; first < u.cols(); first += at_a_time) {
    const Index count = std::min(at_a_time, u.cols() - first);
    const mesh::LocalRows local = mesh::with_ghosts(mesh, u.middleCols(first, count), mesh::components);
    for (const int stiffness : classes) {
      const mesh::LocalRows smooth = recovered(problem, stiffness, local);
      each_owned_cell(mesh, problem.materials, [&](const Cell& cell) {
        if (octave(cell.material) == stiffness) add_lacking(cell, local, smooth, energies.col(0).segment(first, count));
      });
    }
  }
  parallel::sum_in_place(mesh.comm, energies);
  return energies;
}

}  // namespace ritz::stages
