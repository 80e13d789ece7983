#include "ritz/algebra/eigensolver.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "ritz/algebra/check.hpp"
#include "ritz/algebra/csr.hpp"
#include "ritz/algebra/factorization.hpp"
#include "ritz/algebra/handle.hpp"

namespace ritz::algebra {
namespace {

constexpr const char* prefix = "modes_";

std::vector<Vec> raw(const std::vector<Vector>& list) { return {list.begin(), list.end()}; }

ST spectral_transformation(EPS eps) {
  ST st = nullptr;
  check(EPSGetST(eps, &st));
  return st;
}

/// PC cholesky by MUMPS under shift-invert.
void use_shift_invert(EPS eps, double shift) {
  const ST st = spectral_transformation(eps);
  KSP ksp = nullptr;
  check(STSetType(st, STSINVERT));
  check(EPSSetTarget(eps, shift));
  check(EPSSetWhichEigenpairs(eps, EPS_TARGET_MAGNITUDE));
  check(STGetKSP(st, &ksp));
  use_mumps(ksp);
}

EigenSolver create(MPI_Comm comm) {
  EigenSolver eps;
  check(EPSCreate(comm, eps.out()));
  check(EPSSetOptionsPrefix(eps, prefix));
  check(EPSSetProblemType(eps, EPS_GHEP));
  check(EPSSetType(eps, EPSKRYLOVSCHUR));
  return eps;
}

void prepare(EPS eps, Mat K, Mat M, const std::vector<Vector>& deflated, int wanted, double tolerance) {
  check(EPSSetOperators(eps, K, M));
  check(EPSSetDimensions(eps, wanted, PETSC_DEFAULT, PETSC_DEFAULT));
  check(EPSSetTolerances(eps, tolerance, 1000));
  auto list = raw(deflated);
  if (!list.empty()) check(EPSSetDeflationSpace(eps, static_cast<PetscInt>(list.size()), list.data()));
  check(EPSSetFromOptions(eps));
}

EigenPairs solved(EPS eps, Mat K, int wanted) {
  check(EPSSolve(eps));
  EigenPairs pairs;
  PetscInt converged = 0, iterations = 0, rows = 0;
  check(EPSGetConverged(eps, &converged));
  check(EPSGetIterationNumber(eps, &iterations));
  check(MatGetLocalSize(K, &rows, nullptr));
  pairs.iterations = static_cast<int>(iterations);
  const int count = std::min<int>(wanted, converged);
  std::vector<double> values(static_cast<std::size_t>(count));
  Tall vectors(rows, count);
  Vector x;
  check(MatCreateVecs(K, x.out(), nullptr));
  for (int j = 0; j < count; ++j) {
    PetscScalar value = 0;
    const PetscScalar* entries = nullptr;
    check(EPSGetEigenpair(eps, j, &value, nullptr, x, nullptr));
    values[static_cast<std::size_t>(j)] = value;
    check(VecGetArrayRead(x, &entries));
    std::copy_n(entries, rows, vectors.col(j).data());
    check(VecRestoreArrayRead(x, &entries));
  }
  std::vector<Eigen::Index> order(values.size());
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(),
            [&](auto a, auto b) { return values[static_cast<std::size_t>(a)] < values[static_cast<std::size_t>(b)]; });
  pairs.values.resize(count);
  pairs.vectors.resize(rows, count);
  for (int j = 0; j < count; ++j) {
    pairs.values[j] = values[static_cast<std::size_t>(order[static_cast<std::size_t>(j)])];
    pairs.vectors.col(j) = vectors.col(order[static_cast<std::size_t>(j)]);
  }
  return pairs;
}

}  // namespace

EigenPairs krylov_schur(Mat K, Mat M, double shift, const ConstTallRef& deflated, int wanted, double tolerance) {
  const EigenSolver eps = create(comm_of(K));
  use_shift_invert(eps, shift);
  const auto space = as_vectors(K, deflated);
  prepare(eps, K, M, space, wanted, tolerance);
  return solved(eps, K, wanted);
}

void read_eigensolver_options(MPI_Comm comm) {
  constexpr PetscInt size = 99;  // some solvers refuse what is small beside their blocks
  const Matrix K = tiny_identity(comm, size), M = tiny_identity(comm, size);
  check(MatScale(K, 1.2345678901));  // no shift that a user gives makes K - shift M singular
  const EigenSolver eps = create(comm);
  use_shift_invert(eps, 0);
  prepare(eps, K, M, {}, 1, 1e-8);
  check(EPSSetUp(eps));
}

}  // namespace ritz::algebra
