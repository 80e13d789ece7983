// From reduced coordinates back to displacements: u = U z.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "ritz/base/simd.hpp"
#include "ritz/model/model.hpp"

namespace ritz::runtime {

/// Writes the displacements u = U z of all stored vertices, m, to `displacements`, which is n_stored x 3 and already
/// has its size; z has r entries. Does not allocate.
void reconstruct(const model::Basis& basis, Eigen::Ref<const Eigen::VectorXd> z, model::Points& displacements);

/// A copy of U, or of what U has for some vertices, to reconstruct from. What a reconstruction takes is the time to
/// read U: in single precision, enough for drawing, it takes half of that. Reconstructing does not change the copy: any
/// number of threads can share it, or have one each, for vertices of its own.
template <class Scalar>
struct Reconstruction {
  Eigen::Index vertices = 0, columns = 0;
  AlignedVector<Scalar> panels;  ///< rows of U, of four registers at a time, each of these panels column by column
};

/// Displacements u, a row a vertex, m.
template <class Scalar>
using Displacements = Eigen::Matrix<Scalar, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Copies U for all stored vertices, in their order.
template <class Scalar>
Reconstruction<Scalar> make_reconstruction(const model::Basis& basis);
/// Copies U for the stored vertices `rows` (rows of Geometry::points), in this order.
template <class Scalar>
Reconstruction<Scalar> make_reconstruction(const model::Basis& basis, std::span<const std::int64_t> rows);

/// Writes u = U z of the copied vertices, m, to `displacements`, which is vertices x 3 and already has its size; z has
/// r entries. In single precision ‖u − U z‖ of a vertex is at most about r/2 + 2 times 6e-8 of the sum of |U_ij z_j|.
/// Does not allocate.
template <class Scalar>
void reconstruct(const Reconstruction<Scalar>& reconstruction, Eigen::Ref<const Eigen::VectorXd> z,
                 Displacements<Scalar>& displacements);

/// The 3 x r matrix P for which P z is the mean displacement, m, of the stored vertices `rows` (rows of
/// Geometry::points, at least one), all with the same weight.
Eigen::MatrixXd mean_rows(const model::Basis& basis, std::span<const std::int64_t> rows);

}  // namespace ritz::runtime
