// The Gram matrix of a random cloud of point masses against the sums that define each quantity.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "ritz/base/random.hpp"
#include "ritz/model/model.hpp"
#include "support/sample_model.hpp"

namespace ritz::model {
namespace {

struct Cloud {
  Eigen::VectorXd mass;
  Points points;
  RowMatrix U;  // 3n x r
  Eigen::Vector3d origin{3, -2, 1};

  Inertia inertia() const {
    const auto n = points.rows(), r = U.cols();
    Eigen::MatrixXd B(n, 4 + 3 * r);
    for (Eigen::Index i = 0; i < n; ++i) {
      B(i, 0) = 1;
      B.block(i, 1, 1, 3) = points.row(i) - origin.transpose();
      for (Eigen::Index a = 0; a < 3; ++a) B.block(i, 4 + a * r, 1, r) = U.row(3 * i + a);
    }
    return {origin, B.transpose() * mass.asDiagonal() * B};
  }
};

Cloud random_cloud() {
  Cloud c{Eigen::VectorXd(20), Points(20, 3), RowMatrix(60, 4)};
  for (Eigen::Index i = 0; i < 20; ++i) c.mass(i) = 2 + uniform(1, static_cast<std::uint64_t>(i));
  for (Eigen::Index i = 0; i < 60; ++i) c.points(i / 3, i % 3) = 3 + uniform(2, static_cast<std::uint64_t>(i));
  for (Eigen::Index i = 0; i < 240; ++i) c.U(i / 4, i % 4) = uniform(3, static_cast<std::uint64_t>(i));
  return c;
}

TEST(Inertia, GivesMassAndCentre) {
  const auto c = random_cloud();
  const auto inertia = c.inertia();
  EXPECT_NEAR(inertia.mass(), c.mass.sum(), 1e-13 * c.mass.sum());
  const Eigen::Vector3d centre = (c.mass.transpose() * c.points).transpose() / c.mass.sum();
  EXPECT_LT((inertia.centre_of_mass() - centre).norm(), 1e-13);
}

TEST(Inertia, GivesTheTensorAboutTheCentre) {
  const auto c = random_cloud();
  const Eigen::Vector3d centre = (c.mass.transpose() * c.points).transpose() / c.mass.sum();
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < 20; ++i) {
    const Eigen::Vector3d x = c.points.row(i).transpose() - centre;
    tensor += c.mass(i) * (x.squaredNorm() * Eigen::Matrix3d::Identity() - x * x.transpose());
  }
  EXPECT_LT((c.inertia().tensor() - tensor).norm(), 1e-11);
}

TEST(Inertia, GivesParticipationFactorsWithoutRounding) {
  auto c = random_cloud();
  c.U.col(0).setOnes();
  const Eigen::MatrixXd factors = c.inertia().participation_factors(), exact = c.inertia().rigid_coupling();
  for (Eigen::Index d = 0; d < 3; ++d) EXPECT_NEAR(factors(0, d) / c.mass.sum(), 1, 1e-13);
  EXPECT_EQ(factors.row(0).tail<3>(), Eigen::RowVector3d::Zero());
  EXPECT_EQ(factors.bottomRows(3), exact.bottomRows(3));
}

TEST(Inertia, GivesTheCouplingWithRigidMotions) {
  const auto c = random_cloud();
  const auto inertia = c.inertia();
  const Eigen::Vector3d centre = inertia.centre_of_mass();
  Eigen::MatrixXd MR(60, 6);
  for (Eigen::Index i = 0; i < 20; ++i)
    for (int d = 0; d < 3; ++d) {
      const Eigen::Vector3d axis = Eigen::Vector3d::Unit(d), x = c.points.row(i).transpose() - centre;
      MR.block<3, 1>(3 * i, d) = c.mass(i) * axis;
      MR.block<3, 1>(3 * i, 3 + d) = c.mass(i) * axis.cross(x);
    }
  const Eigen::MatrixXd coupling = c.U.transpose() * MR;
  EXPECT_LT((inertia.rigid_coupling() - coupling).norm(), 1e-11);
  EXPECT_LT((inertia.effective_masses() - coupling.leftCols(3).cwiseAbs2()).norm(), 1e-10);
}

TEST(Inertia, OfTwoMassesIsThatOfTheTextbook) {
  const auto inertia = test::sample_inertia();
  EXPECT_DOUBLE_EQ(inertia.mass(), 4);
  EXPECT_EQ(inertia.centre_of_mass(), Eigen::Vector3d(0.5, 0, 0));
  EXPECT_LT((inertia.tensor() - Eigen::Vector3d(0, 1, 1).asDiagonal().toDenseMatrix()).norm(), 1e-15);
  EXPECT_LT((inertia.effective_masses().colwise().sum() - Eigen::RowVector3d(0, 0, 4)).norm(), 1e-15);
}

TEST(Inertia, WithoutABasisStillHasMass) {
  const Inertia inertia{Eigen::Vector3d::Zero(), Eigen::Vector4d(2, 1, 1, 1).asDiagonal().toDenseMatrix()};
  EXPECT_EQ(inertia.mass(), 2);
  EXPECT_EQ(inertia.rigid_coupling().rows(), 0);
}

}  // namespace
}  // namespace ritz::model
