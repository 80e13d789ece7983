// From reduced coordinates back to displacements: u = U z.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "ritz/model/model.hpp"

namespace ritz::runtime {

/// Displacements of all stored vertices, m: `displacements` is n_stored x 3 and has its size already. Does not
/// allocate.
void reconstruct(const model::Basis& basis, Eigen::Ref<const Eigen::VectorXd> z, model::Points& displacements);

/// The 3 x r matrix P whose product P z is the plain mean of the displacements of stored vertices `rows` (one: itself).
Eigen::MatrixXd mean_rows(const model::Basis& basis, std::span<const std::int64_t> rows);

}  // namespace ritz::runtime
