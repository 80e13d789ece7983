// From reduced coordinates back to displacements: u = U z.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "ritz/model/model.hpp"

namespace ritz::runtime {

/// Writes the displacements u = U z of all stored vertices, m, to `displacements`, which is n_stored x 3 and already
/// has its size; z has r entries. Does not allocate.
void reconstruct(const model::Basis& basis, Eigen::Ref<const Eigen::VectorXd> z, model::Points& displacements);

/// The 3 x r matrix P for which P z is the mean displacement, m, of the stored vertices `rows` (rows of
/// Geometry::points, at least one), all with the same weight.
Eigen::MatrixXd mean_rows(const model::Basis& basis, std::span<const std::int64_t> rows);

}  // namespace ritz::runtime
