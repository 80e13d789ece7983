// Units, densities and the origin do not matter: dimensionless results stay.
#include <gtest/gtest.h>

#include <limits>

#include "support/lattice_mesh.hpp"
#include "support/problem.hpp"

namespace ritz::test {
namespace {

constexpr int count = 8;

/// ω L √(ρ/E) of a clamped or a free beam.
Eigen::VectorXd dimensionless(const Problem& p, const fem::Material& material, double length) {
  return flexible(modes(p, count).modes).head(count).cwiseSqrt() * length *
         std::sqrt(material.density / material.at_rest().young());
}

class Scaling : public testing::TestWithParam<bool> {
 protected:
  std::vector<mesh::Fixed> supports = GetParam() ? std::vector<mesh::Fixed>{} : std::vector{fixed("xmin")};

  /// The beam whose length is `length` in numbers, in a unit system.
  Eigen::VectorXd beam(const std::string& units, double length, const fem::Material& material) {
    mesh::Source source;
    source.mesh = mesh::Box{{length, .1 * length, .06 * length}, {6, 1, 1}, fem::CellType::tet10};
    source.units = mesh::parse_units(units);
    const auto of_file =
        source.units.to_si({.young = material.at_rest().young(), .poisson = {}, .density = material.density});
    const fem::Material si = test::stvk(*of_file.young, material.at_rest().poisson(), *of_file.density);
    return dimensionless(problem(mesh::read(MPI_COMM_WORLD, source), supports, {si}), si, length * source.units.length);
  }

  static void expect_equal(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double gate) {
    EXPECT_LE((a - b).cwiseQuotient(b).cwiseAbs().maxCoeff(), gate);
  }
};

TEST_P(Scaling, UnitSystemsAgree) {
  const Eigen::VectorXd si = beam("m-kg-s", 1, test::stvk(1e6, .3, 1000));
  expect_equal(beam("mm-t-s", 1000, test::stvk(1, .3, 1e-9)), si, 1e-9);
  expect_equal(beam("um-kg-s", 1e6, test::stvk(1, .3, 1e-15)), si, 1e-9);
}

TEST_P(Scaling, SizesAgree) {
  const Eigen::VectorXd metre = beam("m-kg-s", 1, test::stvk(1e6, .3, 1000));
  expect_equal(beam("um-kg-s", 1, test::stvk(1, .3, 1e-15)), metre, 1e-9);
  expect_equal(beam("m-kg-s", 1e3, test::stvk(2e11, .3, 7800)), metre, 1e-9);
}

TEST_P(Scaling, DensitiesAgree) {
  const Eigen::VectorXd plain = beam("m-kg-s", 1, test::stvk(1e6, .3, 1000));
  for (const double density : {1e-12, 1e-6, 1., 1e6, 1e12}) {
    SCOPED_TRACE(density);
    expect_equal(beam("m-kg-s", 1, test::stvk(1e6, .3, density)), plain, 1e-9);
  }
}

TEST_P(Scaling, StiffnessesAgree) {
  const Eigen::VectorXd plain = beam("m-kg-s", 1, test::stvk(1e6, .3, 1000));
  for (const double young : {1e-6, 1., 1e12}) {
    SCOPED_TRACE(young);
    expect_equal(beam("m-kg-s", 1, test::stvk(young, .3, 1000)), plain, 1e-9);
  }
}

TEST_P(Scaling, FarCoordinatesLoseOnlyTheirOwnDigits) {
  constexpr double offset = 1e6;
  const auto at = [&](double shift) {
    const auto place = [&](const Eigen::Vector3d& x) -> Eigen::Vector3d {
      return stretched({5, 1, 1}, {1, .2, .2})(x) + Eigen::Vector3d::Constant(shift);
    };
    auto mesh = lattice_mesh(grid(5, 1, 1), fem::CellType::tet4, place);
    mesh.sets.push_back({"xmin", {}, {}});
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if (mesh.points[v][0] < shift + .05) mesh.sets[0].vertices.push_back(static_cast<mesh::Index>(v));
    return dimensionless(problem(distributed(mesh), supports), soft, 1);
  };
  const double ulp = std::nextafter(offset, 2 * offset) - offset, shortest_edge = .2 * std::sqrt(2) / 2;
  expect_equal(at(offset), at(0), 20 * ulp / shortest_edge);
}

INSTANTIATE_TEST_SUITE_P(, Scaling, testing::Bool(), [](const auto& info) { return info.param ? "free" : "clamped"; });

}  // namespace
}  // namespace ritz::test
