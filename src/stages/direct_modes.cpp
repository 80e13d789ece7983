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

/// One step of subspace iteration and Rayleigh-Ritz at a time, until the residuals of the first `accurate` pairs meet
/// their gates: removes what Lanczos left of the high modes.
RitzPairs polish(const EigenProblem& problem, algebra::Tall x, Eigen::Index accurate,
                 const algebra::Factorization& solver) {
  RitzPairs pairs;
  for (int step = 0; step < polishing_steps; ++step) {
    solver.solve(algebra::multiply(problem.body.matrices.mass, x), x);
    pairs = rayleigh_ritz(problem.body.matrices.stiffness, problem.body.matrices.mass, problem.rigid, std::move(x));
    const Residuals r = residuals(problem.body.matrices.stiffness, problem.body.matrices.mass, problem.norm_K, pairs);
    const auto count = std::min(accurate, pairs.values.size());
    if ((r.relative.head(count).array() <= 0.1 * r.gate.head(count).array()).all()) break;
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

  const int all = std::max(1, wanted - static_cast<int>(known.cols()));
  const int exact = std::max(wanted - spare_pairs, std::min(options.count, wanted)) - static_cast<int>(known.cols());
  LanczosOptions lanczos;
  lanczos.wanted = std::clamp(exact, 1, all);
  lanczos.spare = all - lanczos.wanted;
  lanczos.block = options.block;
  lanczos.tolerance = options.tolerance;
  const auto start = fixed_vectors(problem.body.mesh, problem.body.dofs, 3 * options.block, start_stream);
  const auto op = [&](const algebra::ConstTallRef& mx, algebra::TallRef y) { solver.solve(mx, y); };
  const auto krylov = block_lanczos(problem.body.matrices.mass, op, side_by_side(problem.rigid, known), start, lanczos,
                                    [&](int done, int of) { progress("modes", double(done) / of); });
  if (!krylov.converged)
    throw NumericalError("the eigensolver (block Lanczos, tolerance " + shown(options.tolerance) +
                             ") did not find all " + std::to_string(wanted) + " modes",
                         Reason::modes_not_found);
  progress("polishing", 0);
  const Eigen::Index accurate = known.cols() + krylov.accurate;
  Found found{polish(problem, side_by_side(known, krylov.vectors), accurate, solver)};
  found.accurate = std::min(accurate, found.pairs.values.size());
  found.iterations = krylov.iterations;
  return found;
}

Found find_by_krylov_schur(const EigenProblem& problem, int wanted) {
  auto pairs = algebra::krylov_schur(problem.body.matrices.stiffness, problem.body.matrices.mass, safe_shift(problem),
                                     problem.rigid, wanted, 1e-12);
  if (pairs.values.size() < wanted)
    throw NumericalError("SLEPc's eigensolver converged to " + std::to_string(pairs.values.size()) + " of " +
                             std::to_string(wanted) + " modes in " + std::to_string(pairs.iterations) + " iterations",
                         Reason::foreign_solver_stopped);
  Found found{rayleigh_ritz(problem.body.matrices.stiffness, problem.body.matrices.mass, problem.rigid,
                            std::move(pairs.vectors))};
  found.accurate = found.pairs.values.size();
  found.iterations = pairs.iterations;
  return found;
}

}  // namespace ritz::stages
