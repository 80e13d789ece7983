#include "support/problem.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "ritz/algebra/factorization.hpp"
#include "ritz/mesh/part.hpp"
#include "ritz/mesh/quality.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::test {
namespace {

using Eigen::Index;

/// Eigenvalues below σ by a factorization of its own. *Collective*.
std::int64_t count_below(const Problem& p, double sigma) {
  algebra::Factorization solver(p.mesh.comm, "count_");
  solver.factor(p.matrices.stiffness, p.matrices.mass, sigma);
  return solver.negative_pivots();
}

void expect_small_residuals(const Problem& p, const stages::ModesResult& result) {
  const MPI_Comm comm = p.mesh.comm;
  const algebra::Tall mx = algebra::multiply(p.matrices.mass, result.vectors),
                      kx = algebra::multiply(p.matrices.stiffness, result.vectors);
  const Eigen::VectorXd& lambda = result.modes.eigenvalues;
  const Eigen::VectorXd r = algebra::column_norms(comm, kx - mx * lambda.asDiagonal());
  const Eigen::VectorXd force = lambda.cwiseProduct(algebra::column_norms(comm, mx));
  PetscReal norm_K = 0;
  MatNorm(p.matrices.stiffness, NORM_INFINITY, &norm_K);
  const Eigen::VectorXd floor =
      10 * std::numeric_limits<double>::epsilon() * norm_K * algebra::column_norms(comm, result.vectors);
  for (Index i = 0; i < lambda.size(); ++i) {
    EXPECT_LE(r[i], std::max(1e-8 * force[i], floor[i])) << "mode " << i;
    if (rigid_count(result.modes) > i) continue;
    EXPECT_EQ(result.modes.floor_applies[static_cast<std::size_t>(i)] != 0, result.modes.residuals[i] > 1e-8);
  }
  const Eigen::MatrixXd gram = algebra::inner(comm, result.vectors, mx);
  EXPECT_LE((gram - Eigen::MatrixXd::Identity(lambda.size(), lambda.size())).lpNorm<Eigen::Infinity>(), 1e-12);
}

}  // namespace

fem::Materials neo_hookean(fem::Materials materials) {
  for (auto& material : materials)
    material.law = fem::NeoHookean{material.at_rest().young(), material.at_rest().poisson()};
  return materials;
}

DenseModes dense_modes(const Problem& p) { return dense_modes(dense(p.matrices.stiffness), dense(p.matrices.mass)); }

mesh::Mesh box(const std::string& text) {
  mesh::Source source;
  source.mesh = mesh::parse_box(text);
  return mesh::read(MPI_COMM_WORLD, source);
}

mesh::Mesh distributed(const mesh::FileMesh& whole) {
  auto [part, shared] = mesh::distribute(MPI_COMM_WORLD, whole, mesh::Partitioner::metis);
  mesh::Mesh mesh = mesh::number_part(MPI_COMM_WORLD, std::move(part), std::move(shared));
  mesh::refuse_inverted_cells(mesh);
  return mesh;
}

mesh::Fixed fixed(const std::string& set, std::array<bool, 3> components) { return {set, components, set}; }

mesh::Fixed fixed_between(const Eigen::Vector3d& low, const Eigen::Vector3d& high, std::array<bool, 3> components) {
  return {mesh::Region3{low, high}, components, "box"};
}

Problem problem(mesh::Mesh mesh, const std::vector<mesh::Fixed>& supports, const fem::Materials& materials) {
  mesh::Dofs dofs = mesh::number(mesh, supports, mesh::FileSupports::used);
  return stages::assemble(std::move(mesh), std::move(dofs), materials);
}

stages::ModesResult modes(const Problem& p, stages::ModesOptions options) {
  const algebra::Tall none(p.dofs.owned, 0);
  auto result = stages::linear_modes(p, options, none, none, [](const std::string&, double) {});
  expect_sound(p, options, result);
  return result;
}

stages::ModesResult modes(const Problem& p, int count) {
  stages::ModesOptions options;
  options.count = count;
  return modes(p, options);
}

void expect_sound(const Problem& p, const stages::ModesOptions& options, const stages::ModesResult& result) {
  const model::Modes& m = result.modes;
  const Eigen::VectorXd lambda = flexible(m);
  const Index rigid = rigid_count(m);
  expect_small_residuals(p, result);
  EXPECT_GE(lambda.size(), std::min<Index>(options.count, p.dofs.total - rigid));
  EXPECT_TRUE(std::is_sorted(m.eigenvalues.begin(), m.eigenvalues.end()));
  EXPECT_TRUE((lambda.array() > 0).all());
  if (options.strategy == stages::Strategy::iterative || lambda.size() == 0) {
    EXPECT_EQ(m.certificate.kind, model::Certified::no);
    return;
  }
  EXPECT_EQ(m.certificate.kind, model::Certified::inertia);
  EXPECT_EQ(m.certificate.counted, m.certificate.found);
  EXPECT_EQ(m.certificate.counted, count_below(p, m.certificate.shift));
  EXPECT_GT(m.certificate.shift, lambda[lambda.size() - 1]);
  // Between the last mode kept and a cluster's width behind it there is nothing: the cluster is whole. Very slender
  // bodies excepted, where the rounding of K alone moves the pencil's eigenvalues by more than that.
  if (m.floor_applies.back()) return;
  EXPECT_EQ(count_below(p, lambda[lambda.size() - 1] * (1 + .99e-6)), rigid + lambda.size());
}

int rigid_count(const model::Modes& modes) {
  return static_cast<int>(std::count(modes.kinds.begin(), modes.kinds.end(), model::ModeKind::rigid));
}

Eigen::VectorXd flexible(const model::Modes& modes) {
  return modes.eigenvalues.tail(modes.eigenvalues.size() - rigid_count(modes));
}

Eigen::VectorXd frequencies(const model::Modes& modes) { return flexible(modes).cwiseSqrt() / (2 * std::numbers::pi); }

Eigen::MatrixXd whole(MPI_Comm comm, const algebra::Tall& rows) {
  const algebra::Tall transposed = rows.transpose();
  const auto all =
      parallel::gather_all(comm, std::vector<double>(transposed.data(), transposed.data() + transposed.size()));
  const auto columns = rows.cols();
  return Eigen::Map<const Eigen::MatrixXd>(all.data(), columns, static_cast<Index>(all.size()) / columns).transpose();
}

Eigen::MatrixXd dense(Mat A) {
  const MPI_Comm comm = PetscObjectComm(reinterpret_cast<PetscObject>(A));
  PetscInt first = 0, end = 0, total = 0;
  MatGetOwnershipRange(A, &first, &end);
  MatGetSize(A, &total, nullptr);
  algebra::Tall unit = algebra::Tall::Zero(end - first, total);
  for (PetscInt i = first; i < end; ++i) unit(i - first, i) = 1;
  return whole(comm, algebra::multiply(A, unit));
}

}  // namespace ritz::test
