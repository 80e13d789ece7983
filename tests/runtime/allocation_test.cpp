// What runs in a step asks for no memory.
#include <gtest/gtest.h>

#include "ritz/base/simd.hpp"
#include "ritz/runtime/reconstruction.hpp"
#include "ritz/runtime/step.hpp"
#include "runtime/nonlinear_support.hpp"
#include "support/allocations.hpp"
#include "support/sample_cubature.hpp"

namespace ritz::runtime {
namespace {

using test::allocations;

constexpr Eigen::Index many = 300;

Model<double> some_oscillators() {
  return {.force = LinearForce<double>{Eigen::VectorXd::LinSpaced(many, 0, 4e4)},
          .damping = Eigen::VectorXd(Eigen::VectorXd::LinSpaced(many, 0, 3))};
}

TEST(Allocation, IsNoticed) {
  ASSERT_TRUE(test::counts_allocations());
  const auto before = allocations();
  const Eigen::VectorXd zeros = Eigen::VectorXd::Zero(many);
  EXPECT_EQ(allocations(), before + 1) << zeros.sum();
  ::operator delete(::operator new(8));
  EXPECT_EQ(allocations(), before + 2);
  const AlignedVector<double> aligned(3);
  EXPECT_EQ(allocations(), before + 3) << aligned.size();
}

TEST(Allocation, NoneInAStepOfAnyIntegrator) {
  const auto model = some_oscillators();
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(many), force = Eigen::VectorXd::Ones(many);
  for (const auto& integrator : {exact(), implicit_euler(), newmark(), generalized_alpha(), bdf2(),
                                 central_difference(), avf(), linearly_implicit()}) {
    auto state = make_state<double>(model, integrator, rest, rest, force);
    auto workspace = make_workspace<double>(model, integrator, 1e-3);
    const auto before = allocations();
    for (int i = 0; i < 5; ++i) step<double>(model, state, {force, force}, 1e-3, workspace);
    step<double>(model, state, {force, force}, 5e-4, workspace);  // another length of step
    EXPECT_EQ(allocations(), before) << integrator.name;
    EXPECT_GT(state.z().norm(), 0);
  }
}

template <class Scalar>
void expect_no_allocation(Eigen::Index size) {
  for (const auto& method : test::all_methods())
    for (const int iterations : {25, 1}) {  // one iteration: the step is rejected, halved, and given up
      auto motion =
          test::start<Scalar>(test::random_polynomial(size), method, 0.1, Eigen::VectorXd::Ones(size), 1,
                              {.alpha = 0.1, .beta = 0.01, .ratio = {}}, {.iterations = iterations, .halvings = 3});
      const auto before = allocations();
      for (int n = 0; n < 3; ++n) motion.step();
      motion.energy();
      EXPECT_EQ(allocations(), before) << method.name << ' ' << size;
    }
}

TEST(Allocation, NoneInANonlinearStep) {
  expect_no_allocation<double>(7);
  expect_no_allocation<float>(7);
  expect_no_allocation<double>(40);
}

TEST(Allocation, NoneInAStepOfACubature) {
  const auto sample = test::sample_cubature(7, 20, test::all_isotropic_laws(), model::Integrand::beyond_polynomial);
  const Eigen::VectorXd z = Eigen::VectorXd::Constant(7, .3);
  for (const auto& method : test::all_methods()) {
    auto motion = test::start<double>(make_model<double>(sample.cubature, sample.materials, &sample.polynomial,
                                                         {.alpha = 0.1, .beta = 0.01, .ratio = {}}),
                                      method, 0.01, z, 1);
    const auto before = allocations();
    for (int n = 0; n < 3; ++n) motion.step();
    motion.energy();
    EXPECT_EQ(allocations(), before) << method.name;
  }
}

TEST(Allocation, NoneWhereTheMatrixIsIndefinite) {
  auto factors = make_factors<double>(40);
  const Eigen::MatrixXd matrix = Eigen::VectorXd::LinSpaced(40, -1, 2.5).asDiagonal();
  Eigen::VectorXd x = matrix * Eigen::VectorXd::Ones(40);
  const auto before = allocations();
  factor(matrix, factors);
  solve_in_place(factors, x);
  EXPECT_EQ(allocations(), before);
  EXPECT_FALSE(factors.definite);
  EXPECT_LE((x - Eigen::VectorXd::Ones(40)).norm(), 1e-13);
}

TEST(Allocation, NoneInReconstruction) {
  const model::Basis basis{model::RowMatrix::Random(3 * 50, many)};
  const auto model = some_oscillators();
  const Eigen::VectorXd z = Eigen::VectorXd::Random(many);
  const auto state = make_state<double>(model, exact(), z, z, z);
  model::Points u(50, 3);
  const auto before = allocations();
  reconstruct(basis, state.z(), u);
  EXPECT_EQ(allocations(), before);
  const auto copy = make_reconstruction<float>(basis);
  Displacements<float> drawn(50, 3);
  const auto copied = allocations();
  reconstruct<float>(copy, state.z(), drawn);
  EXPECT_EQ(allocations(), copied);
  EXPECT_GT(u.norm(), 0);
}

}  // namespace
}  // namespace ritz::runtime
