#include <algorithm>
#include <memory>

#include "ritz/algebra/matrix.hpp"
#include "ritz/algebra/multigrid.hpp"
#include "ritz/algebra/panel.hpp"
#include "ritz/base/error.hpp"
#include "ritz/stages/canonical.hpp"
#include "ritz/stages/eigen_strategy.hpp"
#include "ritz/stages/lobpcg.hpp"
#include "ritz/stages/rigid_modes.hpp"

namespace ritz::stages {
namespace {

constexpr std::uint64_t lobpcg_start_stream = 2000;
constexpr int panel = algebra::panel_width;

/// A multigrid cycle and the matrix that it is for.
struct Cycle {
  Cycle(algebra::Matrix A, const algebra::ConstTallRef& near_null)
      : matrix(std::move(A)), multigrid(matrix, near_null, "multigrid_") {}

  algebra::Matrix matrix;
  algebra::Multigrid multigrid;
};

/// K − σM, positive definite.
algebra::Matrix shifted(const Matrices& matrices, double sigma) {
  algebra::Matrix A = algebra::copy(matrices.stiffness);
  if (sigma != 0) algebra::add(A, -sigma, matrices.mass, algebra::Pattern::subset);
  return A;
}

/// What is known already, and smooth columns beside it: one cycle takes the worst off fixed random loads.
algebra::Tall start_block(const EigenProblem& problem, const Inverse& cycle, const algebra::Tall& known, int width) {
  const auto fresh = std::max<int>(width - static_cast<int>(known.cols()), 4);
  algebra::Tall start(problem.rigid.rows(), known.cols() + fresh);
  start.leftCols(known.cols()) = known;
  cycle(algebra::multiply(problem.body.matrices.mass,
                          fixed_vectors(problem.body.mesh, problem.body.dofs, fresh, lobpcg_start_stream)),
        start.rightCols(fresh));
  return start;
}

}  // namespace

Inverse multigrid_inverse(const EigenProblem& problem) {
  const auto cycle = std::make_shared<const Cycle>(shifted(problem.body.matrices, safe_shift(problem)),
                                                   near_null_space(problem.body.mesh, problem.body.dofs));
  return [cycle](const algebra::ConstTallRef& r, algebra::TallRef z) { cycle->multigrid.apply(r, z); };
}

int iterative_block(int wanted) {
  const int guarded = std::max(wanted + 6, wanted + (wanted + 4) / 5);
  return (guarded + panel - 1) / panel * panel;
}

Found find_iteratively(const EigenProblem& problem, int wanted, const algebra::Tall& known,
                       const ModesProgress& progress) {
  progress("multigrid", 0);
  const Inverse inverse = multigrid_inverse(problem);
  LobpcgOptions options;
  options.wanted = wanted;
  auto found = lobpcg(problem.body.matrices.stiffness, problem.body.matrices.mass, problem.norm_K, inverse,
                      problem.rigid, start_block(problem, inverse, known, iterative_block(wanted)), options,
                      [&](int done, int all) { progress("modes", double(done) / all); });
  if (found.converged < wanted)
    throw NumericalError("the eigensolver (LOBPCG with multigrid) converged to " + std::to_string(found.converged) +
                             " of " + std::to_string(wanted) + " modes in " + std::to_string(found.iterations) +
                             " iterations",
                         Reason::iterative_solver_failed);
  const Eigen::Index accurate = found.pairs.values.size();
  return {std::move(found.pairs), accurate, found.iterations, inverse};
}

}  // namespace ritz::stages
