// The estimated error of each mode by the mesh: against closed forms, and against quadratic cells on the same lattice.
#include "ritz/stages/mesh_error.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "support/lattice_mesh.hpp"
#include "support/listed_mesh.hpp"
#include "support/problem.hpp"

namespace ritz::test {
namespace {

struct HeldBox {
  const char* size;
  std::vector<mesh::Fixed> supports;
};

const HeldBox held_beam = {"1,.2,.15", {fixed("xmin")}},
              stretched_bar = {"1,.1,.1",
                               {fixed("xmin"), fixed("ymin", {false, true, false}),
                                fixed("zmin", {false, false, true})}},
              slid_beam = {"1,.2,.15", {fixed("xmin", {true, false, false}), fixed("ymin", {false, true, false})}},
              loose_block = {"1,.6,.5", {}};

Problem meshed(const HeldBox& body, const std::string& cells, const fem::Material& material = soft) {
  return problem(box(std::string("box:") + body.size + "/" + cells), body.supports, {material});
}

/// f₁ of the cantilever in the limit of finer meshes, Hz; see docs/elements.md.
constexpr double first_of_cantilever = .7595;

/// By a factorization, and by multigrid, which must say the same. *Collective*.
Eigen::VectorXd errors_of(const Problem& p, const stages::ModesResult& found) {
  const auto by = [&](stages::Strategy strategy) {
    return stages::mesh_errors(p, found, [=](const mesh::Dofs&) { return strategy; });
  };
  const Eigen::VectorXd errors = by(stages::Strategy::direct);
  EXPECT_LT((by(stages::Strategy::iterative) - errors).cwiseAbs().maxCoeff(), 1e-4 * (1 + errors.maxCoeff()));
  return errors;
}

TEST(MeshError, OfABeamThatBendsIsWithinAFactorOfTwo) {
  for (const std::string cells :
       {"6,2,2/tet4", "12,4,3/tet4", "6,2,2/hex8", "12,4,3/hex8", "12,4,3/wedge6", "6,2,2/tet10", "12,4,3/tet10"}) {
    const Problem p = meshed(held_beam, cells);
    const auto found = modes(p, 2);
    const double error = frequencies(found.modes)[0] / first_of_cantilever - 1;
    const double estimate = errors_of(p, found)[0];
    EXPECT_GT(estimate, .5 * error) << cells << " is off by " << error;
    EXPECT_LT(estimate, 2 * error) << cells << " is off by " << error;
  }
}

TEST(MeshError, OfABarThatStretchesIsThatOfItsClosedFormAndVanishesWithTheCells) {
  const double exact = std::sqrt(1e6 / 1000) / 4;  // √(E/ρ) / 4L
  for (const int n : {2, 4, 40}) {
    const Problem p = meshed(stretched_bar, std::to_string(n) + ",1,1/hex8", test::stvk(1e6, 0, 1000));
    const auto found = modes(p, 1);
    const double error = frequencies(found.modes)[0] / exact - 1, estimate = errors_of(p, found)[0];
    EXPECT_NEAR(error * n * n, std::numbers::pi * std::numbers::pi / 96, .02) << "the test's own closed form";
    EXPECT_NEAR(estimate / error, 1, .1) << n << " cells";
  }
}

/// The quadratic cells' own frequencies are a lower bound of what one step towards them reaches, and close to it. The
/// last of `count` modes are not compared: they come in another order, and some are not among these.
void expect_those_of_quadratic_cells(const Problem& linear, const Problem& quadratic, int count, int compared) {
  const auto found = modes(linear, count);
  const int rigid = rigid_count(found.modes);
  const Eigen::VectorXd errors = errors_of(linear, found);
  ASSERT_EQ(errors.size(), found.modes.eigenvalues.size());
  EXPECT_EQ(errors.head(rigid), Eigen::VectorXd::Zero(rigid));
  Eigen::VectorXd estimated = frequencies(found.modes).array() / (1 + errors.tail(errors.size() - rigid).array());
  std::sort(estimated.begin(), estimated.end());
  const Eigen::VectorXd expected = frequencies(modes(quadratic, count).modes);
  for (Eigen::Index i = 0; i < compared; ++i) {
    EXPECT_GT(estimated[i] / expected[i], 1 - 1e-9) << "mode " << i + 1;
    EXPECT_LT(estimated[i] / expected[i], 1.03) << "mode " << i + 1;
  }
}

TEST(MeshError, OfLinearCellsIsWhatQuadraticOnesFind) {
  for (const HeldBox& body : {held_beam, slid_beam, loose_block})
    for (const auto& [linear, quadratic] :
         {std::pair{"5,2,2/tet4", "5,2,2/tet10"}, {"5,2,2/hex8", "5,2,2/hex20"}, {"5,2,2/wedge6", "5,2,2/wedge15"}})
      expect_those_of_quadratic_cells(meshed(body, linear), meshed(body, quadratic), 8, 6);
}

TEST(MeshError, OfManyModesIsEstimatedInGroups) {
  expect_those_of_quadratic_cells(meshed(held_beam, "6,3,3/hex8"), meshed(held_beam, "6,3,3/hex20"), 30, 20);
}

TEST(MeshError, KnowsSeveralMaterials) {
  const fem::Materials materials = {test::stvk(1e6, .3, 1000), test::stvk(1e7, .3, 2000)};
  const auto halves = [&](const std::string& type) {
    mesh::Mesh mesh = box("box:1,.2,.15/6,2,2/" + type);
    mesh.regions.push_back({"stiff", {}});
    for (int c = 0; c < mesh.cells.count(); ++c)
      mesh.cells.regions[static_cast<std::size_t>(c)] = mesh.corners(c).row(0).mean() > .5;
    return problem(std::move(mesh), held_beam.supports, materials);
  };
  expect_those_of_quadratic_cells(halves("hex8"), halves("hex20"), 6, 4);
}

TEST(MeshError, OfQuadraticTetrahedraSeesNoErrorWhereStiffnessJumps) {
  mesh::Mesh halves = box("box:1,.1,.1/10,1,1/tet10");
  halves.regions.push_back({"stiff", {}});
  for (int c = 0; c < halves.cells.count(); ++c)
    halves.cells.regions[static_cast<std::size_t>(c)] = halves.corners(c).row(0).mean() > .5;
  const Problem p =
      problem(std::move(halves), stretched_bar.supports, {test::stvk(1e6, 0, 1000), test::stvk(1e8, 0, 1000)});
  EXPECT_LT(errors_of(p, modes(p, 1))[0], 1e-3);
}

TEST(MeshError, SaysOfWhichMeshesItKnowsNothing) {
  for (const std::string type : {"tet4", "tet10", "hex8", "wedge6"})
    EXPECT_EQ(stages::mesh_error_obstacle(box("box:1,1,1/2,2,2/" + type)), "") << type;
  EXPECT_EQ(stages::mesh_error_obstacle(distributed(cube_with_cap(Diagonal::from_4_to_6))), "");
  EXPECT_NE(stages::mesh_error_obstacle(box("box:1,1,1/2,2,2/hex20")).find("this one has hex20"), std::string::npos);
  const auto pyramids = lattice_mesh(grid(2, 2, 2), fem::CellType::pyramid5, stretched({2, 2, 2}, {1, 1, 1}));
  EXPECT_NE(stages::mesh_error_obstacle(distributed(pyramids)).find("pyramid5"), std::string::npos);
}

}  // namespace
}  // namespace ritz::test
