#include "ritz/stages/rayleigh_ritz.hpp"

#include <limits>

#include "ritz/algebra/dense.hpp"
#include "ritz/algebra/matrix.hpp"
#include "ritz/mesh/mesh.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::stages {

algebra::Tall side_by_side(const algebra::ConstTallRef& a, const algebra::ConstTallRef& b) {
  algebra::Tall both(a.rows(), a.cols() + b.cols());
  both << a, b;
  return both;
}

RitzPairs rayleigh_ritz(const algebra::Matrix& K, const algebra::Matrix& M, const algebra::ConstTallRef& against,
                        algebra::Tall x) {
  const int kept = algebra::orthonormalise(M, against, x);
  const auto basis = x.leftCols(kept);
  const Eigen::MatrixXd product = algebra::inner(algebra::comm_of(K), basis, algebra::multiply(K, basis));
  auto [values, vectors] = algebra::symmetric_eigen((product + product.transpose()) / 2);
  return {std::move(values), algebra::combine(basis, vectors)};
}

Residuals residuals(const algebra::Matrix& K, const algebra::Matrix& M, double norm_K, const RitzPairs& pairs) {
  const MPI_Comm comm = algebra::comm_of(K);
  const algebra::Tall mx = algebra::multiply(M, pairs.vectors);
  algebra::Tall r = algebra::multiply(K, pairs.vectors);
  r -= mx * pairs.values.asDiagonal();
  const Eigen::ArrayXd scale = pairs.values.array().abs() * algebra::column_norms(comm, mx).array();
  const Eigen::ArrayXd floor =
      10 * std::numeric_limits<double>::epsilon() * norm_K * algebra::column_norms(comm, pairs.vectors).array() / scale;
  return {algebra::column_norms(comm, r).array() / scale, floor.max(residual_gate), std::move(r)};
}

namespace {

constexpr int degree = 3;

/// Coordinates of owned vertices mapped into [-1, 1]³.
Eigen::Matrix3Xd normalised(const mesh::Mesh& mesh) {
  const auto box = mesh::bounding_box(mesh);
  const Eigen::Vector3d half = (box.size() / 2).cwiseMax(1e-300);
  return half.cwiseInverse().asDiagonal() * (mesh.points.leftCols(mesh.owned).colwise() - box.middle());
}

algebra::Tall cubic_fields(const mesh::Mesh& mesh) {
  const Eigen::Matrix3Xd x = normalised(mesh);
  std::vector<Eigen::VectorXd> monomials;
  for (int a = 0; a <= degree; ++a)
    for (int b = 0; a + b <= degree; ++b)
      for (int c = 0; a + b + c <= degree; ++c)
        monomials.push_back((x.row(0).array().pow(a) * x.row(1).array().pow(b) * x.row(2).array().pow(c)).transpose());
  const auto count = static_cast<Eigen::Index>(monomials.size());
  algebra::Tall u = algebra::Tall::Zero(mesh::components * mesh.owned, mesh::components * count);
  for (Eigen::Index m = 0; m < count; ++m)
    for (int c = 0; c < mesh::components; ++c)
      u.col(mesh::components * m + c)(Eigen::seqN(c, mesh.owned, mesh::components)) =
          monomials[static_cast<std::size_t>(m)];
  return u;
}

}  // namespace

double elastic_scale(const Problem& problem, mesh::FreeRef rigid) {
  const auto& [mesh, dofs, materials, matrices] = problem;
  const auto pairs =
      rayleigh_ritz(matrices.stiffness, matrices.mass, rigid, mesh::from_vertices(mesh, dofs, cubic_fields(mesh)));
  if (pairs.values.size() == 0) return algebra::one_norm(matrices.stiffness) / algebra::one_norm(matrices.mass);
  return pairs.values[0];
}

}  // namespace ritz::stages
