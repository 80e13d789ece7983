#include "ritz/stages/block_lanczos.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "ritz/algebra/dense.hpp"
#include "ritz/algebra/matrix.hpp"
#include "ritz/stages/canonical.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double well_conditioned = 1e-4;   ///< of a block's Cholesky factor, so that one normalisation is enough
constexpr double spare_tolerance = 1e-5;    ///< of spare pairs: their values have twice the digits
constexpr double close = 10 * cluster_gap;  ///< a relative gap in θ that could be one inside a cluster
constexpr int passes = 3;                   ///< of orthogonalisation, at most

/// The M-complement's dimension.
Index dimension(const algebra::Matrix& M, Index locked) { return static_cast<Index>(algebra::rows(M)) - locked; }

/// The growing basis V, T = Vᵀ M Op V, and the pending block that Op has not seen yet. Columns of `basis_`: the locked
/// ones, then V, then the pending block.
class Krylov {
 public:
  Krylov(const algebra::Matrix& M, const Operator& op, const algebra::ConstTallRef& locked,
         const algebra::ConstTallRef& start, const LanczosOptions& options)
      : M_(M),
        op_(op),
        start_(start),
        space_(dimension(M, locked.cols())),
        locked_(locked.cols()),
        block_(options.block),
        capacity_(std::min<Index>(options.columns, space_)),
        basis_(start.rows(), locked_ + capacity_ + block_),
        T_(MatrixXd::Zero(capacity_ + block_, capacity_ + block_)) {
    basis_.leftCols(locked_) = locked;
    append_carefully(next_start(block_), std::min(block_, space_));
    coupling_.resize(pending_, 0);
  }

  bool exhausted() const { return pending_ == 0; }
  bool full() const { return done_ + pending_ > capacity_; }
  Index size() const { return done_; }

  /// Applies Op to the pending block and orthogonalises the result into the next one.
  void extend() {
    const Index first = done_, width = pending_;
    algebra::Tall w(basis_.rows(), width);
    op_(mv_, w);
    done_ += width;
    // Op takes the pending block into itself, into the columns coupled with it and into the next: the rest is rounding.
    const Index known = locked_ + done_, near = width + coupling_.cols();
    const MPI_Comm comm = algebra::comm_of(M_);
    MatrixXd h = MatrixXd::Zero(known, width);
    h.bottomRows(near) << coupling_.transpose(), algebra::inner(comm, mv_, w);
    algebra::subtract(w, basis_.middleCols(known - near, near), h.bottomRows(near));
    mv_ = algebra::multiply(M_, w);
    MatrixXd gram;
    for (int pass = 0; pass < passes; ++pass) {
      const MatrixXd part = algebra::inner(comm, basis_.leftCols(known), mv_);
      algebra::subtract(w, basis_.leftCols(known), part);
      h += part;
      mv_ = algebra::multiply(M_, w);
      gram = algebra::inner(comm, w, mv_);
      if ((part.colwise().squaredNorm().transpose().array() <= 0.01 * gram.diagonal().array()).all()) break;
    }
    T_.block(0, first, done_, width) = h.bottomRows(done_);
    T_.block(first, 0, width, done_) = h.bottomRows(done_).transpose();
    T_.block(first, first, width, width) = (h.bottomRows(width) + h.bottomRows(width).transpose()) / 2;
    append(w, gram);
  }

  /// Ritz pairs of T in descending θ; residual j is ‖Op y_j − θ_j y_j‖_M.
  void ritz() {
    const auto [values, vectors] = algebra::symmetric_eigen(T_.topLeftCorner(done_, done_));
    theta_ = values.reverse();
    Y_ = vectors.rowwise().reverse();
    residuals_ = Eigen::VectorXd::Zero(done_);
    if (pending_ > 0) residuals_ = (coupling_ * Y_.bottomRows(coupling_.cols())).colwise().norm().transpose();
  }

  /// How many of the first `wanted` pairs meet the tolerance.
  Index converged(Index wanted, double tolerance) const {
    Index count = 0;
    while (count < std::min(wanted, done_) && residuals_[count] <= tolerance * std::abs(theta_[count])) ++count;
    return count;
  }

  /// The first `wanted` pairs, and what may be the rest of the cluster at their end: at most `most`.
  Index whole(Index wanted, Index most) const {
    Index count = wanted;
    while (count < std::min(most, done_) && theta_[count - 1] - theta_[count] <= close * std::abs(theta_[count]))
      ++count;
    return count;
  }

  /// Keeps `count` Ritz vectors and the pending block.
  void restart(Index count) {
    const algebra::Tall kept = vectors(count);
    const algebra::Tall next = V().middleCols(done_, pending_);
    V().leftCols(count) = kept;
    V().middleCols(count, pending_) = next;
    T_.setZero();
    T_.topLeftCorner(count, count) = theta_.head(count).asDiagonal();
    coupling_ = coupling_ * Y_.bottomLeftCorner(coupling_.cols(), count).eval();
    done_ = count;
  }

  Eigen::VectorXd theta(Index count) const { return theta_.head(count); }
  algebra::Tall vectors(Index count) { return algebra::combine(V().leftCols(done_), Y_.leftCols(count)); }

 private:
  Eigen::Block<algebra::Tall, Eigen::Dynamic, Eigen::Dynamic, true> V() {
    return basis_.middleCols(locked_, capacity_ + block_);
  }

  /// Takes a block that is orthogonal to everything, normalises it (mv_ is M w, `gram` is wᵀMw) and puts it behind;
  /// where it has lost rank, start columns fill the places.
  void append(algebra::Tall& w, const MatrixXd& gram) {
    const Index room = std::min(block_, space_ - done_);
    const Eigen::LLT<MatrixXd> cholesky(gram);
    const auto pivots = cholesky.matrixLLT().diagonal().array().abs();
    const bool whole = cholesky.info() == Eigen::Success && w.cols() == room &&
                       pivots.minCoeff() > well_conditioned * pivots.maxCoeff();
    if (whole) {
      algebra::normalise(w, cholesky);
      algebra::normalise(mv_, cholesky);
      V().middleCols(done_, room) = w;
      coupling_ = cholesky.matrixU();
      pending_ = room;
      return;
    }
    append_carefully(w, room);
  }

  void append_carefully(const algebra::Tall& w, Index room) {
    algebra::Tall next = w;
    pending_ = 0;
    for (int attempt = 0; pending_ < room && attempt < 4; ++attempt) {
      const int kept = algebra::orthonormalise(M_, basis_.leftCols(locked_ + done_ + pending_), next);
      const auto taken = std::min<Index>(kept, room - pending_);
      V().middleCols(done_ + pending_, taken) = next.leftCols(taken);
      pending_ += taken;
      if (pending_ < room) next = next_start(room - pending_);
    }
    coupling_ = algebra::inner(algebra::comm_of(M_), V().middleCols(done_, pending_), algebra::multiply(M_, w));
    mv_ = algebra::multiply(M_, V().middleCols(done_, pending_));
  }

  /// Start columns in turn; when all are used, products of two, so that every value still belongs to its vertex.
  algebra::Tall next_start(Index columns) {
    algebra::Tall x(basis_.rows(), columns);
    for (Index j = 0; j < columns; ++j, ++used_) {
      const Index n = start_.cols();
      x.col(j) = start_.col(used_ % n);
      if (used_ >= n) x.col(j) = x.col(j).cwiseProduct(start_.col((used_ + used_ / n) % n)).eval();
    }
    return x;
  }

  const algebra::Matrix& M_;
  const Operator& op_;
  algebra::ConstTallRef start_;
  Index space_, locked_, block_, capacity_;
  algebra::Tall basis_;
  MatrixXd T_;
  Index done_ = 0, pending_ = 0, used_ = 0;
  algebra::Tall mv_;   ///< M times the pending block
  MatrixXd coupling_;  ///< PᵀM Op C: pending block P, and the columns C right before it that Op couples with it
  Eigen::VectorXd theta_, residuals_;
  MatrixXd Y_;
};

}  // namespace

int lanczos_columns(int pairs, int block) { return std::max(2 * pairs, pairs + 20 * block); }

LanczosResult block_lanczos(const algebra::Matrix& M, const Operator& op, const algebra::ConstTallRef& locked,
                            const algebra::ConstTallRef& start, const LanczosOptions& given, const Progress& progress) {
  LanczosOptions options = given;
  const Index wanted = options.wanted, all = wanted + options.spare;
  if (options.columns == 0) options.columns = lanczos_columns(options.wanted + options.spare, options.block);
  Krylov krylov(M, op, locked, start, options);
  LanczosResult result;
  for (int restarts = 0; !krylov.exhausted();) {
    krylov.extend();
    ++result.iterations;
    const bool look = krylov.size() >= all || krylov.full() || krylov.exhausted();
    if (!look) continue;
    krylov.ritz();
    const Index exact = krylov.whole(wanted, all);
    result.accurate = krylov.converged(exact, options.tolerance);
    progress(static_cast<int>(result.accurate), static_cast<int>(exact));
    const bool spares = krylov.converged(all, std::max(options.tolerance, spare_tolerance)) == all;
    result.converged = (result.accurate == exact && spares) || krylov.exhausted();
    if (result.converged) break;
    if (!krylov.full()) continue;
    if (restarts++ == options.restarts) break;
    krylov.restart(std::min<Index>(krylov.size() - 1, (all + krylov.size()) / 2));
  }
  const auto count = std::min<Index>(all, krylov.size());
  if (krylov.exhausted()) result.accurate = count;
  if (count > 0) {
    result.theta = krylov.theta(count);
    result.vectors = krylov.vectors(count);
  } else {
    result.vectors.resize(start.rows(), 0);
    result.converged = true;
  }
  return result;
}

}  // namespace ritz::stages
