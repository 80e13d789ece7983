// Least squares with non-negative weights, min ‖A w − b‖ for w ≥ 0, where A has few rows and many columns, which are
// distributed over the ranks.
#pragma once
#include <mpi.h>

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

namespace ritz::stages {

/// The columns of A that this rank holds. How they are stored is the caller's business.
struct DistributedColumns {
  std::vector<std::int64_t> numbers;  ///< of all ranks' columns distinct
  /// Aᵀy for these columns. It ranks them, and may be rounded to single precision.
  std::function<Eigen::VectorXd(const Eigen::VectorXd& y)> products;
  /// The columns with these places among `numbers`, side by side.
  std::function<Eigen::MatrixXd(const std::vector<Eigen::Index>& places)> columns;
};

struct NonnegativeFit {
  std::vector<std::int64_t> numbers;  ///< of the columns with a weight, in the order in which they entered
  Eigen::VectorXd weights;            ///< w of these columns, > 0; all others are 0
  Eigen::VectorXd residual;           ///< b − A w
  bool optimal = false;               ///< whether no column could improve the fit: Aᵀ(b − A w) ≤ the tolerance
};

/// When a fit ends.
struct FitEnd {
  double tolerance;    ///< where no gradient Aᵀ(b − A w) is above this part of the largest of Aᵀb
  Eigen::Index most;   ///< columns, > 0
  Eigen::Index first;  ///< columns at which the fit is shown first
};

/// Is shown the fit when it has as many columns as were asked for, with the best weights for them, and when it has the
/// most. Returns the next number of columns to be shown; one that is not larger ends the fit. It is called on every
/// rank, and has to return the same number there.
using FitReached = std::function<Eigen::Index(const NonnegativeFit&)>;

/// *Collective*. Adds columns to an empty set until the fit ends. `b` is replicated.
///
/// This is the active-set method of Lawson and Hanson [Solving Least Squares Problems, 1974, Ch. 23]: the column with
/// the largest gradient enters, and the weights move towards the least squares solution of the set; where a weight
/// would become negative they stop, the columns whose weights are 0 leave, and the rest is solved anew. A pass over all
/// columns lists the 128 with the largest gradients. Up to 16 of these enter, one after the other, as long as their new
/// gradients are above those of all columns that are not listed. Equal gradients are ordered by the numbers of the
/// columns. A column whose distance to the span of the set is below 1e-8 of its length does not enter.
///
/// The set and its Cholesky factor are replicated, so that the same columns are found on any number of ranks.
NonnegativeFit nonnegative_least_squares(MPI_Comm comm, const DistributedColumns& columns, const Eigen::VectorXd& b,
                                         const FitEnd& end, const FitReached& reached);

}  // namespace ritz::stages
