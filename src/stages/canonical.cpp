#include "ritz/stages/canonical.hpp"

#include <algorithm>

#include "ritz/algebra/dense.hpp"
#include "ritz/algebra/handle.hpp"
#include "ritz/base/random.hpp"

namespace ritz::stages {

mesh::FreeRows fixed_vectors(const mesh::Mesh& mesh, const mesh::Dofs& dofs, int columns, std::uint64_t stream) {
  algebra::Tall x(dofs.owned, columns);
  for (int v = 0; v < mesh.owned; ++v)
    for (int c = 0; c < mesh::components; ++c) {
      if (dofs.fixed(v, c)) continue;
      const auto index =
          static_cast<std::uint64_t>(mesh::components * mesh.file_positions[static_cast<std::size_t>(v)] + c);
      for (int j = 0; j < columns; ++j)
        x(dofs.number(v, c) - dofs.first, j) = uniform(stream + static_cast<std::uint64_t>(j), index);
    }
  return x;
}

namespace {

constexpr double equal_gap = 1e-9;

/// The end of the group of equal eigenvalues that begins at `first`.
Eigen::Index group_end(const Eigen::VectorXd& values, Eigen::Index first) {
  Eigen::Index end = first + 1;
  while (end < values.size() && std::abs(values[end] - values[end - 1]) <= equal_gap * std::abs(values[end])) ++end;
  return end;
}

}  // namespace

int largest_group(const Eigen::VectorXd& values) {
  Eigen::Index largest = 1;
  for (Eigen::Index i = 0, end = 0; i < values.size(); i = end) {
    end = group_end(values, i);
    largest = std::max(largest, end - i);
  }
  return static_cast<int>(largest);
}

void make_canonical(const algebra::Matrix& M, const Eigen::VectorXd& values, const algebra::ConstTallRef& W,
                    algebra::TallRef vectors) {
  const MPI_Comm comm = algebra::comm_of(M);
  const Eigen::MatrixXd C = algebra::inner(comm, algebra::multiply(M, W), vectors);
  for (Eigen::Index i = 0, end = 0; i < values.size(); i = end) {
    end = group_end(values, i);
    const auto size = end - i;
    // C = S O with S symmetric positive definite and O orthogonal (polar decomposition); Ψ Oᵀ turns C into S.
    const Eigen::MatrixXd O = algebra::nearest_orthogonal(C.block(0, i, size, size));
    vectors.middleCols(i, size) = (vectors.middleCols(i, size) * O.transpose()).eval();
  }
}

}  // namespace ritz::stages
