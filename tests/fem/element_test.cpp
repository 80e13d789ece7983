// Shape functions: what they reproduce, their gradients, and the agreement with the tables of fem/cell.hpp.
#include <set>

#include "fem/sample_cells.hpp"

namespace ritz::fem::testing {
namespace {

struct Elements : ::testing::TestWithParam<CellType> {
  CellType type = GetParam();
};
INSTANTIATE_TEST_SUITE_P(, Elements, every_cell(), cell_name);

Point<3> inside(std::uint64_t k) {
  return {.25 + .2 * uniform(k, 0), .25 + .2 * uniform(k, 1), .25 + .2 * uniform(k, 2)};
}

/// A polynomial of the element's own space.
double own_polynomial(CellType type, const Point<3>& p) {
  const auto [x, y, z] = p;
  const double linear = .3 - x + 2 * y + .7 * z;
  const double quadratic = linear + x * x - 3 * y * z + x * z + .5 * z * z + x * y;
  switch (type) {
    case CellType::tet10: return quadratic;
    case CellType::hex8: return linear + x * y - 2 * y * z + x * z + 4 * x * y * z;
    case CellType::hex20: return quadratic + 2 * x * x * y - y * y * z + x * y * z * (1 + 2 * x - y);
    case CellType::wedge6: return linear + x * z - 2 * y * z;
    case CellType::wedge15: return quadratic + x * x * z - 3 * x * y * z + y * z * z;
    default: return linear;
  }
}

TEST_P(Elements, CountsAgreeWithTheCellShape) {
  EXPECT_EQ(element(type).vertices, shape(type).vertices);
  EXPECT_EQ(std::ssize(element(type).reference), shape(type).vertices);
  EXPECT_LE(shape(type).vertices, max_cell_vertices);
  const auto linear = shape(shape(type).linear);
  EXPECT_EQ(linear.vertices, shape(type).corners);
  const auto middles = shape(type).quadratic() ? std::ssize(shape(type).edges) : 0;
  EXPECT_EQ(middles + shape(type).corners, shape(type).vertices);
  // Euler's formula: corners - edges + faces = 2
  EXPECT_EQ(shape(type).corners - std::ssize(shape(type).edges) + std::ssize(shape(type).faces), 2);
}

TEST_P(Elements, EveryEdgeBelongsToTwoFacesOnce) {
  std::multiset<Edge> around;
  for (const auto& side : shape(type).faces) {
    const auto corners = side.corners();
    for (std::size_t i = 0; i < corners.size(); ++i) around.insert({corners[i], corners[(i + 1) % corners.size()]});
  }
  EXPECT_EQ(around.size(), 2 * shape(type).edges.size());
  for (const auto& [a, b] : shape(type).edges) {  // once in each direction, for all faces are seen from outside
    EXPECT_EQ(around.count({a, b}), 1u);
    EXPECT_EQ(around.count({b, a}), 1u);
  }
}

TEST_P(Elements, MidEdgeVerticesLieOnTheirEdgesAndInTheFaces) {
  const auto cell = shape(type);
  if (!cell.quadratic()) return;
  const CellVectors x = reference_cell(type);
  for (int e = 0; e < std::ssize(cell.edges); ++e) {
    const auto [i, j] = cell.edges[static_cast<std::size_t>(e)];
    EXPECT_EQ(x.col(cell.corners + e), Vector<3>((x.col(i) + x.col(j)) / 2));
  }
  for (const auto& side : cell.faces) {
    const auto v = side.vertices();
    const auto corners = side.corners();
    for (std::size_t i = 0; i < corners.size(); ++i)
      EXPECT_EQ(x.col(v[corners.size() + i]),
                Vector<3>((x.col(corners[i]) + x.col(corners[(i + 1) % corners.size()])) / 2));
  }
}

TEST_P(Elements, ShapeFunctionIsOneAtItsVertexAndZeroAtTheOthers) {
  for (int a = 0; a < shape(type).vertices; ++a) {
    const auto N = shape_functions(type, element(type).reference[static_cast<std::size_t>(a)]);
    for (int b = 0; b < N.size(); ++b) EXPECT_EQ(N[b], a == b ? 1 : 0);
  }
}

TEST_P(Elements, ReproduceTheirPolynomialsAndSumToOne) {
  for (std::uint64_t k = 0; k < 10; ++k) {
    const auto xi = inside(k);
    const auto N = shape_functions(type, xi);
    double value = 0;
    for (int a = 0; a < N.size(); ++a)
      value += N[a] * own_polynomial(type, element(type).reference[static_cast<std::size_t>(a)]);
    EXPECT_NEAR(N.sum(), 1, 1e-15);
    EXPECT_NEAR(value, own_polynomial(type, xi), 1e-14);
  }
}

// Central differences on two scales, extrapolated: exact for polynomials of degree 4.
TEST_P(Elements, GradientIsTheDifferenceQuotientAndSumsToZero) {
  const double error = type == CellType::pyramid5 ? 1e-6 : 1e-13;  // rational
  for (std::uint64_t k = 0; k < 10; ++k) {
    const auto xi = inside(k);
    const auto g = reference_gradients(type, xi);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto slope = [&](double h) -> Eigen::VectorXd {
        auto ahead = xi, behind = xi;
        ahead[i] += h;
        behind[i] -= h;
        return (shape_functions(type, ahead) - shape_functions(type, behind)) / (2 * h);
      };
      const auto column = static_cast<Eigen::Index>(i);
      EXPECT_LT((g.col(column) - (4 * slope(.0078125) - slope(.015625)) / 3).norm(), error);
      EXPECT_NEAR(g.col(column).sum(), 0, 1e-14);
    }
  }
}

TEST_P(Elements, PhysicalGradientsDifferentiateAffineFieldsOfTheCell) {
  const auto x = curved_cell(type, 5);
  const Matrix<3, 3> A = random_matrix<3, 3>(77);
  const IntegrationPoints points(type, x);
  ASSERT_EQ(points.count(), element(type).rule.count());
  for (int q = 0; q < points.count(); ++q) {
    EXPECT_LT((A * Eigen::MatrixXd(x) * Eigen::MatrixXd(points.gradients(q)) - A).norm(), 1e-13);
    EXPECT_GT(points.weight(q), 0);
  }
}

// Cells of different types fit together: on a face only its own vertices count, by the functions of the face.
TEST_P(Elements, OnAFaceTheyAreTheFunctionsOfTheFace) {
  for (const auto& side : shape(type).faces) {
    const auto v = side.vertices();
    const auto& face = element(side.type);
    for (std::uint64_t k = 0; k < 5; ++k) {
      const Point<2> at = {.3 + .25 * uniform(k, 8), .3 + .25 * uniform(k, 9)};
      Eigen::VectorXd M(face.vertices);
      face.shape(at, M.data());
      Point<3> xi = {};
      for (std::size_t a = 0; a < v.size(); ++a)
        for (std::size_t i = 0; i < 3; ++i)
          xi[i] += M[static_cast<Eigen::Index>(a)] * element(type).reference[static_cast<std::size_t>(v[a])][i];
      Eigen::VectorXd expected = Eigen::VectorXd::Zero(shape(type).vertices);
      for (std::size_t a = 0; a < v.size(); ++a) expected[v[a]] = M[static_cast<Eigen::Index>(a)];
      EXPECT_LT((shape_functions(type, xi) - expected).norm(), 1e-14);
    }
  }
}

TEST(CellOfVtk, IsTheTypeOfThatNumber) {
  for (const auto type : cell_types) EXPECT_EQ(cell_of_vtk(shape(type).vtk), type);
  for (const auto type : face_types) EXPECT_EQ(face_of_vtk(shape(type).vtk), type);
  EXPECT_EQ(cell_of_vtk(shape(FaceType::tri3).vtk), std::nullopt);
  EXPECT_EQ(face_of_vtk(shape(CellType::tet4).vtk), std::nullopt);
}

}  // namespace
}  // namespace ritz::fem::testing
