// Faces: orientation by the divergence theorem, areas and consistent loads.
#include "ritz/fem/face.hpp"

#include "fem/sample_cells.hpp"
#include "ritz/fem/geometry.hpp"

namespace ritz::fem::testing {
namespace {

template <class E>
struct CellFaces : ::testing::Test {};
TYPED_TEST_SUITE(CellFaces, Elements);

/// Calls `f` with the coordinates of each face, in the order of face_vertices.
template <class E, class Callable>
void for_each_face(const Coordinates<E>& x, const Callable& f) {
  constexpr auto type = shape(E::type).face;
  using F = std::conditional_t<type == FaceType::tri3, Tri3, std::conditional_t<type == FaceType::tri6, Tri6, Quad4>>;
  for (int face = 0; face < shape(E::type).faces; ++face) {
    const auto v = face_vertices(E::type, face);
    ASSERT_EQ(v.size(), static_cast<std::size_t>(F::vertices));
    Coordinates<F> y;
    for (int a = 0; a < F::vertices; ++a) y.col(a) = x.col(v[a]);
    f(F{}, y);
  }
}

TYPED_TEST(CellFaces, CloseAndPointOutwards) {
  using E = TypeParam;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const auto x = curved_cell<E>(seed);
    Vector<3> sum = Vector<3>::Zero();
    double flux = 0;  // ∮ x·n dA = 3 V
    for_each_face<E>(x, [&]<class F>(F, const Coordinates<F>& y) {
      const auto p = any_size(pressure_vectors<F>(y));
      sum += p.rowwise().sum();
      flux += p.cwiseProduct(any_size(y)).sum();
    });
    EXPECT_LT(sum.norm(), 1e-13);
    EXPECT_NEAR(flux, 3 * volume<E>(x), 1e-12);
  }
}

TYPED_TEST(CellFaces, EachSingleFacePointsAwayFromTheCentre) {
  using E = TypeParam;
  const auto x = reference_cell<E>();
  const Vector<3> centre = any_size(x).rowwise().mean();
  for_each_face<E>(x, [&]<class F>(F, const Coordinates<F>& y) {
    const Vector<3> n = any_size(pressure_vectors<F>(y)).rowwise().sum(), middle = any_size(y).rowwise().mean();
    EXPECT_GT(n.dot(middle - centre), 0);
  });
}

TYPED_TEST(CellFaces, PlaneFacesCarryTractionAndPressureAlike) {
  using E = TypeParam;
  const Matrix<3, 3> A = 2 * Matrix<3, 3>::Identity() + random_matrix<3, 3>(5);
  const auto x = mapped<E>(A, reference_cell<E>());
  for_each_face<E>(x, [&]<class F>(F, const Coordinates<F>& y) {
    const auto p = any_size(pressure_vectors<F>(y)), w = any_size(traction_weights<F>(y));
    const Vector<3> normal = p.rowwise().sum().normalized();
    EXPECT_LT((p - normal * w.transpose()).norm(), 1e-14 * area<F>(y));
  });
}

TEST(Face, KnownAreasAndShares) {
  Coordinates<Tri3> tri3;
  tri3 << 0, 3, 0, 0, 0, 4, 7, 7, 7;
  EXPECT_NEAR(area<Tri3>(tri3), 6, 1e-14);
  EXPECT_LT((traction_weights<Tri3>(tri3) - Vector<3>::Constant(2)).norm(), 1e-14);

  Coordinates<Tri6> tri6;
  tri6.leftCols<3>() = tri3;
  for (int a = 0; a < 3; ++a) tri6.col(3 + a) = (tri3.col(a) + tri3.col((a + 1) % 3)) / 2;
  Vector<6> shares;
  shares << 0, 0, 0, 2, 2, 2;
  EXPECT_LT((traction_weights<Tri6>(tri6) - shares).norm(), 1e-14);

  Coordinates<Quad4> quad4;
  quad4 << 0, 2, 2, 0, 0, 0, 3, 3, 1, 1, 1, 1;
  EXPECT_LT((traction_weights<Quad4>(quad4) - Vector<4>::Constant(1.5)).norm(), 1e-14);
  EXPECT_LT((pressure_vectors<Quad4>(quad4).row(2).transpose() - Vector<4>::Constant(1.5)).norm(), 1e-14);
}

// A plane triangle one edge of which is the parabola with sagitta s over length 1: area 1/2 + 2 s/3.
TEST(Face, AreaUnderAParabolicEdge) {
  const double s = .1;
  Coordinates<Tri6> x;
  x << 0, 1, 0, .5, .5, 0, 0, 0, 1, -s, .5, .5, 0, 0, 0, 0, 0, 0;
  EXPECT_NEAR(area<Tri6>(x), .5 + 2 * s / 3, 1e-15);
}

template <class F>
Eigen::VectorXd fine_traction_weights(const Eigen::MatrixXd& x) {
  const auto line = legendre<24>();
  Eigen::VectorXd w = Eigen::VectorXd::Zero(F::vertices);
  for (const auto& [b, wb] : line)
    for (const auto& [a, wa] : line) {
      const bool square = F::type == FaceType::quad4;
      const Point<2> xi = square ? Point<2>{2 * a[0] - 1, 2 * b[0] - 1} : Point<2>{a[0] * (1 - b[0]), b[0]};
      const Matrix<3, 2> J = x * any_size(F::gradient(xi));
      w += wa * wb * (square ? 4 : 1 - b[0]) * J.col(0).cross(J.col(1)).norm() * any_size(F::shape(xi));
    }
  return w;
}

TYPED_TEST(CellFaces, WarpedFacesCarryTractionsToAFewParts) {
  using E = TypeParam;
  for_each_face<E>(curved_cell<E>(3), [&]<class F>(F, const Coordinates<F>& y) {
    EXPECT_LT((any_size(traction_weights<F>(y)) - fine_traction_weights<F>(any_size(y))).norm(), 2e-5 * area<F>(y));
  });
}

TYPED_TEST(CellFaces, LoseNothingFarFromTheOrigin) {
  using E = TypeParam;
  for_each_face<E>(rounded<E>(curved_cell<E>(4)), [&]<class F>(F, const Coordinates<F>& y) {
    const auto far = far_away<F>(y);
    EXPECT_EQ(any_size(pressure_vectors<F>(y)), any_size(pressure_vectors<F>(far)));
    EXPECT_EQ(any_size(traction_weights<F>(y)), any_size(traction_weights<F>(far)));
  });
}

TEST(Dispatch, CallsTheFaceOfTheType) {
  for (const auto type : {FaceType::tri3, FaceType::tri6, FaceType::quad4}) {
    EXPECT_EQ(visit(type, []<class F>(F) { return F::type; }), type);
    EXPECT_EQ(visit(type, []<class F>(F) { return F::vertices; }), shape(type).vertices);
  }
}

}  // namespace
}  // namespace ritz::fem::testing
