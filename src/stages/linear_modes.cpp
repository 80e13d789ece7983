#include "ritz/stages/linear_modes.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "ritz/algebra/matrix.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/stages/canonical.hpp"
#include "ritz/stages/eigen_strategy.hpp"
#include "ritz/stages/internal_force.hpp"
#include "ritz/stages/rigid_modes.hpp"
#include "ritz/stages/static_answers.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;

constexpr int searches = 3;            ///< how often modes that the count says are missing are searched for
constexpr double rigid_energy = 1e-6;  ///< a rigid mode's Rayleigh quotient, relative to the first flexible λ
constexpr std::uint64_t sign_stream = 1;

bool gap_after(const Eigen::VectorXd& values, Index i) {
  return values[i + 1] - values[i] > cluster_gap * std::abs(values[i + 1]);
}

/// How many pairs to keep: at least `count`, no cluster cut; 0 when the cluster at the end is not complete.
Index kept_count(const Eigen::VectorXd& values, Index count, bool all) {
  for (Index n = std::min(count, values.size()); n < values.size(); ++n)
    if (n == 0 || gap_after(values, n - 1)) return n;
  return all ? values.size() : 0;
}

/// A shift in the widest relative gap behind the first `kept` pairs, and how many pairs lie below it.
struct Shift {
  double sigma;
  Index below;
};

Shift choose_shift(const Eigen::VectorXd& values, Index kept) {
  Shift best{1.1 * values[values.size() - 1], values.size()};
  double widest = 0;
  for (Index n = std::max<Index>(kept, 1); n < values.size(); ++n) {
    const double gap = (values[n] - values[n - 1]) / values[n];
    if (gap <= widest) continue;
    widest = gap;
    best = {(values[n] + values[n - 1]) / 2, n};
  }
  return best;
}

/// The rigid motions, M-orthonormal one after the other: translations stay translations.
algebra::Tall rigid_modes(const Problem& problem) {
  algebra::Tall R = rigid_motions(problem.mesh, problem.dofs);
  for (int pass = 0; pass < 2 && R.cols() > 0; ++pass) {
    const Eigen::LLT<Eigen::MatrixXd> gram(
        algebra::inner(problem.mesh.comm, R, algebra::multiply(problem.matrices.mass, R)));
    if (gram.info() != Eigen::Success)
      throw NumericalError("the rigid modes of the body are not independent: is a piece a single point?");
    algebra::normalise(R, gram);
  }
  return R;
}

Index flexible_modes(const mesh::Dofs& dofs, const algebra::Tall& rigid) { return dofs.total - rigid.cols(); }

class Search {
 public:
  Search(const EigenProblem& problem, const ModesOptions& options, const ModesProgress& progress)
      : problem_(problem),
        options_(options),
        progress_(progress),
        solver_(std::make_shared<algebra::Factorization>(problem.body.mesh.comm, "solve_")),
        most_(flexible_modes(problem.body.dofs, problem.rigid)) {}

  /// Pairs found so far, and how many of them to keep.
  Found found;
  Index kept = 0;
  model::Certificate certificate;
  mesh::FreeRows answers;

  void run(const algebra::Tall& known, mesh::FreeRef loads) {
    const Index wanted = options_.count > 0 ? std::min<Index>(options_.count + spare_pairs, most_) : 0;
    if (wanted > 0) {
      found = find(static_cast<int>(wanted), known);
      keep_clusters_whole(wanted);
    }
    answer(loads);
    if (wanted > 0 && options_.strategy == Strategy::direct) certify();
    if (most_ > 0 && options_.inverse == InverseUse::kept) found.inverse = inverse();
  }

 private:
  /// Finds more than the `wanted` that are there as long as the cluster at their end is not complete.
  void keep_clusters_whole(Index wanted) {
    const Index count = std::min<Index>(options_.count, most_);
    while ((kept = kept_count(found.pairs.values, count, wanted == most_)) == 0 && count > 0) {
      if (wanted == most_ || !found.pairs.values.allFinite())
        throw NumericalError("the eigensolver found no finite modes", Reason::modes_not_finite);
      wanted = std::min<Index>(2 * wanted, most_);
      found = find(static_cast<int>(wanted), found.pairs.vectors.leftCols(found.accurate));
    }
  }

  /// What the modes were found with, or would have been; of the direct strategy until its factorization is spent.
  Inverse inverse() {
    if (options_.strategy == Strategy::iterative) return found.inverse ? found.inverse : multigrid_inverse(problem_);
    if (options_.slepc || options_.count == 0)
      solver_->factor(problem_.body.matrices.stiffness, problem_.body.matrices.mass, safe_shift(problem_));
    return [solver = solver_](const algebra::ConstTallRef& b, algebra::TallRef x) { solver->solve(b, x); };
  }

  void answer(mesh::FreeRef loads) {
    answers = algebra::Tall::Zero(loads.rows(), loads.cols());
    if (loads.cols() == 0 || most_ == 0) return;
    progress_("static answers", 0);
    answers = static_answers(problem_.body.matrices, inverse(), problem_.rigid, problem_.norm_K, loads);
  }

  Found find(int wanted, const algebra::Tall& known) {
    if (options_.strategy == Strategy::iterative) return find_iteratively(problem_, wanted, known, progress_);
    if (options_.slepc) return find_by_krylov_schur(problem_, wanted);
    return find_direct(problem_, wanted, known, options_, *solver_, progress_);
  }

  /// Counts below a shift; when the count says that a mode is missing, goes on searching beside the known ones.
  void certify() {
    for (int search = 0; search <= searches; ++search) {
      progress_("inertia count", 0);
      const Shift shift = choose_shift(found.pairs.values, kept);
      // Sylvester's law of inertia: the negative pivots of K − σM are the eigenvalues below σ.
      const auto counter = options_.inverse == InverseUse::spent
                               ? solver_
                               : std::make_shared<algebra::Factorization>(problem_.body.mesh.comm, "solve_");
      counter->factor(problem_.body.matrices.stiffness, problem_.body.matrices.mass, shift.sigma);
      certificate = {model::Certified::inertia, shift.sigma, counter->negative_pivots(),
                     problem_.rigid.cols() + shift.below};
      const auto missing = certificate.counted - certificate.found;
      if (missing == 0) return;
      if (missing < 0) break;
      const auto wanted = std::min<Index>(found.pairs.values.size() + missing, most_);
      found = find(static_cast<int>(wanted), found.pairs.vectors.leftCols(found.accurate));
      keep_clusters_whole(wanted);
    }
    throw NumericalError("the modes could not be certified: " + std::to_string(certificate.counted) +
                         " eigenvalues lie below the shift " + shown(certificate.shift, 3) + ", " +
                         std::to_string(certificate.found) + " were found");
  }

  const EigenProblem& problem_;
  const ModesOptions& options_;
  const ModesProgress& progress_;
  std::shared_ptr<algebra::Factorization> solver_;
  Index most_;
};

/// The Rayleigh quotients of M-normalised vectors.
Eigen::VectorXd energies_of(const EigenProblem& problem, const algebra::ConstTallRef& vectors) {
  return strain_energies(problem.body, mesh::to_vertices(problem.body.mesh, problem.body.dofs, vectors));
}

/// Puts M-normalised vectors in the order of their Rayleigh quotients, and returns these.
Eigen::VectorXd sort_by_energy(const EigenProblem& problem, algebra::TallRef vectors) {
  const Eigen::VectorXd energies = energies_of(problem, vectors);
  std::vector<Index> order(static_cast<std::size_t>(energies.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return energies[a] < energies[b]; });
  vectors = algebra::Tall(vectors(Eigen::all, order));
  return energies(order);
}

/// A mode whose residual is above its gate, with what may have kept it there.
NumericalError inaccurate(const std::string& mode, const ModesOptions& options) {
  if (options.strategy == Strategy::iterative) return NumericalError(mode, Reason::iterative_solver_failed);
  if (options.slepc) return NumericalError(mode, Reason::foreign_solver_inaccurate);
  if (options.tolerance > residual_gate) return NumericalError(mode, Reason::tolerance_too_loose);
  return NumericalError(mode + "; use a mesh of better shape");
}

/// Rigid and flexible pairs side by side, with the figures that say how good they are.
ModesResult summarise(const EigenProblem& problem, const ModesOptions& options, const Search& search) {
  const Matrices& matrices = problem.body.matrices;
  const MPI_Comm comm = problem.body.mesh.comm;
  const Index rigid = problem.rigid.cols(), flexible = search.kept, all = rigid + flexible;
  ModesResult result;
  result.vectors.resize(problem.rigid.rows(), all);
  result.vectors << problem.rigid, search.found.pairs.vectors.leftCols(flexible);
  auto vectors = result.vectors.rightCols(flexible);
  const Eigen::VectorXd values = sort_by_energy(problem, vectors);
  const auto W = fixed_vectors(problem.body.mesh, problem.body.dofs, largest_group(values), sign_stream);
  if (flexible > 0) make_canonical(matrices.mass, values, W, vectors);

  model::Modes& modes = result.modes;
  modes.eigenvalues = Eigen::VectorXd::Zero(all);
  modes.eigenvalues.tail(flexible) = values;
  const algebra::Tall kpsi = algebra::multiply(matrices.stiffness, result.vectors);
  const Eigen::MatrixXd gram = algebra::inner(comm, result.vectors, algebra::multiply(matrices.mass, result.vectors));
  modes.energies = algebra::inner(comm, result.vectors, kpsi).diagonal();
  modes.energies.head(rigid) = energies_of(problem, problem.rigid);  // K's rounding is more than they store
  modes.orthonormality = all > 0 ? (gram - Eigen::MatrixXd::Identity(all, all)).cwiseAbs().maxCoeff() : 0;
  modes.residuals = algebra::column_norms(comm, kpsi)
                        .cwiseQuotient((problem.norm_K * algebra::column_norms(comm, result.vectors)).cwiseMax(1e-300));
  const Residuals r = residuals(matrices.stiffness, matrices.mass, problem.norm_K, {values, vectors});
  modes.residuals.tail(flexible) = r.relative;
  modes.floor_applies.assign(static_cast<std::size_t>(all), 0);
  for (Index i = 0; i < flexible; ++i) {
    modes.floor_applies[static_cast<std::size_t>(rigid + i)] = r.relative[i] > residual_gate;
    if (!(r.relative[i] <= r.gate[i]))
      throw inaccurate("mode " + std::to_string(rigid + i + 1) + " has a relative residual of " +
                           shown(r.relative[i], 3) + ", above its gate " + shown(r.gate[i], 3),
                       options);
  }
  modes.kinds.assign(static_cast<std::size_t>(rigid), model::ModeKind::rigid);
  modes.kinds.resize(static_cast<std::size_t>(all), model::ModeKind::flexible);
  modes.certificate = search.certificate;
  result.iterations = search.found.iterations;
  if (options.inverse == InverseUse::kept) result.inverse = search.found.inverse;
  return result;
}

void check_orthonormality(const model::Modes& modes) {
  if (!(modes.orthonormality <= orthonormality_gate))
    throw NumericalError("the modes are not mass-orthonormal: max |ΨᵀMΨ - I| is " + shown(modes.orthonormality, 3) +
                         "; use a mesh of better shape");
}

void check_rigid_energies(const model::Modes& modes, Index rigid) {
  if (rigid == 0 || rigid == modes.eigenvalues.size()) return;
  const double worst = modes.energies.head(rigid).cwiseAbs().maxCoeff();
  if (worst > rigid_energy * modes.eigenvalues[rigid])
    throw NumericalError("a rigid mode stores energy (Rayleigh quotient " + shown(worst, 3) +
                         " against the first flexible " + shown(modes.eigenvalues[rigid], 3) + ")");
}

}  // namespace

ModesResult linear_modes(const Problem& body, const ModesOptions& options, mesh::FreeRef earlier, mesh::FreeRef loads,
                         const ModesProgress& progress) {
  const algebra::Tall rigid = rigid_modes(body);
  const EigenProblem problem{body, rigid, algebra::one_norm(body.matrices.stiffness)};
  Search search(problem, options, progress);
  search.found.pairs.vectors.resize(rigid.rows(), 0);
  search.run(earlier, loads);
  ModesResult result = summarise(problem, options, search);
  result.answers = std::move(search.answers);
  result.strategy = options.strategy;
  check_orthonormality(result.modes);
  check_rigid_energies(result.modes, rigid.cols());
  if (search.kept < options.count)
    result.notes.push_back(std::to_string(options.count) + " modes were asked for, but the body has only " +
                           std::to_string(search.kept) + " flexible ones");
  return result;
}

}  // namespace ritz::stages
