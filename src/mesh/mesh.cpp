#include "ritz/mesh/mesh.hpp"

#include <limits>

namespace ritz::mesh {

Region3 bounding_box(const Mesh& mesh) {
  Region3 box;
  box.low.setConstant(std::numeric_limits<double>::max());
  box.high = -box.low;
  for (int v = 0; v < mesh.owned; ++v) {
    box.low = box.low.cwiseMin(mesh.points.col(v));
    box.high = box.high.cwiseMax(mesh.points.col(v));
  }
  const auto numbers = static_cast<int>(box.low.size());
  MPI_Allreduce(MPI_IN_PLACE, box.low.data(), numbers, MPI_DOUBLE, MPI_MIN, mesh.comm);
  MPI_Allreduce(MPI_IN_PLACE, box.high.data(), numbers, MPI_DOUBLE, MPI_MAX, mesh.comm);
  return box;
}

}  // namespace ritz::mesh
