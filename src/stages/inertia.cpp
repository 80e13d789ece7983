#include "ritz/stages/inertia.hpp"

#include "ritz/mesh/bounding_box.hpp"
#include "ritz/mesh/dofs.hpp"

namespace ritz::stages {
model::Inertia inertia(const mesh::Mesh& mesh, const algebra::Matrix& scalar_mass, mesh::VertexRef u) {
  const Eigen::Vector3d origin = mesh::bounding_box(mesh).middle();
  const Eigen::Index r = u.cols(), n = mesh.owned;
  algebra::Tall B(n, 4 + mesh::components * r);
  B.col(0).setOnes();
  B.middleCols<3>(1) = (mesh.points.leftCols(n).colwise() - origin).transpose();
  for (int c = 0; c < mesh::components; ++c)
    B.middleCols(4 + c * r, r) = u(Eigen::seqN(c, n, mesh::components), Eigen::all);
  const Eigen::MatrixXd gram = algebra::inner(mesh.comm, B, algebra::multiply(scalar_mass, B));
  return {origin, (gram + gram.transpose()) / 2};
}

}  // namespace ritz::stages
