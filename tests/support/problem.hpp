// A small problem from mesh to modes, and what every result has to satisfy.
#pragma once
#include <vector>

#include "ritz/mesh/read.hpp"
#include "ritz/stages/linear_modes.hpp"
#include "support/dense_algebra.hpp"

namespace ritz::test {

/// St. Venant-Kirchhoff: Pa, 1, kg/m³.
constexpr fem::Material stvk(double young, double poisson, double density) {
  return {fem::StVK{young, poisson}, density};
}
/// The same constants at rest in another law: the same K and M.
fem::Materials neo_hookean(fem::Materials materials);

inline constexpr fem::Material soft = stvk(1e6, .3, 1000);  ///< the beams' material

using stages::Problem;

/// A distributed mesh of a generated box "box:...", or of a mesh that every rank holds whole. *Collective*.
mesh::Mesh box(const std::string& text);
mesh::Mesh distributed(const mesh::FileMesh& whole);

/// All components of a set, or of the vertices between two corners, are fixed; or only some of them.
mesh::Fixed fixed(const std::string& set, std::array<bool, 3> components = {true, true, true});
mesh::Fixed fixed_between(const Eigen::Vector3d& low, const Eigen::Vector3d& high,
                          std::array<bool, 3> components = {true, true, true});

/// Numbers and assembles. *Collective*.
Problem problem(mesh::Mesh mesh, const std::vector<mesh::Fixed>& supports, const fem::Materials& materials = {soft});

/// The modes, checked by `expect_sound`. *Collective*.
stages::ModesResult modes(const Problem& p, stages::ModesOptions options);
stages::ModesResult modes(const Problem& p, int count);

/// Recomputed here, not taken from the result: residuals at their gates, ΨᵀMΨ = I to 1e-12, ascending order, as many
/// modes as asked for (or all), no cluster cut, and with the direct strategy as many eigenvalues below the
/// certificate's shift as modes found there. *Collective*.
void expect_sound(const Problem& p, const stages::ModesOptions& options, const stages::ModesResult& result);

int rigid_count(const model::Modes& modes);
Eigen::VectorXd flexible(const model::Modes& modes);     ///< eigenvalues λ
Eigen::VectorXd frequencies(const model::Modes& modes);  ///< of the flexible modes, Hz

/// All modes of the dense matrices, on every rank. *Collective*.
DenseModes dense_modes(const Problem& p);

/// The whole matrix, on every rank. *Collective*.
Eigen::MatrixXd dense(Mat A);
/// The whole columns, on every rank. *Collective*.
Eigen::MatrixXd whole(MPI_Comm comm, const algebra::Tall& rows);

}  // namespace ritz::test
