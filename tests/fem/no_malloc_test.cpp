// Element integrals allocate nothing: Eigen's own assertion, in whatever build type.
#undef NDEBUG
#define EIGEN_RUNTIME_NO_MALLOC
#include "fem/sample_cells.hpp"
#include "ritz/fem/face.hpp"
#include "ritz/fem/geometry.hpp"
#include "ritz/fem/mass.hpp"
#include "ritz/fem/stiffness.hpp"

namespace ritz::fem::testing {
namespace {

struct NoMalloc {
  NoMalloc() { Eigen::internal::set_is_malloc_allowed(false); }
  ~NoMalloc() { Eigen::internal::set_is_malloc_allowed(true); }
};

template <class E>
double everything() {
  const auto x = curved_cell<E>(1);
  const NoMalloc guard;
  return stiffness<E>(x, {1, .3, 1}).trace() + mass<E>(x, 1).trace() + volume<E>(x) + smallest_jacobian<E>(x) +
         shortest_edge<E>(x);
}

template <class F>
double loads() {
  const auto x = random_matrix<3, F::vertices>(2);
  const NoMalloc guard;
  return pressure_vectors<F>(x).sum() + traction_weights<F>(x).sum();
}

TEST(NoMalloc, TheGuardBites) {
  EXPECT_DEATH(
      {
        const NoMalloc guard;
        Eigen::VectorXd grown(1000);
      },
      "heap allocation is forbidden");
}

TEST(NoMalloc, ElementsDoNotAllocate) {
  EXPECT_TRUE(std::isfinite(everything<Tet4>() + everything<Tet10>() + everything<Hex8>()));
  EXPECT_TRUE(std::isfinite(smallest_dihedral<Tet4>(curved_cell<Tet4>(1))));
}

TEST(NoMalloc, FacesDoNotAllocate) { EXPECT_TRUE(std::isfinite(loads<Tri3>() + loads<Tri6>() + loads<Quad4>())); }

}  // namespace
}  // namespace ritz::fem::testing
