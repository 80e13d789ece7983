#include "ritz/stages/elastic_scale.hpp"

#include "ritz/algebra/matrix.hpp"
#include "ritz/mesh/bounding_box.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/rayleigh_ritz.hpp"

namespace ritz::stages {
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
