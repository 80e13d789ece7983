#include "ritz/stages/mesh_error.hpp"

#include <algorithm>
#include <memory>

#include "ritz/algebra/matrix.hpp"
#include "ritz/mesh/p_refinement.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/eigen_strategy.hpp"
#include "ritz/stages/patch_recovery.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;

constexpr Index improved_together = 16;   ///< modes that are improved together
constexpr double solve_tolerance = 1e-4;  ///< of K₂ w = M₂ P ψ; its square is what λ₂ notices
constexpr double unseen = 1.4;       ///< of what recovered strains lack themselves: measured, see docs/mesh_error.md
constexpr double least_share = .01;  ///< of λ that is taken as exact at the least

/// Whether no rank has a cell of which this does not hold.
template <class Holds>
bool all_cells(const mesh::Mesh& mesh, Holds holds) {
  const bool here = std::ranges::all_of(mesh.cells.types, holds);
  return parallel::max(mesh.comm, static_cast<std::int32_t>(!here)) == 0;
}

bool all_tet10(const mesh::Mesh& mesh) {
  return all_cells(mesh, [](fem::CellType type) { return type == fem::CellType::tet10; });
}

/// For each row of the overlaps its own column, the largest overlaps first.
std::vector<Index> most_alike(Eigen::MatrixXd overlaps) {
  std::vector<Index> found(static_cast<std::size_t>(overlaps.rows()));
  overlaps = overlaps.cwiseAbs();
  for (Index step = 0; step < overlaps.rows(); ++step) {
    Index row = 0, column = 0;
    overlaps.maxCoeff(&row, &column);
    found[static_cast<std::size_t>(row)] = column;
    overlaps.row(row).setConstant(-1);
    overlaps.col(column).setConstant(-1);
  }
  return found;
}

algebra::Tall beside(const algebra::ConstTallRef& a, const algebra::ConstTallRef& b) {
  algebra::Tall both(a.rows(), a.cols() + b.cols());
  both << a, b;
  return both;
}

Inverse factored_inverse(const EigenProblem& problem) {
  const auto& [K, M, scalar_mass] = problem.body.matrices;
  const auto solver = std::make_shared<algebra::Factorization>(problem.body.mesh.comm, "solve_");
  solver->factor(K, M, safe_shift(problem));
  return [solver](const algebra::ConstTallRef& b, algebra::TallRef x) { solver->solve(b, x); };
}

/// λ₂ of the flexible modes.
Eigen::VectorXd on_quadratic_cells(const Problem& problem, const ModesResult& modes, const StrategyFor& strategy) {
  auto refinement = mesh::p_refine(problem.mesh, problem.dofs);
  const auto ends = std::move(refinement.ends);
  const Problem fine = assemble(std::move(refinement.mesh), std::move(refinement.dofs), problem.materials);
  const auto& [K, M, scalar_mass] = fine.matrices;
  const auto taken = [&](const algebra::ConstTallRef& vectors) -> algebra::Tall {
    return mesh::from_vertices(
        fine.mesh, fine.dofs,
        mesh::interpolate(problem.mesh, ends, mesh::to_vertices(problem.mesh, problem.dofs, vectors)));
  };
  algebra::Tall rigid = taken(rigid_modes(modes));
  algebra::orthonormalise(M, algebra::Tall(rigid.rows(), 0), rigid);
  const double norm_K = algebra::one_norm(K);
  const EigenProblem eigen{fine, rigid, norm_K};
  const bool direct = strategy(fine.dofs) == Strategy::direct;
  const Inverse inverse = direct ? factored_inverse(eigen) : multigrid_inverse(eigen);

  const auto flexible = flexible_modes(modes);
  Eigen::VectorXd values(flexible.cols());
  algebra::Tall known = rigid;
  for (Index first = 0; first < flexible.cols(); first += improved_together) {
    const Index count = std::min(improved_together, flexible.cols() - first);
    const algebra::Tall x = taken(flexible.middleCols(first, count)), mx = algebra::multiply(M, x);
    const auto w = solve(fine.matrices, inverse, rigid, norm_K, mx, solve_tolerance).x;
    const RitzPairs pairs = rayleigh_ritz(K, M, known, beside(x, w));
    const auto alike = most_alike(algebra::inner(fine.mesh.comm, mx, pairs.vectors));
    values.segment(first, count) = pairs.values(alike);
    known = beside(known, pairs.vectors(Eigen::all, alike));
  }
  return values;
}

}  // namespace

std::string mesh_error_obstacle(const mesh::Mesh& mesh) {
  if (all_tet10(mesh) || all_cells(mesh, mesh::can_be_p_refined)) return "";
  std::string names;
  for (const auto type : fem::cell_types)
    if (!all_cells(mesh, [&](fem::CellType other) { return other != type; }))
      names += (names.empty() ? "" : ", ") + std::string(fem::shape(type).name);
  return "the error of a mesh is estimated where all cells are tet10, or all are tet4, hex8 or wedge6, and this one "
         "has " +
         names;
}

Eigen::VectorXd mesh_errors(const Problem& problem, const ModesResult& modes, const StrategyFor& strategy) {
  const Index flexible = flexible_modes(modes).cols(), rigid = modes.vectors.cols() - flexible;
  Eigen::VectorXd errors = Eigen::VectorXd::Zero(rigid + flexible);
  if (flexible == 0) return errors;
  const Eigen::ArrayXd lambda = modes.modes.eigenvalues.tail(flexible).array();
  Eigen::ArrayXd exact;
  if (all_tet10(problem.mesh)) {
    const auto u = mesh::to_vertices(problem.mesh, problem.dofs, flexible_modes(modes));
    exact = lambda - unseen * lacking_energies(problem, u).array();
  } else {
    exact = on_quadratic_cells(problem, modes, strategy).array();
  }
  errors.tail(flexible) = (lambda / exact.max(least_share * lambda)).sqrt() - 1;
  return errors;
}

}  // namespace ritz::stages
