#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "ritz/runtime/integrators.hpp"
#include "ritz/runtime/reconstruction.hpp"
#include "ritz/runtime/step.hpp"

namespace {
std::atomic<long> news = 0;
}

// Not inlined: the compiler would see malloc's partner in one place and operator new's in another.
[[gnu::noinline]] void* operator new(std::size_t bytes) {
  ++news;
  if (void* p = std::malloc(bytes)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace ritz::runtime {
namespace {

/// While it lives, Eigen throws on allocation.
struct NoEigenMalloc {
  NoEigenMalloc() { Eigen::internal::set_is_malloc_allowed(false); }
  ~NoEigenMalloc() { Eigen::internal::set_is_malloc_allowed(true); }
};

constexpr Eigen::Index r = 300;

Oscillators some_oscillators() {
  return {.stiffness = Eigen::ArrayXd::LinSpaced(r, 0, 4e4), .damping = Eigen::ArrayXd::LinSpaced(r, 0, 3)};
}

TEST(Allocation, IsNoticed) {
  const NoEigenMalloc forbidden;
  EXPECT_THROW(Eigen::VectorXd::Zero(r).eval(), std::logic_error);
}

TEST(Allocation, OfOperatorNewIsNoticed) {
  const long before = news;
  ::operator delete(::operator new(8));
  EXPECT_GT(news, before);
}

TEST(Allocation, NoneInAStepOfAnyIntegrator) {
  const Oscillators model = some_oscillators();
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(r), force = Eigen::VectorXd::Ones(r);
  for (const auto& integrator :
       {exact(), implicit_euler(), newmark(), generalized_alpha(), bdf2(), central_difference(), avf()}) {
    State state = make_state(model, integrator, rest, rest, force);
    Workspace workspace = make_workspace(model, integrator, 1e-3);
    const long before = news;
    {
      const NoEigenMalloc forbidden;
      for (int i = 0; i < 5; ++i) step(model, state, {force, force}, 1e-3, workspace);
      step(model, state, {force, force}, 5e-4, workspace);  // another length of step
    }
    EXPECT_EQ(news, before) << integrator.name;
    EXPECT_GT(state.z().norm(), 0);
  }
}

TEST(Allocation, NoneInReconstruction) {
  const model::Basis basis{model::RowMatrix::Random(3 * 50, r)};
  const Oscillators model = some_oscillators();
  const Eigen::VectorXd z = Eigen::VectorXd::Random(r);
  const State state = make_state(model, exact(), z, z, z);
  model::Points u(50, 3);
  const long before = news;
  {
    const NoEigenMalloc forbidden;
    reconstruct(basis, state.z(), u);
  }
  EXPECT_EQ(news, before);
  EXPECT_GT(u.norm(), 0);
}

}  // namespace
}  // namespace ritz::runtime
