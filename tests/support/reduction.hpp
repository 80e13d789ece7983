// A problem whose modes are found, and whose factorization is kept for what comes after them.
#pragma once
#include "ritz/stages/basis.hpp"
#include "support/problem.hpp"

namespace ritz::test {

struct Reduced {
  Problem p;
  stages::ModesResult modes;
  algebra::Tall rigid, flexible;

  stages::DerivativesSource source() const { return {p, modes, flexible, static_cast<int>(flexible.cols())}; }
  Eigen::VectorXd lambda() const { return test::flexible(modes.modes); }
  /// XᵀMY, the same on all ranks. *Collective*.
  Eigen::MatrixXd gram(const algebra::Tall& x, const algebra::Tall& y) const {
    return algebra::inner(p.mesh.comm, x, algebra::multiply(p.matrices.mass, y));
  }
  Eigen::VectorXd norms(const algebra::Tall& x) const { return gram(x, x).diagonal().cwiseMax(0).cwiseSqrt(); }
};

/// *Collective*.
inline Reduced reduced(Problem p, int count, stages::Strategy strategy = stages::Strategy::direct) {
  stages::ModesOptions options;
  options.count = count;
  options.strategy = strategy;
  options.inverse = stages::InverseUse::kept;
  auto found = test::modes(p, options);
  const int rigid = rigid_count(found.modes);
  algebra::Tall R = found.vectors.leftCols(rigid), psi = found.vectors.rightCols(found.vectors.cols() - rigid);
  return {std::move(p), std::move(found), std::move(R), std::move(psi)};
}

/// The box, its half x > ½ of another material where `two`. *Collective*.
inline Problem box_of(const std::string& text, bool free, bool two = false) {
  mesh::Mesh mesh = box(text);
  const std::vector<mesh::Fixed> supports = free ? std::vector<mesh::Fixed>{} : std::vector{fixed("xmin")};
  if (!two) return problem(std::move(mesh), supports);
  mesh.regions.push_back({"stiff", std::nullopt});
  for (int c = 0; c < mesh.cells.count(); ++c)
    mesh.cells.regions[static_cast<std::size_t>(c)] = mesh.corners(c).row(0).mean() > .5;
  return problem(std::move(mesh), supports, {soft, stvk(5e6, .4, 2000)});
}

/// All derivatives of the first modes, a column a pair. *Collective*.
inline stages::DerivativeBlock all_derivatives(const Reduced& r) {
  stages::DerivativeBlock all;
  stages::derivatives(
      r.source(), 1 << 20, [](stages::Pair) { return 1.0; }, [] { return 0.0; },
      [&](const stages::DerivativeBlock& block) { all = block; });
  return all;
}

/// The basis of `options`, without snapshots unless given. *Collective*.
inline stages::BasisResult basis_of(const Reduced& r, const stages::BasisOptions& options,
                                    const algebra::Tall& snapshots = {}) {
  const algebra::Tall none(r.p.dofs.owned, 0);
  return stages::basis(r.p, r.modes, snapshots.cols() ? snapshots : none, none, options,
                       [](const std::string&, double) {});
}

}  // namespace ritz::test
