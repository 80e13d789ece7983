#include "ritz/stages/scaled_set.hpp"

#include <algorithm>

#include "ritz/algebra/handle.hpp"
#include "ritz/stages/canonical.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;

constexpr double rounding = 1e-12;  ///< of a vector: what is left of it where the given columns span it

void count_in(const DerivativeCounts& more, DerivativeCounts& all) {
  all.pairs += more.pairs;
  all.solved += more.solved;
  all.iterations = std::max(all.iterations, more.iterations);
  all.residual = std::max(all.residual, more.residual);
  all.skipped += more.skipped;
}

}  // namespace

void add_besides(const algebra::Matrix& M, const algebra::ConstTallRef& given, algebra::Tall vectors, const Cut& cut,
                 Principal& set) {
  const MPI_Comm comm = algebra::comm_of(M);
  const Eigen::ArrayXd sizes = algebra::column_norms(comm, vectors).array();
  for (int pass = 0; pass < 2 && given.cols() > 0; ++pass)
    algebra::subtract(vectors, given, algebra::inner(comm, given, algebra::multiply(M, vectors)));
  const Eigen::ArrayXd rest = algebra::column_norms(comm, vectors).array();
  for (Index j = 0; j < vectors.cols(); ++j)
    if (rest[j] <= rounding * sizes[j]) vectors.col(j).setZero();
  add(M, set, vectors, cut);
}

int whole_cluster(const Eigen::VectorXd& values, int count) {
  while (count > 0 && count < values.size() && values[count] - values[count - 1] <= cluster_gap * values[count])
    ++count;
  return count;
}

void add_modes(const ScaledSource& source, int count, const Cut& cut, ScaledSet& set) {
  const auto& [values, vectors] = source.entering;
  const int fresh = count - set.modes;
  if (fresh <= 0) return;
  const Eigen::VectorXd scale = (values[0] / values.array()).segment(set.modes, fresh);
  add_besides(source.problem.matrices.mass, source.given, vectors.middleCols(set.modes, fresh) * scale.asDiagonal(),
              cut, set.principal);
  set.modes = count;
}

void add_derivatives(const ScaledSource& source, int count, int block, const Cut& cut, const ModesProgress& progress,
                     ScaledSet& set) {
  const int old = set.derivatives, fresh = count - old;
  if (fresh <= 0) return;
  // The new modes first: their rows of pairs are all that is new.
  Eigen::VectorXd values(count);
  algebra::Tall vectors(source.entering.vectors.rows(), count);
  values << source.entering.values.segment(old, fresh), source.entering.values.head(old);
  vectors << source.entering.vectors.middleCols(old, fresh), source.entering.vectors.leftCols(old);
  const double first = source.entering.values[0];
  const auto weight = [&](Pair p) { return first / values[p.i] * (first / values[p.j]); };
  const int all = fresh * old + fresh * (fresh + 1) / 2;
  int done = 0;
  const auto take = [&](const DerivativeBlock& derivatives) {
    Eigen::VectorXd scale(static_cast<Index>(derivatives.pairs.size()));
    for (std::size_t p = 0; p < derivatives.pairs.size(); ++p)
      scale[static_cast<Index>(p)] = weight(derivatives.pairs[p]);
    add_besides(source.problem.matrices.mass, source.given, derivatives.columns * scale.asDiagonal(), cut,
                set.principal);
    progress("derivatives", double(done += static_cast<int>(derivatives.pairs.size())) / all);
  };
  const auto counts = derivatives(
      {source.problem, source.modes, vectors, fresh}, block, weight, [&] { return dispensable(set.principal, cut); },
      take);
  set.principal.discarded += counts.skipped;
  count_in(counts, set.counts);
  set.derivatives = count;
}

}  // namespace ritz::stages
