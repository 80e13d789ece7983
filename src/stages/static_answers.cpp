#include "ritz/stages/static_answers.hpp"

#include <algorithm>
#include <cmath>

#include "ritz/algebra/dense.hpp"
#include "ritz/stages/canonical.hpp"
#include "ritz/stages/full_loads.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;

constexpr Index solved_at_once = 16;
constexpr double balanced = 1e-9;    ///< of a load: what is left of it where inertia bears it whole, by rounding
constexpr double immaterial = 1e-7;  ///< of the size of an answer: what residual vectors may leave out
constexpr std::uint64_t residual_sign_stream = 3002;

/// √(xᵀKx) of each column.
Eigen::VectorXd energy_norms(const algebra::Matrix& K, const algebra::Tall& x) {
  return algebra::inner(algebra::comm_of(K), x, algebra::multiply(K, x)).diagonal().cwiseMax(0).cwiseSqrt();
}

}  // namespace

UnitLoads unit_loads(const Problem& problem, const std::vector<LoadPlace>& places) {
  const auto& [mesh, dofs, materials, matrices] = problem;
  UnitLoads loads{places, algebra::Tall(dofs.owned, mesh::components * std::ssize(places))};
  Index column = 0;
  for (const auto& place : places)
    for (int axis = 0; axis < mesh::components; ++axis) {
      const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
      const auto force =
          place ? shared_force(mesh, *mesh.find(*place), unit) : body_force(mesh, matrices.scalar_mass, unit);
      loads.columns.col(column++) = mesh::from_vertices(mesh, dofs, force);
    }
  return loads;
}

mesh::FreeRows static_answers(const Matrices& matrices, const Inverse& inverse, const algebra::Tall& rigid,
                              double norm_K, mesh::FreeRef loads) {
  const MPI_Comm comm = algebra::comm_of(matrices.stiffness);
  const algebra::Tall massive = algebra::multiply(matrices.mass, rigid);
  algebra::Tall answers(loads.rows(), loads.cols());
  for (Index first = 0; first < loads.cols(); first += solved_at_once) {
    const Index count = std::min(solved_at_once, loads.cols() - first);
    algebra::Tall b = loads.middleCols(first, count);
    const Eigen::ArrayXd sizes = algebra::column_norms(comm, b).array();
    if (rigid.cols() > 0) algebra::subtract(b, massive, algebra::inner(comm, rigid, b));
    const Eigen::ArrayXd rest = algebra::column_norms(comm, b).array();
    for (Index j = 0; j < count; ++j)
      if (!(rest[j] > balanced * sizes[j])) b.col(j).setZero();
    answers.middleCols(first, count) = solve(matrices, inverse, rigid, norm_K, b).x;
  }
  return answers;
}

RitzPairs residual_vectors(const Problem& problem, mesh::FreeRef against, mesh::FreeRef answers) {
  const auto& [mesh, dofs, materials, matrices] = problem;
  const Eigen::VectorXd sizes = energy_norms(matrices.stiffness, answers);
  algebra::Tall x = answers * sizes.unaryExpr([](double n) { return n > 0 ? 1 / n : 0; }).asDiagonal();
  for (int pass = 0; pass < 2 && against.cols() > 0; ++pass)
    algebra::subtract(x, against, algebra::inner(mesh.comm, against, algebra::multiply(matrices.mass, x)));
  const Eigen::MatrixXd gram = algebra::inner(mesh.comm, x, algebra::multiply(matrices.stiffness, x));
  const auto [squares, directions] = algebra::symmetric_eigen((gram + gram.transpose()) / 2);
  const Index count = (squares.array() > immaterial * immaterial).count();
  if (count == 0) return {Eigen::VectorXd(0), algebra::Tall(x.rows(), 0)};
  const Eigen::MatrixXd turn =
      directions.rightCols(count) * squares.tail(count).cwiseSqrt().cwiseInverse().asDiagonal();
  auto pairs = rayleigh_ritz(matrices.stiffness, matrices.mass, against, algebra::combine(x, turn));
  const auto W = fixed_vectors(mesh, dofs, largest_group(pairs.values), residual_sign_stream);
  make_canonical(matrices.mass, pairs.values, W, pairs.vectors);
  return pairs;
}

std::vector<StaticError> static_errors(const Problem& problem, mesh::FreeRef U, const Eigen::VectorXd& stiffness,
                                       const UnitLoads& loads, mesh::FreeRef answers) {
  const auto& K = problem.matrices.stiffness;
  const Eigen::VectorXd inverse = stiffness.unaryExpr([](double k) { return k > 0 ? 1 / k : 0; });
  const Eigen::MatrixXd z = inverse.asDiagonal() * algebra::inner(problem.mesh.comm, U, loads.columns);
  algebra::Tall missed = answers;
  algebra::subtract(missed, U, z);
  const Eigen::VectorXd all = energy_norms(K, answers), rest = energy_norms(K, missed);
  std::vector<StaticError> errors;
  for (Index j = 0; j < all.size(); ++j)
    if (all[j] > 0)
      errors.push_back({loads.places[static_cast<std::size_t>(j / mesh::components)],
                        static_cast<int>(j % mesh::components), rest[j] / all[j]});
  return errors;
}

}  // namespace ritz::stages
