// MacNeal and Harder's twisted beam: a static check of K by a unit load on the tip.
#include <gtest/gtest.h>

#include <numbers>

#include "support/problem.hpp"
#include "support/statics.hpp"

namespace ritz::test {
namespace {

constexpr double beam_length = 12, width = 1.1, depth = .32;  // the benchmark's own units, taken as SI
constexpr fem::Material material = test::stvk(29e6, .22, 1);

/// The straight box with its section centred on the axis, then turned by 90 degrees along its length.
mesh::Mesh twisted_beam(const std::string& cells) {
  mesh::Mesh mesh = box("box:12,1.1,.32/12,2,1/" + cells);
  for (int v = 0; v < mesh.local_vertices(); ++v) {
    auto x = mesh.points.col(v);
    const double angle = std::numbers::pi / 2 * x.x() / beam_length, y = x.y() - width / 2, z = x.z() - depth / 2;
    x.tail<2>() << std::cos(angle) * y - std::sin(angle) * z, std::sin(angle) * y + std::cos(angle) * z;
  }
  return mesh;
}

class TwistedBeam : public testing::TestWithParam<const char*> {};

TEST_P(TwistedBeam, BendsAsMacNealAndHarderSay) {
  const Problem p = problem(twisted_beam(GetParam()), {fixed("xmin")}, {material});
  // At the tip the section's width lies along z: the load in its plane bends about the thin side.
  const std::array<double, 3> deflection = {0, .001754, .005424};
  for (const int c : {1, 2}) {
    const Eigen::VectorXd force = end_traction(p, "xmax", Eigen::Vector3d::Unit(c));
    EXPECT_NEAR(work(p, force, solve(p, force)) / deflection[static_cast<std::size_t>(c)], 1, .02) << "component " << c;
  }
}

INSTANTIATE_TEST_SUITE_P(, TwistedBeam, testing::Values("tet10", "hex20", "wedge15"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace ritz::test
