#include "ritz/stages/inertia.hpp"

namespace ritz::stages {
namespace {

/// The same on any number of ranks, to the last bit: minima and maxima only.
Eigen::Vector3d middle(const mesh::Mesh& mesh) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300), high = -low;
  for (int v = 0; v < mesh.owned; ++v) {
    low = low.cwiseMin(mesh.points.col(v));
    high = high.cwiseMax(mesh.points.col(v));
  }
  MPI_Allreduce(MPI_IN_PLACE, low.data(), 3, MPI_DOUBLE, MPI_MIN, mesh.comm);
  MPI_Allreduce(MPI_IN_PLACE, high.data(), 3, MPI_DOUBLE, MPI_MAX, mesh.comm);
  return (low + high) / 2;
}

}  // namespace

model::Inertia inertia(const mesh::Mesh& mesh, Mat scalar_mass, mesh::VertexRef u) {
  const Eigen::Vector3d origin = middle(mesh);
  const Eigen::Index r = u.cols(), n = mesh.owned;
  petsc::Tall B(n, 4 + 3 * r);
  B.col(0).setOnes();
  B.middleCols<3>(1) = (mesh.points.leftCols(n).colwise() - origin).transpose();
  for (int c = 0; c < 3; ++c) B.middleCols(4 + c * r, r) = u(Eigen::seqN(c, n, 3), Eigen::all);
  const Eigen::MatrixXd gram = petsc::inner(mesh.comm, B, petsc::multiply(scalar_mass, B));
  return {origin, (gram + gram.transpose()) / 2};
}

}  // namespace ritz::stages
