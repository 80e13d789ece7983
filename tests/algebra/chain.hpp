// A chain of springs, its spectrum known: K = tridiag(-1, 2, -1), λ_j = 2 - 2 cos(jπ/(n+1)). Of three ranks the middle
// one owns nothing.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "ritz/algebra/csr.hpp"
#include "ritz/algebra/multivector.hpp"
#include "ritz/base/random.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::algebra::test {

inline const MPI_Comm world = MPI_COMM_WORLD;

struct Share {
  PetscInt first, count, total;
};

inline Share my_rows(PetscInt total) {
  const int rank = parallel::rank(world), ranks = parallel::size(world);
  if (ranks == 3) return {rank == 0 ? 0 : total / 3, rank == 0 ? total / 3 : rank == 1 ? 0 : total - total / 3, total};
  const PetscInt first = total * rank / ranks;
  return {first, total * (rank + 1) / ranks - first, total};
}

/// tridiag(off, diagonal, off).
inline Matrix tridiagonal(PetscInt total, double diagonal, double off) {
  const Share rows = my_rows(total);
  Rows parts;
  for (PetscInt i = rows.first; i < rows.first + rows.count; ++i) {
    for (PetscInt j = std::max(0, i - 1); j <= std::min(total - 1, i + 1); ++j) {
      const bool own = j >= rows.first && j < rows.first + rows.count;
      Csr& part = own ? parts.own : parts.other;
      part.columns.push_back(own ? j - rows.first : j);
      part.values.push_back(i == j ? diagonal : off);
    }
    parts.own.starts.push_back(static_cast<PetscInt>(parts.own.columns.size()));
    parts.other.starts.push_back(static_cast<PetscInt>(parts.other.columns.size()));
  }
  return symmetric_matrix(world, std::move(parts), 1, Definite::positive);
}

inline double chain_eigenvalue(PetscInt total, int j) {
  return 2 - 2 * std::cos(j * std::numbers::pi / static_cast<double>(total + 1));
}

/// The whole of tridiag, for Eigen.
inline Eigen::MatrixXd dense(PetscInt total, double diagonal, double off) {
  Eigen::MatrixXd A = diagonal * Eigen::MatrixXd::Identity(total, total);
  A.diagonal(1).setConstant(off);
  A.diagonal(-1).setConstant(off);
  return A;
}

/// Fixed numbers in [-1, 1), and this rank's rows of them.
inline Eigen::MatrixXd whole_random(PetscInt total, int columns, std::uint64_t stream) {
  Eigen::MatrixXd x(total, columns);
  for (Eigen::Index i = 0; i < x.size(); ++i) x.data()[i] = uniform(stream, static_cast<std::uint64_t>(i));
  return x;
}

inline Tall my_part(const Eigen::MatrixXd& whole) {
  const Share rows = my_rows(static_cast<PetscInt>(whole.rows()));
  return whole.middleRows(rows.first, rows.count);
}

inline double max_over_ranks(const Eigen::MatrixXd& x) {
  return parallel::max(world, x.size() ? x.cwiseAbs().maxCoeff() : 0.0);
}

}  // namespace ritz::algebra::test
