#include "ritz/stages/derivatives.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "ritz/algebra/dense.hpp"
#include "ritz/algebra/matrix.hpp"
#include "ritz/fem/cell_matrices.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/each_cell.hpp"
#include "ritz/stages/rayleigh_ritz.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;

double smallest_ratio(const Cell& cell) {
  const fem::VertexMatrix M = fem::mass(cell.type, cell.x, 1);
  const Eigen::VectorXd root = M.diagonal().cwiseSqrt().cwiseInverse();
  return algebra::symmetric_eigenvalues(root.asDiagonal() * M * root.asDiagonal())[0];
}

/// m: M ≥ m D. A straight linear tetrahedron has ½ whatever its shape.
double mass_ratio(const Problem& problem) {
  double least = 0.5;
  each_owned_cell(problem.mesh, problem.materials, [&](const Cell& cell) {
    if (cell.type != fem::CellType::tet4) least = std::min(least, smallest_ratio(cell));
  });
  return parallel::min(problem.mesh.comm, least);
}

/// Upper bounds of ‖b_j‖_{M⁻¹}.
class InverseMassNorm {
 public:
  explicit InverseMassNorm(const Problem& problem) : comm_(problem.mesh.comm) {
    const Eigen::ArrayXd diagonal = algebra::diagonal(problem.matrices.mass).array();
    inverse_root_ = (diagonal * mass_ratio(problem)).sqrt().inverse().matrix();
  }

  Eigen::ArrayXd operator()(const algebra::Tall& b) const {
    return algebra::column_norms(comm_, inverse_root_.asDiagonal() * b).array();
  }

 private:
  MPI_Comm comm_;
  Eigen::VectorXd inverse_root_;
};

/// Upper bounds of ‖K⁻¹b_j‖_M, b without resultants.
class InverseBound {
 public:
  InverseBound(const Problem& problem, const ModesResult& modes)
      : comm_(problem.mesh.comm),
        norm_(problem),
        known_(flexible_modes(modes)),
        massive_(algebra::multiply(problem.matrices.mass, known_)),
        eigenvalues_(modes.modes.eigenvalues.tail(known_.cols())),
        least_of_rest_(modes.modes.certificate.kind == model::Certified::no ? eigenvalues_[0]
                                                                            : eigenvalues_.tail(1)[0]) {}

  Eigen::ArrayXd operator()(const algebra::Tall& b) const {
    const Eigen::MatrixXd parts = algebra::inner(comm_, known_, b);
    algebra::Tall rest = b;
    algebra::subtract(rest, massive_, parts);
    const Eigen::ArrayXd solved = (eigenvalues_.cwiseInverse().asDiagonal() * parts).colwise().squaredNorm();
    return (solved + (norm_(rest) / least_of_rest_).square()).sqrt();
  }

 private:
  MPI_Comm comm_;
  InverseMassNorm norm_;
  algebra::ConstTallRef known_;
  algebra::Tall massive_;
  Eigen::VectorXd eigenvalues_;
  double least_of_rest_;
};

/// The row behind the last one of a block of at least `columns` pairs that begins with row `first`.
int last_row(int first, int rows, int modes, int columns) {
  int count = 0, row = first;
  while (row < rows && count < columns) count += modes - row++;
  return row;
}

/// Divides the pairs of a block into those to solve and those that cannot matter.
std::vector<Index> worth_solving(const std::vector<Pair>& pairs, const Eigen::ArrayXd& bounds, double allowed,
                                 DerivativeCounts& counts) {
  std::vector<Index> solved;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const auto n = static_cast<Index>(p);
    const double skipped = counts.skipped + bounds[n] * bounds[n];
    if (skipped < allowed * allowed) counts.skipped = skipped;
    else solved.push_back(n);
  }
  counts.pairs += static_cast<int>(pairs.size());
  counts.solved += static_cast<int>(solved.size());
  return solved;
}

/// Even parts of `columns` or more, of less than twice as many: a row of many modes is longer than a block.
std::vector<std::span<const Index>> parts(const std::vector<Index>& chosen, std::size_t columns) {
  const std::size_t count = std::max<std::size_t>(1, chosen.size() / columns);
  std::vector<std::span<const Index>> all;
  for (std::size_t n = 0; n < count && !chosen.empty(); ++n) {
    const std::size_t from = n * chosen.size() / count, to = (n + 1) * chosen.size() / count;
    all.push_back(std::span(chosen).subspan(from, to - from));
  }
  return all;
}

}  // namespace

DerivativeCounts derivatives(const DerivativesSource& source, int columns, const std::function<double(Pair)>& weight,
                             const std::function<double()>& allowed,
                             const std::function<void(const DerivativeBlock&)>& take) {
  const auto& [problem, found, flexible, rows] = source;
  const auto& [mesh, dofs, materials, matrices] = problem;
  const algebra::Tall rigid = rigid_modes(found);
  const mesh::LocalRows local = mesh::with_ghosts(mesh, mesh::to_vertices(mesh, dofs, flexible), mesh::components);
  const InverseBound bound(problem, found);
  const double norm_K = algebra::one_norm(matrices.stiffness);
  const algebra::Tall massive = algebra::multiply(matrices.mass, rigid);
  const int modes = static_cast<int>(flexible.cols());
  DerivativeCounts counts;
  for (int first = 0, last = 0; first < rows; first = last) {
    last = last_row(first, rows, modes, columns);
    const auto pairs = pairs_of_rows(first, last, modes);
    algebra::Tall loads = derivative_loads(problem, local, first, last);
    // Without their resultants, so that the bounds are of what is solved.
    if (rigid.cols() > 0) algebra::subtract(loads, massive, algebra::inner(mesh.comm, rigid, loads));
    Eigen::ArrayXd bounds = bound(loads);
    for (std::size_t p = 0; p < pairs.size(); ++p) bounds[static_cast<Index>(p)] *= weight(pairs[p]);
    const auto chosen = worth_solving(pairs, bounds, allowed(), counts);
    for (const auto part : parts(chosen, static_cast<std::size_t>(columns))) {
      auto solved =
          solve(matrices, found.inverse, rigid, norm_K, loads(Eigen::all, std::vector(part.begin(), part.end())));
      counts.iterations = std::max(counts.iterations, solved.iterations);
      counts.residual = std::max(counts.residual, solved.residual);
      DerivativeBlock block{{}, std::move(solved.x)};
      for (const Index p : part) block.pairs.push_back(pairs[static_cast<std::size_t>(p)]);
      take(block);
    }
  }
  return counts;
}

}  // namespace ritz::stages
