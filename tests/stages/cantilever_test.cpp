// How well a basis carries the statics of the shared cantilever.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "ritz/runtime/statics.hpp"
#include "ritz/stages/reduce_polynomial.hpp"
#include "support/reduction.hpp"

namespace ritz::test {
namespace {

using algebra::Tall;

const std::filesystem::path known = std::filesystem::path(RITZ_SHARED) / "verification" / "tet4_cantilever";

/// Dead end loads p EI/L² along −z on a cantilever, against states of the full model computed elsewhere.
class Cantilever : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(known)) GTEST_SKIP() << "the verification data is not here";
  }

  static Reduced cantilever(int modes) {
    mesh::Source source;
    source.mesh = known / "cantilever.inp";
    return reduced(problem(mesh::read(MPI_COMM_WORLD, source), {fixed("clamp")}), modes);
  }

  static Tall truth(const Reduced& r, const std::string& p) {
    std::map<std::int64_t, Eigen::Vector3d> all;
    std::ifstream in(known / ("static_p" + p + "_all_vertices.csv"));
    std::string line;
    std::getline(in, line);
    std::int64_t id = 0;
    char comma = 0;
    for (Eigen::Vector3d u; in >> id >> comma >> u[0] >> comma >> u[1] >> comma >> u[2];) all[id] = u;
    Tall u(3 * r.p.mesh.owned, 1);
    for (int v = 0; v < r.p.mesh.owned; ++v)
      u.block<3, 1>(3 * v, 0) = all.at(r.p.mesh.ids[static_cast<std::size_t>(v)]);
    return mesh::from_vertices(r.p.mesh, r.p.dofs, u);
  }

  static Tall end_load(const Reduced& r, double total) {
    const mesh::Set& tip = *r.p.mesh.find("tip");
    Tall f = Tall::Zero(3 * r.p.mesh.owned, 1);
    for (const int v : tip.vertices)
      if (v < r.p.mesh.owned) f(3 * v + 2, 0) = -total / static_cast<double>(tip.vertices_total);
    return mesh::from_vertices(r.p.mesh, r.p.dofs, f);
  }

  /// Relative M-norm errors of the reduced statics on U at p = .5, 2, 8.
  static std::vector<double> errors(const Reduced& r, const Tall& U) {
    const auto polynomial = stages::reduce_polynomial(r.p, *stages::polynomial_laws(r.p.materials),
                                                      mesh::to_vertices(r.p.mesh, r.p.dofs, U));
    const auto model = runtime::make_model<double>(polynomial, {});
    auto room = runtime::make_static_workspace(model);
    Eigen::VectorXd z = Eigen::VectorXd::Zero(U.cols()), last = z;
    std::vector<double> found;
    for (const char* p : {"0.5", "2", "8"}) {
      const Eigen::VectorXd load = algebra::inner(r.p.mesh.comm, U, end_load(r, 1.8 * std::stod(p)));
      EXPECT_FALSE(runtime::solve_static<double>(model, {.begin = last, .end = load}, z, room).failure);
      last = load;
      const Tall u = truth(r, p);
      found.push_back(r.norms(U * z - u)[0] / r.norms(u)[0]);
    }
    return found;
  }

  static void expect_errors(const Reduced& r, const Tall& U, const std::vector<double>& expected) {
    const auto found = errors(r, U);
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(found[i] / expected[i], 1, .2) << found[i];
  }
};

TEST_F(Cantilever, ModesAloneLock) {
  const Reduced r = cantilever(6);
  expect_errors(r, r.flexible.leftCols(6), {.672, .835, .886});
}

TEST_F(Cantilever, FortyModesAloneLockAsWell) {
  const Reduced r = cantilever(40);
  expect_errors(r, r.flexible.leftCols(40), {.646, .819, .870});
}

TEST_F(Cantilever, DerivativesUnlockIt) {
  const Reduced r = cantilever(4);
  const auto b = basis_of(r, {.modes = {}, .derivatives = 4, .cut = {}});
  EXPECT_EQ(b.U.cols(), 14);
  expect_errors(r, b.U, {3.6e-3, 3.4e-3, 1.8e-2});
}

TEST_F(Cantilever, EightAndTwelveOfEq18) {
  const Reduced r = cantilever(6);
  expect_errors(r, basis_of(r, {.modes = {}, .derivatives = 6, .cut = {.size = 8, .tolerance = 1e-12}}).U,
                {3.6e-3, 3.4e-3, 2.4e-2});
  expect_errors(r, basis_of(r, {.modes = {}, .derivatives = 6, .cut = {.size = 12, .tolerance = 1e-12}}).U,
                {1.1e-3, 1.4e-3, 7.2e-3});
}

}  // namespace
}  // namespace ritz::test
