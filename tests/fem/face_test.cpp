// Faces: orientation by the divergence theorem, areas and consistent loads.
#include "ritz/fem/face.hpp"

#include "fem/sample_cells.hpp"
#include "ritz/fem/geometry.hpp"

namespace ritz::fem::testing {
namespace {

struct CellFaces : ::testing::TestWithParam<CellType> {
  CellType type = GetParam();
};
INSTANTIATE_TEST_SUITE_P(, CellFaces, every_cell(), cell_name);

/// Calls f(type, coordinates) for each face of a cell.
template <class Callable>
void for_each_face(CellType type, const CellVectors& x, const Callable& f) {
  for (const auto& side : shape(type).faces) {
    const auto v = side.vertices();
    FaceVectors y(3, static_cast<int>(v.size()));
    for (int a = 0; a < y.cols(); ++a) y.col(a) = x.col(v[static_cast<std::size_t>(a)]);
    f(side.type, y);
  }
}

TEST_P(CellFaces, CloseAndPointOutwards) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const auto x = curved_cell(type, seed);
    Vector<3> sum = Vector<3>::Zero();
    double flux = 0;  // ∮ x·n dA = 3 V
    for_each_face(type, x, [&](FaceType face, const FaceVectors& y) {
      const Eigen::MatrixXd p = pressure_vectors(face, y);
      sum += p.rowwise().sum();
      flux += p.cwiseProduct(Eigen::MatrixXd(y)).sum();
    });
    EXPECT_LT(sum.norm(), 1e-13);
    EXPECT_NEAR(flux, 3 * volume(type, x), 1e-12 * std::abs(flux));
  }
}

TEST_P(CellFaces, EachSingleFacePointsAwayFromTheCentre) {
  const auto x = reference_cell(type);
  const Vector<3> centre = Eigen::MatrixXd(x).rowwise().mean();
  for_each_face(type, x, [&](FaceType face, const FaceVectors& y) {
    const Vector<3> n = Eigen::MatrixXd(pressure_vectors(face, y)).rowwise().sum(),
                    middle = Eigen::MatrixXd(y).rowwise().mean();
    EXPECT_GT(n.dot(middle - centre), 0);
  });
}

TEST_P(CellFaces, PlaneFacesCarryTractionAndPressureAlike) {
  const Matrix<3, 3> A = 2 * Matrix<3, 3>::Identity() + random_matrix<3, 3>(5);
  for_each_face(type, mapped(A, reference_cell(type)), [&](FaceType face, const FaceVectors& y) {
    const Eigen::MatrixXd p = pressure_vectors(face, y), w = traction_weights(face, y);
    const Vector<3> normal = p.rowwise().sum().normalized();
    EXPECT_LT((p - normal * w.transpose()).norm(), 1e-14 * area(face, y));
  });
}

FaceVectors quadratic(const Eigen::MatrixXd& corners) {
  FaceVectors x(3, 2 * corners.cols());
  for (int a = 0; a < corners.cols(); ++a) {
    x.col(a) = corners.col(a);
    x.col(corners.cols() + a) = (corners.col(a) + corners.col((a + 1) % corners.cols())) / 2;
  }
  return x;
}

TEST(Face, KnownAreasAndShares) {
  Eigen::MatrixXd triangle(3, 3), square(3, 4), shares(6, 1), of_eight(8, 1);
  triangle << 0, 3, 0, 0, 0, 4, 7, 7, 7;
  square << 0, 2, 2, 0, 0, 0, 3, 3, 1, 1, 1, 1;
  EXPECT_NEAR(area(FaceType::tri3, triangle), 6, 1e-14);
  const auto weights = [](FaceType type, const FaceVectors& x) { return Eigen::MatrixXd(traction_weights(type, x)); };
  EXPECT_LT((weights(FaceType::tri3, triangle) - Eigen::MatrixXd::Constant(3, 1, 2)).norm(), 1e-14);
  shares << 0, 0, 0, 2, 2, 2;
  EXPECT_LT((weights(FaceType::tri6, quadratic(triangle)) - shares).norm(), 1e-14);
  EXPECT_LT((weights(FaceType::quad4, square) - Eigen::MatrixXd::Constant(4, 1, 1.5)).norm(), 1e-14);
  of_eight << -.5, -.5, -.5, -.5, 2, 2, 2, 2;  // of an area of 6: -1/12 a corner, 1/3 an edge
  EXPECT_LT((weights(FaceType::quad8, quadratic(square)) - of_eight).norm(), 1e-14);
  const Eigen::MatrixXd p = pressure_vectors(FaceType::quad4, square);
  EXPECT_LT((p.row(2).transpose() - Eigen::VectorXd::Constant(4, 1.5)).norm(), 1e-14);
}

// A plane triangle one edge of which is the parabola with sagitta s over length 1: area 1/2 + 2 s/3.
TEST(Face, AreaUnderAParabolicEdge) {
  const double s = .1;
  FaceVectors x(3, 6);
  x << 0, 1, 0, .5, .5, 0, 0, 0, 1, -s, .5, .5, 0, 0, 0, 0, 0, 0;
  EXPECT_NEAR(area(FaceType::tri6, x), .5 + 2 * s / 3, 1e-15);
}

Eigen::MatrixXd fine_traction_weights(FaceType type, const Eigen::MatrixXd& x) {
  const auto line = legendre<24>();
  const auto& face = element(type);
  const bool square = shape(type).corners == 4;
  Eigen::VectorXd w = Eigen::VectorXd::Zero(face.vertices), N(face.vertices);
  Eigen::MatrixXd g(face.vertices, 2);
  for (const auto& [b, wb] : line)
    for (const auto& [a, wa] : line) {
      const Point<2> xi = square ? Point<2>{2 * a[0] - 1, 2 * b[0] - 1} : Point<2>{a[0] * (1 - b[0]), b[0]};
      face.shape(xi, N.data());
      face.gradient(xi, g.data());
      const Matrix<3, 2> J = x * g;
      w += wa * wb * (square ? 4 : 1 - b[0]) * J.col(0).cross(J.col(1)).norm() * N;
    }
  return w;
}

TEST_P(CellFaces, WarpedFacesCarryTractionsToAFewParts) {
  for_each_face(type, curved_cell(type, 3), [&](FaceType face, const FaceVectors& y) {
    const Eigen::MatrixXd w = traction_weights(face, y);
    EXPECT_LT((w - fine_traction_weights(face, y)).norm(), 1e-4 * area(face, y));
  });
}

TEST_P(CellFaces, LoseNothingFarFromTheOrigin) {
  for_each_face(type, rounded(curved_cell(type, 4)), [&](FaceType face, const FaceVectors& y) {
    const auto far = far_away(y);
    EXPECT_EQ(Eigen::MatrixXd(pressure_vectors(face, y)), Eigen::MatrixXd(pressure_vectors(face, far)));
    EXPECT_EQ(Eigen::MatrixXd(traction_weights(face, y)), Eigen::MatrixXd(traction_weights(face, far)));
  });
}

}  // namespace
}  // namespace ritz::fem::testing
