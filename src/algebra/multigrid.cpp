#include "ritz/algebra/multigrid.hpp"

#include <algorithm>

#include "ritz/algebra/check.hpp"
#include "ritz/algebra/dense.hpp"
#include "ritz/algebra/handle.hpp"
#include "ritz/algebra/matrix.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/random.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::algebra {
namespace {

constexpr int power_steps = 12;            ///< of the estimate of the largest eigenvalue
constexpr double upper = 1.1, lower = .1;  ///< the smoother's interval, relative to that estimate

Preconditioner hierarchy(Mat A, const std::string& prefix) {
  Preconditioner pc;
  PetscBool is_gamg = PETSC_FALSE;
  PetscReal threshold = 0.01;
  check(PCCreate(comm_of(A), pc.out()));
  check(PCSetOptionsPrefix(pc, prefix.c_str()));
  check(PCSetType(pc, PCGAMG));
  check(PCGAMGSetThreshold(pc, &threshold, 1));
  check(PCSetOperators(pc, A, A));
  check(PCSetFromOptions(pc));
  check(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(pc.get()), PCGAMG, &is_gamg));
  if (!is_gamg)
    throw InputError("option -" + prefix +
                     "pc_type: the levels of the multigrid cycle are those of gamg; leave the option out");
  check(PCSetUp(pc));
  return pc;
}

/// PETSc's list of matrices, one for each level but one, which it leaves to its caller.
std::vector<Matrix> take(PetscInt levels, Mat* list) {
  std::vector<Matrix> taken(static_cast<std::size_t>(levels - 1));
  for (std::size_t i = 0; i < taken.size(); ++i) *taken[i].out() = list[i];
  check(PetscFree(list));
  return taken;
}

Eigen::VectorXd inverse_diagonal(Mat A) {
  Eigen::VectorXd inverse = diagonal(A);
  for (auto& d : inverse) d = d > 0 ? 1 / d : 0;
  return inverse;
}

Matrix transposed(Mat P) {
  Matrix R;
  check(MatTranspose(P, MAT_INITIAL_MATRIX, R.out()));
  return R;
}

/// The largest eigenvalue of D⁻¹A, from below, by power iterations on a panel.
double largest_eigenvalue(MPI_Comm comm, PanelProduct& A, const Eigen::VectorXd& inverse, PetscInt first_row) {
  Panel x(A.rows(), panel_width), y;
  for (Eigen::Index i = 0; i < x.size(); ++i)
    x.data()[i] =
        uniform(static_cast<std::uint64_t>(i % panel_width), static_cast<std::uint64_t>(first_row + i / panel_width));
  double largest = 0;
  for (int step = 0; step < power_steps; ++step) {
    A.apply(x, y);
    y = inverse.asDiagonal() * y;
    Eigen::MatrixXd squares(2, panel_width);
    squares << x.colwise().squaredNorm(), y.colwise().squaredNorm();
    parallel::sum_in_place(comm, squares);
    const Eigen::ArrayXd growth = (squares.row(1).array() / squares.row(0).array().max(1e-300)).sqrt();
    largest = growth.maxCoeff();
    x = y * (1 / std::max(largest, 1e-300));
  }
  return largest;
}

PetscInt first_row(Mat A) {
  PetscInt first = 0;
  check(MatGetOwnershipRange(A, &first, nullptr));
  return first;
}

}  // namespace

void attach_near_null(Mat A, const ConstTallRef& columns) {
  const auto owned = as_vectors(A, columns);
  for (std::size_t j = 0; j < owned.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      PetscScalar dot = 0;
      check(VecDot(owned[j], owned[i], &dot));
      check(VecAXPY(owned[j], -dot, owned[i]));
    }
    check(VecNormalize(owned[j], nullptr));
  }
  const std::vector<Vec> list(owned.begin(), owned.end());
  NullSpace space;
  check(MatNullSpaceCreate(comm_of(A), PETSC_FALSE, static_cast<PetscInt>(list.size()), list.data(), space.out()));
  check(MatSetNearNullSpace(A, space));
}

/// A level that is smoothed: its matrix, and the way to the next coarser one.
class Multigrid::Level {
 public:
  Level(Mat A, Mat P)
      : restriction_matrix_(transposed(P)),
        A_(A),
        interpolation_(P),
        restriction_(restriction_matrix_),
        inverse_(inverse_diagonal(A)) {
    const double largest = largest_eigenvalue(comm_of(A), A_, inverse_, first_row(A));
    centre_ = (upper + lower) / 2 * largest;
    radius_ = (upper - lower) / 2 * largest;
  }

  /// Two Chebyshev steps from zero.
  void smooth_from_zero(const Panel& b, Panel& x) {
    step_ = inverse_.asDiagonal() * b / centre_;
    x = step_;
    residual_ = b;
    second_step(x);
  }

  /// Two Chebyshev steps from x.
  void smooth(const Panel& b, Panel& x) {
    residual_ = b;
    A_.subtract(x, residual_);
    step_ = inverse_.asDiagonal() * residual_ / centre_;
    x += step_;
    second_step(x);
  }

  /// Pᵀ (b − A x).
  void restrict_residual(const Panel& b, const Panel& x, Panel& coarse) {
    residual_ = b;
    A_.subtract(x, residual_);
    restriction_.apply(residual_, coarse);
  }

  void add_correction(const Panel& coarse, Panel& x) {
    interpolation_.apply(coarse, residual_);
    x += residual_;
  }

  Panel coarse_r, coarse_z;

 private:
  /// The residual has not yet felt the step just made.
  void second_step(Panel& x) {
    A_.subtract(step_, residual_);
    const double ratio = radius_ / centre_, rho = 1 / (2 / ratio - ratio);
    step_ = rho * ratio * step_ + (2 * rho / radius_) * (inverse_.asDiagonal() * residual_);
    x += step_;
  }

  Matrix restriction_matrix_;
  PanelProduct A_, interpolation_, restriction_;
  Eigen::VectorXd inverse_;
  double centre_ = 1, radius_ = 1;
  Panel residual_, step_;
};

/// The coarsest matrix, whole on every rank, and its pseudo-inverse: aggregates of few vertices leave it singular.
class Multigrid::Coarsest {
 public:
  explicit Coarsest(Mat A) : comm_(comm_of(A)), first_(first_row(A)) {
    PetscInt total = 0;
    check(MatGetSize(A, &total, nullptr));
    check(MatGetLocalSize(A, &rows_, nullptr));
    Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(total, total);
    for (PetscInt i = first_; i < first_ + rows_; ++i) {
      PetscInt count = 0;
      const PetscInt* columns = nullptr;
      const PetscScalar* values = nullptr;
      check(MatGetRow(A, i, &count, &columns, &values));
      for (PetscInt k = 0; k < count; ++k) whole(i, columns[k]) = values[k];
      check(MatRestoreRow(A, i, &count, &columns, &values));
    }
    parallel::sum_in_place(comm_, whole);
    const auto [eigenvalues, vectors] = symmetric_eigen((whole + whole.transpose()) / 2);
    const double least = 1e-12 * eigenvalues.tail(1)[0];
    const Eigen::VectorXd inverse = (eigenvalues.array() > least).select(eigenvalues.array().inverse(), 0.0);
    inverse_ = vectors * inverse.asDiagonal() * vectors.transpose();
  }

  void solve(const Panel& r, Panel& z) const {
    Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(inverse_.rows(), panel_width);
    whole.middleRows(first_, rows_) = r;
    parallel::sum_in_place(comm_, whole);
    z = inverse_.middleRows(first_, rows_) * whole;
  }

 private:
  MPI_Comm comm_;
  PetscInt first_, rows_ = 0;
  Eigen::MatrixXd inverse_;
};

Multigrid::Multigrid(Mat A, const ConstTallRef& near_null, const std::string& prefix) {
  attach_near_null(A, near_null);
  hierarchy_ = hierarchy(A, prefix);
  PetscInt coarse_levels = 0, between_levels = 0;
  Mat *coarse_list = nullptr, *between_list = nullptr;
  check(PCGetCoarseOperators(hierarchy_, &coarse_levels, &coarse_list));
  check(PCGetInterpolations(hierarchy_, &between_levels, &between_list));
  const auto coarser = take(coarse_levels, coarse_list), between = take(between_levels, between_list);
  // PETSc counts from the coarsest level; the finest is A itself.
  for (std::size_t i = between.size(); i-- > 0;)
    levels_.push_back(std::make_unique<Level>(i + 1 == between.size() ? A : coarser[i + 1].get(), between[i]));
  coarsest_ = std::make_unique<Coarsest>(coarser.empty() ? A : coarser[0].get());
}

Multigrid::~Multigrid() = default;

int Multigrid::levels() const { return static_cast<int>(levels_.size()) + 1; }

void Multigrid::cycle(std::size_t level, const Panel& r, Panel& z) const {
  if (level == levels_.size()) return coarsest_->solve(r, z);
  Level& at = *levels_[level];
  at.smooth_from_zero(r, z);
  at.restrict_residual(r, z, at.coarse_r);
  cycle(level + 1, at.coarse_r, at.coarse_z);
  at.add_correction(at.coarse_z, z);
  at.smooth(r, z);
}

void Multigrid::apply(const ConstTallRef& r, TallRef z) const {
  each_panel(r, z, [&](const Panel& from, Panel& to) { cycle(0, from, to); });
}

}  // namespace ritz::algebra
