// Shape functions: what they reproduce, their gradients, and the agreement with the tables of fem/cell.hpp.
#include "fem/sample_cells.hpp"

namespace ritz::fem::testing {
namespace {

template <class E>
struct Element : ::testing::Test {};
TYPED_TEST_SUITE(Element, Elements);

Point<3> inside(std::uint64_t k) {
  return {.25 + .2 * uniform(k, 0), .25 + .2 * uniform(k, 1), .25 + .2 * uniform(k, 2)};
}

/// A polynomial of the element's own space.
template <class E>
double own_polynomial(const Point<3>& p) {
  const auto [x, y, z] = p;
  const double linear = .3 - x + 2 * y + .7 * z;
  if constexpr (E::type == CellType::tet10) return linear + x * x - 3 * y * z + x * z + .5 * z * z;
  if constexpr (E::type == CellType::hex8) return linear + x * y - 2 * y * z + x * z + 4 * x * y * z;
  return linear;
}

TYPED_TEST(Element, CountsAgreeWithTheCellShape) {
  EXPECT_EQ(TypeParam::vertices, shape(TypeParam::type).vertices);
  EXPECT_EQ(TypeParam::reference.size(), static_cast<std::size_t>(TypeParam::vertices));
}

TYPED_TEST(Element, ShapeFunctionIsOneAtItsVertexAndZeroAtTheOthers) {
  for (int a = 0; a < TypeParam::vertices; ++a) {
    const auto N = TypeParam::shape(TypeParam::reference[a]);
    for (int b = 0; b < TypeParam::vertices; ++b) EXPECT_EQ(N[b], a == b ? 1 : 0);
  }
}

TYPED_TEST(Element, ReproducesItsPolynomialsAndSumsToOne) {
  for (std::uint64_t k = 0; k < 10; ++k) {
    const auto xi = inside(k);
    const auto N = TypeParam::shape(xi);
    double value = 0;
    for (int a = 0; a < TypeParam::vertices; ++a) value += N[a] * own_polynomial<TypeParam>(TypeParam::reference[a]);
    EXPECT_NEAR(N.sum(), 1, 1e-15);
    EXPECT_NEAR(value, own_polynomial<TypeParam>(xi), 1e-14);
  }
}

TYPED_TEST(Element, GradientIsTheDifferenceQuotientAndSumsToZero) {
  const double h = .125;  // central differences are exact for polynomials of degree 2
  for (std::uint64_t k = 0; k < 10; ++k) {
    const auto xi = inside(k);
    const auto g = TypeParam::gradient(xi);
    for (int i = 0; i < 3; ++i) {
      auto ahead = xi, behind = xi;
      ahead[i] += h;
      behind[i] -= h;
      EXPECT_LT((g.col(i) - (TypeParam::shape(ahead) - TypeParam::shape(behind)) / (2 * h)).norm(), 1e-14);
      EXPECT_NEAR(g.col(i).sum(), 0, 1e-15);
    }
  }
}

TYPED_TEST(Element, PhysicalGradientsDifferentiateAffineFieldsOfTheCell) {
  const auto x = curved_cell<TypeParam>(5);
  const Matrix<3, 3> A = random_matrix<3, 3>(77);
  for (const auto& sample : TypeParam::rule) {
    const auto [gradients, weight] = physical_gradients<TypeParam>(relative<TypeParam>(x), sample);
    EXPECT_LT((A * x * gradients - A).norm(), 1e-13);
    EXPECT_GT(weight, 0);
  }
}

TEST(Dispatch, CallsTheElementOfTheType) {
  for (const auto type : {CellType::tet4, CellType::tet10, CellType::hex8})
    EXPECT_EQ(visit(type, []<class E>(E) { return E::type; }), type);
}

}  // namespace
}  // namespace ritz::fem::testing
