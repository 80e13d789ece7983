#include <algorithm>

#include "ritz/algebra/eigensolver.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/stages/block_lanczos.hpp"
#include "ritz/stages/canonical.hpp"
#include "ritz/stages/eigen_strategy.hpp"
#include "ritz/stages/rayleigh_ritz.hpp"

namespace ritz::stages {
namespace {

constexpr std::uint64_t start_stream = 1000;
constexpr int polishing_steps = 3;

/// One step of subspace iteration and Rayleigh-Ritz at a time, until every residual meets its gate: removes what
/// Lanczos left of the high modes.
RitzPairs polish(const EigenProblem& problem, algebra::Tall x, const algebra::Factorization& solver) {
  RitzPairs pairs;
  for (int step = 0; step < polishing_steps; ++step) {
    solver.solve(algebra::multiply(problem.body.matrices.mass, x), x);
    pairs = rayleigh_ritz(problem.body.matrices.stiffness, problem.body.matrices.mass, problem.rigid, std::move(x));
    const Residuals r = residuals(problem.body.matrices.stiffness, problem.body.matrices.mass, problem.norm_K, pairs);
    if ((r.relative.array() <= 0.1 * r.gate.array()).all()) break;
    x = pairs.vectors;
  }
  return pairs;
}

}  // namespace

double safe_shift(const EigenProblem& problem) {
  if (problem.rigid.cols() == 0) return 0;
  return -0.1 * elastic_scale(problem.body, problem.rigid);
}

Found find_direct(const EigenProblem& problem, int wanted, const algebra::Tall& known, const ModesOptions& options,
                  algebra::Factorization& solver, const ModesProgress& progress) {
  const double sigma = safe_shift(problem);
  progress("factorization", 0);
  solver.factor(problem.body.matrices.stiffness, problem.body.matrices.mass, sigma);

  LanczosOptions lanczos;
  lanczos.wanted = std::max(1, wanted - static_cast<int>(known.cols()));
  lanczos.block = options.block;
  lanczos.tolerance = options.tolerance;
  const auto start = fixed_vectors(problem.body.mesh, problem.body.dofs, 3 * options.block, start_stream);
  const auto op = [&](const algebra::ConstTallRef& mx, algebra::TallRef y) { solver.solve(mx, y); };
  const auto found = block_lanczos(problem.body.matrices.mass, op, side_by_side(problem.rigid, known), start, lanczos,
                                   [&](int done, int all) { progress("modes", double(done) / all); });
  if (!found.converged)
    throw NumericalError("the eigensolver (block Lanczos, tolerance " + shown(options.tolerance) +
                             ") did not find all " + std::to_string(wanted) + " modes",
                         Reason::modes_not_found);
  progress("polishing", 0);
  return {polish(problem, side_by_side(known, found.vectors), solver), found.iterations};
}

Found find_by_krylov_schur(const EigenProblem& problem, int wanted) {
  auto pairs = algebra::krylov_schur(problem.body.matrices.stiffness, problem.body.matrices.mass, safe_shift(problem),
                                     problem.rigid, wanted, 1e-12);
  if (pairs.values.size() < wanted)
    throw NumericalError("SLEPc's eigensolver converged to " + std::to_string(pairs.values.size()) + " of " +
                             std::to_string(wanted) + " modes in " + std::to_string(pairs.iterations) + " iterations",
                         Reason::foreign_solver_stopped);
  return {rayleigh_ritz(problem.body.matrices.stiffness, problem.body.matrices.mass, problem.rigid,
                        std::move(pairs.vectors)),
          pairs.iterations};
}

}  // namespace ritz::stages
