#include "ritz/stages/witness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ritz/algebra/matrix.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/random.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/mesh/mesh.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/runtime/polynomial_force.hpp"
#include "ritz/stages/internal_force.hpp"
#include "ritz/stages/rayleigh_ritz.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;

constexpr double gate = 1e-11;
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr int decades = 9;
constexpr int halvings = 6, sizes_tried = 14;
constexpr double largest_start = 0.01;    ///< of the body's size
constexpr double clear_of_rounding = 30;  ///< times a bound that it reaches a tenth of

double largest(MPI_Comm comm, const algebra::ConstTallRef& u) {
  return parallel::max(comm, u.size() > 0 ? u.cwiseAbs().maxCoeff() : 0.0);
}

/// Random reduced coordinates, one column a decade of the largest displacement.
Eigen::MatrixXd samples(const mesh::Mesh& mesh, const algebra::ConstTallRef& u) {
  Eigen::MatrixXd z(u.cols(), decades);
  for (Index d = 0; d < decades; ++d) {
    for (Index i = 0; i < z.rows(); ++i)
      z(i, d) = uniform(77 + static_cast<std::uint64_t>(d), static_cast<std::uint64_t>(i));
    const double unit = largest(mesh.comm, u * z.col(d));
    z.col(d) *= 0.1 * mesh::bounding_box(mesh).size().norm() * std::pow(10.0, static_cast<double>(d) - 6) / unit;
  }
  return z;
}

/// St. Venant-Kirchhoff materials of the same constants at rest; those whose forces are polynomials stay as they are.
fem::Materials materials_of_polynomial(fem::Materials materials) {
  for (auto& material : materials)
    if (const auto rest = material.at_rest(); !fem::force_degree({material}))
      material.law = fem::StVK{rest.young(), rest.poisson()};
  return materials;
}

/// A figure, and what rounding alone may make of it.
void require(const std::string& what, double error, double allowed) {
  if (!(error <= std::max(gate, allowed)))
    throw NumericalError("the polynomial does not agree with the full model: " + what + " differs by " +
                         shown(error, 3) + "; the model was not written");
}

}  // namespace

PolynomialErrors polynomial_witness(const Problem& problem, mesh::VertexRef u, const model::Polynomial& polynomial) {
  const auto& [mesh, dofs, materials, matrices] = problem;
  const Eigen::MatrixXd z = samples(mesh, u);
  const algebra::Tall displaced = algebra::combine(u, z);
  const auto truth = internal_forces(mesh, materials_of_polynomial(materials), displaced);
  const Eigen::MatrixXd reduced = algebra::inner(mesh.comm, u, truth.forces);
  const Eigen::ArrayXd rounding = 10 * epsilon * algebra::one_norm(matrices.stiffness) *
                                  algebra::column_norms(mesh.comm, displaced).array() *
                                  algebra::column_norms(mesh.comm, u).maxCoeff();
  const auto forces = runtime::make_polynomial_force<double>(polynomial);
  auto evaluation = runtime::make_evaluation(forces);
  PolynomialErrors worst;
  for (Index d = 0; d < decades; ++d) {
    runtime::evaluate<double>(forces, z.col(d), evaluation);
    const double size = reduced.col(d).norm();
    const double error = (evaluation.force - reduced.col(d)).norm() / size;
    require("the force", error, rounding[d] / size);
    const double energy_error = std::abs(evaluation.energy - truth.energies[d]) / truth.energies[d];
    require("the energy", energy_error, rounding[d] * z.col(d).norm() / truth.energies[d]);
    worst.force = std::max(worst.force, error);
    worst.energy = std::max(worst.energy, energy_error);
  }
  const algebra::Tall free = mesh::from_vertices(mesh, dofs, u);
  const Eigen::MatrixXd stiffness = algebra::inner(mesh.comm, free, algebra::multiply(matrices.stiffness, free));
  const double scale = stiffness.cwiseAbs().maxCoeff();
  worst.stiffness = (forces.linear - stiffness).cwiseAbs().maxCoeff() / scale;
  require("K at rest", worst.stiffness, rounding.maxCoeff() / (scale * z.col(decades - 1).norm()));
  return worst;
}

double taylor_slope(const DerivativesSource& source, mesh::FreeRef line, mesh::FreeRef curve) {
  const auto& [problem, found, flexible, rows] = source;
  const auto& [mesh, dofs, materials, matrices] = problem;
  const algebra::Tall rigid = rigid_modes(found);
  const double start = largest_start * mesh::bounding_box(mesh).size().norm() / largest(mesh.comm, line);
  const Eigen::ArrayXd t = start * Eigen::ArrayXd::LinSpaced(sizes_tried, 0, sizes_tried - 1).unaryExpr([](double n) {
    return std::exp2(-n);
  });
  const algebra::Tall path = line * t.matrix().transpose() + curve * t.square().matrix().transpose();
  const auto forces = internal_forces(mesh, materials, mesh::to_vertices(mesh, dofs, path));
  algebra::Tall remainder = mesh::from_vertices(mesh, dofs, forces.forces) -
                            algebra::multiply(matrices.stiffness, line) * t.matrix().transpose();
  if (rigid.cols() > 0)
    algebra::subtract(remainder, algebra::multiply(matrices.mass, rigid), algebra::inner(mesh.comm, rigid, remainder));
  const Eigen::ArrayXd sizes = algebra::column_norms(mesh.comm, remainder).array();
  const Eigen::ArrayXd rounding =
      epsilon * algebra::one_norm(matrices.stiffness) * algebra::column_norms(mesh.comm, path).array();
  Index clear = 0;
  while (clear < sizes_tried && sizes[clear] > clear_of_rounding * rounding[clear]) ++clear;
  if (clear <= halvings) return std::numeric_limits<double>::quiet_NaN();
  return std::log2(sizes[clear - 1 - halvings] / sizes[clear - 1]) / halvings;
}

void require_third_order(double slope) {
  if (std::isnan(slope))
    throw NumericalError("the modal derivatives could not be tested: rounding hides the remainder of the Taylor series",
                         Reason::untestable_derivatives);
  if (!(slope >= 2.9 && slope <= 3.1))
    throw NumericalError(
        "the modal derivatives fail their own test: the remainder of the Taylor series falls with the power " +
        shown(slope, 3) + " of the amplitude in place of 3; the model was not written");
}

double taylor_witness(const DerivativesSource& source) {
  const algebra::Tall psi = source.flexible.leftCols(std::min<Index>(3, source.flexible.cols()));
  const auto modes = static_cast<int>(psi.cols());
  const Eigen::VectorXd p = Eigen::VectorXd::LinSpaced(modes, 1, modes).cwiseInverse();
  algebra::Tall curve = algebra::Tall::Zero(psi.rows(), 1);
  derivatives(
      {source.problem, source.modes, psi, modes}, modes * modes, [](Pair) { return 1.0; }, [] { return 0.0; },
      [&](const DerivativeBlock& block) {
        for (std::size_t n = 0; n < block.pairs.size(); ++n) {
          const auto [i, j] = block.pairs[n];
          curve += (i == j ? 0.5 : 1.0) * p[i] * p[j] * block.columns.col(static_cast<Index>(n));
        }
      });
  const double slope = taylor_slope(source, psi * p, curve);
  require_third_order(slope);
  return slope;
}

}  // namespace ritz::stages
