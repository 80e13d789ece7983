#include "ritz/stages/nonnegative_least_squares.hpp"

#include <Eigen/Jacobi>
#include <algorithm>
#include <optional>
#include <unordered_set>
#include <utility>

#include "ritz/parallel/comm.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;

constexpr Index most_listed = 128, most_entering = 16;  ///< of one pass over all columns
constexpr double least_sine = 1e-8;                     ///< of the angle between a column and the span of the others

/// The columns C that have weights, and the Cholesky factor of their Gram matrix: CᵀC = RᵀR. What the factor gives is
/// corrected once by residuals, which makes it as accurate as an orthogonal factorization of C would be [Björck 1987,
/// corrected seminormal equations].
class PassiveSet {
 public:
  explicit PassiveSet(const Eigen::VectorXd& b) : b_(b), columns_(b.size(), 0) {}

  Index size() const { return static_cast<Index>(numbers_.size()); }
  const std::vector<std::int64_t>& numbers() const { return numbers_; }
  const Eigen::VectorXd& weights() const { return weights_; }
  Eigen::VectorXd residual() const { return b_ - columns() * weights_; }

  /// Adds a column with weight 0. Returns whether it is independent of the others; else nothing changes.
  bool append(std::int64_t number, const Eigen::VectorXd& a) {
    const Index n = size();
    Eigen::VectorXd r = solve_lower(columns().transpose() * a);
    Eigen::VectorXd distance = a - columns() * solve_upper(r);
    const Eigen::VectorXd correction = solve_lower(columns().transpose() * distance);
    r += correction;
    distance -= columns() * solve_upper(correction);
    const double length = distance.norm();
    if (!(length > least_sine * a.norm())) return false;
    reserve(n + 1);
    columns_.col(n) = a;
    R_.col(n).head(n) = r;
    R_(n, n) = length;
    numbers_.push_back(number);
    weights_.conservativeResize(n + 1);
    weights_[n] = 0;
    return true;
  }

  /// Moves the weights to the best ones. Columns whose weights become 0 on the way leave.
  void improve() {
    for (;;) {
      const Eigen::VectorXd best = solve();
      double step = 1;
      for (Index i = 0; i < size(); ++i)
        if (best[i] <= 0) step = std::min(step, fraction(i, best));
      if (step == 1 && (best.array() > 0).all()) {
        weights_ = best;
        return;
      }
      std::vector<Index> leaving;
      for (Index i = 0; i < size(); ++i)
        if (best[i] <= 0 && fraction(i, best) <= step) leaving.push_back(i);
      weights_ += step * (best - weights_);
      std::for_each(leaving.rbegin(), leaving.rend(), [&](Index i) { remove(i); });
    }
  }

 private:
  Eigen::Ref<const Eigen::MatrixXd> columns() const { return columns_.leftCols(size()); }
  /// R⁻ᵀx and R⁻¹x.
  Eigen::VectorXd solve_lower(const Eigen::VectorXd& x) const {
    return R_.topLeftCorner(size(), size()).triangularView<Eigen::Upper>().transpose().solve(x);
  }
  Eigen::VectorXd solve_upper(const Eigen::VectorXd& x) const {
    return R_.topLeftCorner(size(), size()).triangularView<Eigen::Upper>().solve(x);
  }

  /// The part of the way from weight i to best[i] ≤ 0 at which it is 0.
  double fraction(Index i, const Eigen::VectorXd& best) const {
    return weights_[i] > 0 ? weights_[i] / (weights_[i] - best[i]) : 0;
  }

  Eigen::VectorXd solve() const {
    Eigen::VectorXd x = solve_upper(solve_lower(columns().transpose() * b_));
    const Eigen::VectorXd residual = b_ - columns() * x;
    return x + solve_upper(solve_lower(columns().transpose() * residual));
  }

  void reserve(Index n) {
    if (n <= columns_.cols()) return;
    const Index room = std::max<Index>(64, 2 * columns_.cols());
    columns_.conservativeResize(Eigen::NoChange, room);
    R_.conservativeResize(room, room);
  }

  /// Removing a column of R leaves one entry below the diagonal in each of the columns behind it, which rotations of
  /// neighbouring rows remove.
  void remove(Index k) {
    const Index n = size() - 1;
    for (Index j = k; j < n; ++j) {
      columns_.col(j) = columns_.col(j + 1);
      R_.col(j).head(j + 2) = R_.col(j + 1).head(j + 2);
      weights_[j] = weights_[j + 1];
    }
    for (Index j = k; j < n; ++j) {
      Eigen::JacobiRotation<double> rotation;
      rotation.makeGivens(R_(j, j), R_(j + 1, j));
      R_.middleCols(j, n - j).applyOnTheLeft(j, j + 1, rotation.adjoint());
    }
    weights_.conservativeResize(n);
    numbers_.erase(numbers_.begin() + k);
  }

  const Eigen::VectorXd& b_;
  std::vector<std::int64_t> numbers_;
  Eigen::VectorXd weights_;
  Eigen::MatrixXd columns_, R_;  ///< with room for more
};

/// A column that may enter. Gradients are compared in single precision: rounding shall not order equal columns.
struct Entering {
  float gradient;
  std::int64_t number;
  Index place;  ///< on the rank that holds it, else -1

  /// Whether the other one enters before this one.
  bool operator<(const Entering& other) const {
    return gradient != other.gradient ? gradient < other.gradient : number > other.number;
  }
};

using Numbers = std::unordered_set<std::int64_t>;

/// The columns of this rank that come first.
std::vector<Entering> first_of_rank(const DistributedColumns& columns, const Eigen::VectorXd& gradients,
                                    double threshold, const Numbers& excluded) {
  std::vector<Entering> heap, first;
  for (Index i = 0; i < gradients.size(); ++i)
    if (gradients[i] > threshold)
      heap.push_back({static_cast<float>(gradients[i]), columns.numbers[static_cast<std::size_t>(i)], i});
  std::make_heap(heap.begin(), heap.end());
  while (!heap.empty() && static_cast<Index>(first.size()) < most_listed) {
    std::pop_heap(heap.begin(), heap.end());
    if (!excluded.contains(heap.back().number)) first.push_back(heap.back());
    heap.pop_back();
  }
  return first;
}

/// Those of all ranks. *Collective*.
std::vector<Entering> first_of_all(MPI_Comm comm, const std::vector<Entering>& mine) {
  std::vector<double> gradients;
  std::vector<std::int64_t> numbers;
  for (const auto& column : mine) {
    gradients.push_back(column.gradient);
    numbers.push_back(column.number);
  }
  const auto all_gradients = parallel::gather_all(comm, gradients);
  const auto all_numbers = parallel::gather_all(comm, numbers);
  std::vector<Entering> all;
  for (std::size_t i = 0; i < all_numbers.size(); ++i)
    all.push_back({static_cast<float>(all_gradients[i]), all_numbers[i], -1});
  std::sort(all.rbegin(), all.rend());
  all.resize(std::min(all.size(), std::size_t{most_listed}));
  for (auto& column : all)
    for (const auto& own : mine)
      if (own.number == column.number) column.place = own.place;
  return all;
}

/// These columns, on every rank. *Collective*.
Eigen::MatrixXd fetch(MPI_Comm comm, const DistributedColumns& columns, const std::vector<Entering>& listed,
                      Index rows) {
  std::vector<Index> places, to;
  for (std::size_t j = 0; j < listed.size(); ++j)
    if (listed[j].place >= 0) {
      places.push_back(listed[j].place);
      to.push_back(static_cast<Index>(j));
    }
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(rows, static_cast<Index>(listed.size()));
  if (!places.empty()) values(Eigen::all, to) = columns.columns(places);
  parallel::sum_in_place(comm, values);
  return values;
}

/// The listed column with the largest gradient, with its place in the list; nothing where none is above `least`.
std::optional<Entering> best_of(const std::vector<Entering>& listed, const Eigen::VectorXd& gradients, double least,
                                const Numbers& excluded) {
  std::optional<Entering> best;
  for (Index j = 0; j < gradients.size(); ++j) {
    const Entering column{static_cast<float>(gradients[j]), listed[static_cast<std::size_t>(j)].number, j};
    if (gradients[j] > least && !excluded.contains(column.number) && (!best || *best < column)) best = column;
  }
  return best;
}

NonnegativeFit fit_of(const PassiveSet& set, Eigen::VectorXd residual) {
  return {set.numbers(), set.weights(), std::move(residual)};
}

}  // namespace

NonnegativeFit nonnegative_least_squares(MPI_Comm comm, const DistributedColumns& columns, const Eigen::VectorXd& b,
                                         const FitEnd& end, const FitReached& reached) {
  PassiveSet set(b);
  Eigen::VectorXd residual = b, gradients = columns.products(b);
  const double threshold =
      end.tolerance * parallel::max(comm, gradients.size() > 0 ? std::max(0.0, gradients.maxCoeff()) : 0.0);
  Index wanted = end.first;
  Numbers useless;  // columns that did not improve the present fit
  for (;; gradients = columns.products(residual)) {
    Numbers excluded = useless;
    excluded.insert(set.numbers().begin(), set.numbers().end());
    const auto listed = first_of_all(comm, first_of_rank(columns, gradients, threshold, excluded));
    if (listed.empty()) break;
    const Eigen::MatrixXd values = fetch(comm, columns, listed, b.size());
    const double unlisted = static_cast<Index>(listed.size()) < most_listed ? 0.0 : double{listed.back().gradient};
    Index entered = 0;
    for (double least = threshold; entered < most_entering; least = std::max(threshold, unlisted)) {
      const auto best = best_of(listed, values.transpose() * residual, least, excluded);
      if (!best) break;
      excluded.insert(best->number);
      if (!set.append(best->number, values.col(best->place))) continue;
      set.improve();
      const Eigen::VectorXd next = set.residual();
      entered += next.norm() < residual.norm() ? 1 : 0;
      residual = next;
      if (set.size() < std::min(wanted, end.most)) continue;
      auto fit = fit_of(set, residual);
      wanted = reached(fit);
      if (wanted <= set.size() || set.size() == end.most) return fit;
    }
    if (entered > 0) useless.clear();
    else
      for (const auto& column : listed) useless.insert(column.number);
  }
  auto fit = fit_of(set, residual);
  fit.optimal = true;
  return fit;
}

}  // namespace ritz::stages
