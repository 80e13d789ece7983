#include "ritz/algebra/factorization.hpp"

#include <algorithm>
#include <new>
#include <string>

#include "ritz/algebra/check.hpp"
#include "ritz/algebra/handle.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::algebra {
namespace {

constexpr PetscInt columns_at_once = 27;  // MUMPS ICNTL(27)
constexpr int widest_block = 64;

Mat factor_matrix(KSP ksp) {
  Mat F = nullptr;
  check(PCFactorGetMatrix(preconditioner(ksp), &F));
  return F;
}

}  // namespace

Factorization::Factorization(MPI_Comm comm, const std::string& prefix) : comm_(comm) {
  check(KSPCreate(comm, ksp_.out()));
  check(KSPSetOptionsPrefix(ksp_, prefix.c_str()));
  use_mumps(ksp_);
  check(KSPSetFromOptions(ksp_));
}

Mat Factorization::prepared() {
  const char* prefix = nullptr;
  check(KSPGetOptionsPrefix(ksp_, &prefix));
  check(MatSetOptionsPrefixFactor(shifted_, prefix));
  check(KSPSetOperators(ksp_, shifted_, shifted_));
  Mat F = mumps_factor(ksp_);
  if (!F) return nullptr;
  prepare_mumps(F, margin_);
  check(MatMumpsSetIcntl(F, columns_at_once, -widest_block));
  return F;
}

FactorEstimate Factorization::analyse(Mat K) {
  check(MatDuplicate(K, MAT_COPY_VALUES, shifted_.out()));
  Mat F = prepared();
  FactorEstimate estimate;
  if (!F) return estimate;
  MatFactorInfo info;
  check(MatFactorInfoInitialize(&info));
  check(MatCholeskyFactorSymbolic(F, shifted_, nullptr, &info));
  PetscInt largest = 0, total = 0, entries = 0;
  check(MatMumpsGetInfog(F, 20, &entries));
  estimate.entries = entries < 0 ? -1e6 * entries : entries;  // MUMPS counts in millions by negative numbers
  check(MatMumpsGetRinfog(F, 1, &estimate.flops));
  check(MatMumpsGetInfog(F, 16, &largest));
  check(MatMumpsGetInfog(F, 17, &total));
  estimate.memory_rank = 1e6 * largest;
  estimate.memory_total = 1e6 * total;
  return estimate;
}

void Factorization::factor(Mat K, Mat M, double sigma) {
  // The same matrix object all the time: PETSc then keeps the analysis.
  if (!shifted_) check(MatDuplicate(K, MAT_COPY_VALUES, shifted_.out()));
  else check(MatCopy(K, shifted_, SAME_NONZERO_PATTERN));
  if (sigma != 0) check(MatAXPY(shifted_, -sigma, M, SUBSET_NONZERO_PATTERN));
  const std::string what = sigma == 0 ? std::string("K") : "K - sigma M, sigma " + shown(sigma);
  for (int attempt = 0;; ++attempt) {
    Mat F = prepared();
    MatFactorError error = MAT_FACTOR_NOERROR;
    check(KSPSetUp(ksp_));
    check(MatFactorGetError(factor_matrix(ksp_), &error));
    if (error == MAT_FACTOR_NOERROR) return;
    const MumpsFailure failure = F ? mumps_failure(F) : MumpsFailure::other;
    if (failure == MumpsFailure::memory)
      throw NumericalError("memory ran out in the factorization of " + what, Reason::memory_for_factors);
    if (failure == MumpsFailure::other || attempt == 4)
      throw NumericalError("the factorization of " + what + " failed; is the body held as it should be?");
    margin_ = std::max<PetscInt>(40, 2 * margin_);
    check(PCReset(preconditioner(ksp_)));
  }
}

void Factorization::solve(const ConstTallRef& b, TallRef x) const {
  Mat F = factor_matrix(ksp_);
  Tall copy = b;
  for (Eigen::Index first = 0; first < b.cols(); first += widest_block) {
    const auto columns = std::min<Eigen::Index>(widest_block, b.cols() - first);
    const Matrix from = as_dense(comm_, copy.middleCols(first, columns));
    const Matrix to = as_dense(comm_, x.middleCols(first, columns));
    try {
      check(MatMatSolve(F, from, to));
    } catch (const NumericalError&) {
      if (mumps_factor(ksp_) && mumps_failure(F) == MumpsFailure::memory) throw std::bad_alloc();
      throw;
    }
  }
}

std::int64_t Factorization::negative_pivots() const {
  PetscInt negative = 0;
  if (Mat F = mumps_factor(ksp_)) check(MatMumpsGetInfog(F, 12, &negative));
  else check(MatGetInertia(factor_matrix(ksp_), &negative, nullptr, nullptr));
  return negative;
}

namespace {

constexpr PetscInt parallel_root = 13, workspace_margin = 14;  // ICNTL

}  // namespace

void use_mumps(KSP ksp) {
  check(KSPSetType(ksp, KSPPREONLY));
  check(PCSetType(preconditioner(ksp), PCCHOLESKY));
  check(PCFactorSetMatSolverType(preconditioner(ksp), MATSOLVERMUMPS));
}

Mat mumps_factor(KSP ksp) {
  PC pc = preconditioner(ksp);
  PetscBool factors = PETSC_FALSE;
  Mat F = nullptr;
  check(PetscObjectTypeCompareAny(reinterpret_cast<PetscObject>(pc), &factors, PCCHOLESKY, PCLU, ""));
  if (!factors) return nullptr;
  check(PCFactorSetUpMatSolverType(pc));
  check(PCFactorGetMatrix(pc, &F));
  MatSolverType type = nullptr;
  check(MatFactorGetSolverType(F, &type));
  return std::string(type) == MATSOLVERMUMPS ? F : nullptr;
}

void prepare_mumps(Mat F, PetscInt spare) {
  check(MatMumpsSetIcntl(F, parallel_root, 1));
  if (spare > 0) check(MatMumpsSetIcntl(F, workspace_margin, spare));
}

MumpsFailure mumps_failure(Mat F) {
  PetscInt code = 0;
  check(MatMumpsGetInfog(F, 1, &code));
  if (code == -13 || code == -19) return MumpsFailure::memory;
  if (code == -8 || code == -9 || code == -17 || code == -20) return MumpsFailure::workspace;
  return MumpsFailure::other;
}

}  // namespace ritz::algebra
