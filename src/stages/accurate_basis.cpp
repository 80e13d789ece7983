#include "ritz/stages/accurate_basis.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "ritz/algebra/matrix.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/runtime/statics.hpp"
#include "ritz/stages/static_answers.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;

constexpr int most_columns = 60;
constexpr int patience = 3;  ///< values of K' that may pass without a smaller basis
constexpr double nothing_found = std::numeric_limits<double>::infinity();

/// The coefficients of the first r coordinates alone.
model::Polynomial leading(const model::Polynomial& p, Index r) {
  model::Polynomial first{r, Eigen::VectorXd(r * (r + 1) / 2), Eigen::VectorXd(r * (r + 1) / 2 * (r + 2) / 3),
                          Eigen::VectorXd(r * (r + 1) / 2 * (r + 2) / 3 * (r + 3) / 4)};
  Index from[3] = {}, to[3] = {};
  for (Index i = 0; i < p.r; ++i)
    for (Index j = i; j < p.r; ++j) {
      if (j < r) first.quadratic[to[0]++] = p.quadratic[from[0]];
      ++from[0];
      for (Index k = j; k < p.r; ++k) {
        if (k < r) first.cubic[to[1]++] = p.cubic[from[1]];
        ++from[1];
        if (k < r) first.quartic.segment(to[2], r - k) = p.quartic.segment(from[2], r - k);
        if (k < r) to[2] += r - k;
        from[2] += p.r - k;
      }
    }
  return first;
}

/// A path as the coordinates of a basis see it: one column a level.
struct ReducedPath {
  Eigen::MatrixXd loads;   ///< UᵀF
  Eigen::MatrixXd truth;   ///< UᵀMu
  Eigen::ArrayXd squares;  ///< ‖u‖²_M
};

ReducedPath seen_from(const algebra::Tall& U, const algebra::Matrix& M, MPI_Comm comm, const StaticPath& path) {
  const algebra::Tall massive = algebra::multiply(M, path.truth);
  return {algebra::inner(comm, U, path.loads), algebra::inner(comm, U, massive),
          algebra::inner(comm, path.truth, massive).diagonal().array()};
}

/// The fewest columns that could represent all levels to `target`; one more than there are where none can.
Index fewest(const ReducedPath& path, double target) {
  Eigen::ArrayXd rest = path.squares;
  for (Index r = 0; r < path.truth.rows(); ++r) {
    rest -= path.truth.row(r).transpose().array().square();
    if ((rest <= target * target * path.squares).all()) return r + 1;
  }
  return path.truth.rows() + 1;
}

double static_error(const runtime::Model<double>& model, const ReducedPath& path) {
  const Index r = model.size(), levels = path.loads.cols();
  auto workspace = runtime::make_static_workspace<double>(model);
  runtime::Vector<double> z = runtime::Vector<double>::Zero(r), begin = z;
  double worst = 0;
  for (Index level = 0; level < levels; ++level) {
    const runtime::Vector<double> end = path.loads.col(level).head(r);
    if (runtime::solve_static<double>(model, {begin, end}, z, workspace).failure) return nothing_found;
    const double square = path.squares[level] - 2 * z.dot(path.truth.col(level).head(r)) + z.squaredNorm();
    worst = std::max(worst, square / path.squares[level]);
    begin = end;
  }
  return std::sqrt(std::max(worst, 0.0));
}

/// What the search needs at every K'.
struct Question {
  const Problem& problem;
  const ModesResult& modes;
  const StaticPath& path;
  const algebra::Tall& series;
  double target;
};

ReducedPath seen_from(const algebra::Tall& U, const Question& in) {
  return seen_from(U, in.problem.matrices.mass, in.problem.mesh.comm, in.path);
}

/// The first `limit` columns of the series and the directions of the set.
algebra::Tall candidates(const Question& in, const Principal& set, Index limit) {
  algebra::Tall all(in.series.rows(), in.series.cols() + set.sigma.size());
  all << in.series, canonical_directions(in.problem, set);
  return all.leftCols(std::min(limit, all.cols()));
}

/// The smallest basis of at most `limit` such columns; or the best there is, which misses the target.
SizedError smallest(const Question& in, const PolynomialLaws& laws, const Principal& set, int count, int limit) {
  const algebra::Tall U = candidates(in, set, limit);
  const auto path = seen_from(U, in);
  SizedError best{count, 0, nothing_found};
  Index r = fewest(path, in.target);
  for (Index all = r + 4; r <= U.cols(); all *= 2) {
    const Index width = std::min(all, U.cols());
    const auto polynomial =
        reduce_polynomial(in.problem, laws, mesh::to_vertices(in.problem.mesh, in.problem.dofs, U.leftCols(width)));
    for (; r <= width; ++r) {
      const double error = static_error(runtime::make_model<double>(leading(polynomial, r), {}), path);
      if (error < best.error) best = {count, static_cast<int>(r), error};
      if (error <= in.target) return best;
    }
  }
  return best;
}

/// The fewest columns that can represent the path to half of the target, which the equilibria of a reduced model miss
/// by more than its best approximation; an error of 0 where there are as many.
SizedError fewest_to_half(const Question& in, const Principal& set, int count, int limit) {
  const algebra::Tall U = candidates(in, set, limit);
  const Index r = fewest(seen_from(U, in), in.target / 2);
  return {count, static_cast<int>(r), r <= U.cols() ? 0 : nothing_found};
}

/// w and Φ_ww, M-orthonormal one after the other; Φ_ww only where it is not along w.
algebra::Tall taylor_series(const Problem& problem, const ModesResult& modes, const algebra::Tall& load) {
  const auto& [mesh, dofs, materials, matrices] = problem;
  const double norm_K = algebra::one_norm(matrices.stiffness);
  const algebra::Tall rigid = rigid_modes(modes);
  algebra::Tall series(load.rows(), 2);
  series.col(0) = static_answers(matrices, modes.inverse, rigid, norm_K, load);
  auto w = series.leftCols(1);
  if (algebra::orthonormalise(matrices.mass, rigid, w) == 0) return series.leftCols(0);
  const mesh::LocalRows local = mesh::with_ghosts(mesh, mesh::to_vertices(mesh, dofs, w), mesh::components);
  series.col(1) = static_answers(matrices, modes.inverse, rigid, norm_K, derivative_loads(problem, local, 0, 1));
  return series.leftCols(1 + algebra::orthonormalise(matrices.mass, w, series.rightCols(1)));
}

[[noreturn]] void give_up(const SizedError& best, int modes) {
  const auto reached = best.error < nothing_found
                           ? formatted("the best, %d columns of %d modes and their derivatives, reached %.2e",
                                       best.columns, best.modes, best.error)
                           : "none of them can represent the path to that";
  throw NumericalError(
      formatted(
          "no basis of the linear static answer, the first %d flexible modes and their derivatives is that accurate on "
          "the static path (%s)",
          modes, reached.c_str()),
      Reason::accuracy_out_of_reach);
}

/// The smallest basis that a search over K' found, and the set that it is cut from.
struct SearchedBasis {
  ScaledSet set;
  SizedError best;
};

/// Searches K' = 0, 1, 2, ... by `smallest(set, count, limit)`, the smallest basis of at most `limit` columns.
template <class Smallest>
SearchedBasis search(const Question& in, const ModesProgress& progress, Smallest&& smallest) {
  const algebra::Tall flexible = flexible_modes(in.modes);
  const int all = static_cast<int>(flexible.cols());
  if (all == 0) give_up({0, 0, nothing_found}, 0);
  const EnteringModes entering{in.modes.modes.eigenvalues.tail(all), flexible};
  const ScaledSource source{in.problem, in.modes, entering, in.series};
  const Cut cut{.size = most_columns};
  ScaledSet set;
  SizedError closest{0, 0, nothing_found};
  SearchedBasis found{{}, closest};
  auto& best = found.best;
  for (int count = 0, waited = 0;; count = whole_cluster(entering.values, count + 1)) {
    add_modes(source, count, cut, set);
    add_derivatives(source, count, BasisOptions{}.block, cut, progress, set);
    const bool found_before = best.columns > 0;
    const SizedError now = smallest(set.principal, count, found_before ? best.columns - 1 : most_columns);
    if (now.error < closest.error) closest = now;
    waited += found_before;
    if (now.error <= in.target) {
      best = now;
      found.set = set;
      waited = 0;
    }
    const bool smallest_of_all = best.columns > 0 && best.columns <= in.series.cols() + 1;
    if (count == all || waited == patience || smallest_of_all) break;
  }
  if (best.columns == 0) give_up(closest, all);
  return found;
}

/// The first `columns` of the series and the directions of the set, finished.
BasisResult cut_to(const Question& in, const ScaledSet& set, int columns) {
  const int of_series = std::min(columns, static_cast<int>(in.series.cols()));
  return cut_basis(in.problem, in.modes, in.series.leftCols(of_series), set, columns - of_series);
}

}  // namespace

AccurateBasis accurate_basis(const Problem& problem, const PolynomialLaws& laws, const ModesResult& modes,
                             const StaticPath& path, double target, const ModesProgress& progress) {
  const algebra::Tall series = taylor_series(problem, modes, path.loads.rightCols(1));
  const Question in{problem, modes, path, series, target};
  const auto [set, best] = search(in, progress, [&](const Principal& principal, int count, int limit) {
    return smallest(in, laws, principal, count, limit);
  });
  return {cut_to(in, set, best.columns), best};
}

AccurateBasis accurate_basis(const Problem& problem, const ReducedModel& reduced, const ModesResult& modes,
                             const StaticPath& path, double target, const ModesProgress& progress) {
  const algebra::Tall series = taylor_series(problem, modes, path.loads.rightCols(1));
  const Question in{problem, modes, path, series, target};
  const auto [set, first] = search(in, progress, [&](const Principal& principal, int count, int limit) {
    return fewest_to_half(in, principal, count, limit);
  });
  const int most = std::min(most_columns, static_cast<int>(series.cols() + set.principal.sigma.size()));
  SizedError closest{first.modes, 0, nothing_found};
  for (int r = first.columns; r <= most; r = std::max(r + 1, 6 * r / 5)) {
    progress("columns", static_cast<double>(r) / most);
    auto basis = cut_to(in, set, r);
    const SizedError now{first.modes, r, static_error(reduced(basis), seen_from(basis.U, in))};
    if (now.error <= target) return {std::move(basis), now};
    if (now.error < closest.error) closest = now;
  }
  give_up(closest, first.modes);
}

}  // namespace ritz::stages
