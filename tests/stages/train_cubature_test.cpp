// Cubature: its forces against those of all cells, what it chooses, and what it refuses.
#include "ritz/stages/train_cubature.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "ritz/base/error.hpp"
#include "ritz/fem/response.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/runtime/polynomial_force.hpp"
#include "ritz/stages/cell_forces.hpp"
#include "ritz/stages/cubature_candidates.hpp"
#include "ritz/stages/internal_force.hpp"
#include "ritz/stages/reduce_polynomial.hpp"
#include "ritz/stages/training_poses.hpp"
#include "support/reduction.hpp"

namespace ritz::test {
namespace {

using algebra::Tall;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using model::Integrand;
using stages::CubatureOptions;

/// A clamped box with a basis of modal derivatives.
struct Body {
  Problem p;
  Tall u;
  VectorXd stiffness;
  model::Polynomial polynomial;

  model::Cubature train(const CubatureOptions& options) const {
    return stages::train_cubature(p, u, stiffness, polynomial, options, [](const std::string&, double) {});
  }
};

model::Polynomial at_rest(const Problem& p, const Tall& u) {
  stages::PolynomialLaws laws;
  for (const auto& material : p.materials) laws.push_back(material.at_rest());
  return stages::reduce_polynomial(p, laws, u);
}

enum class Stiff { none, stvk, neo_hookean };

/// Of neo-Hookean material; its half x > ½ stiffer, where there is one.
Body body(const std::string& mesh, Stiff stiff = Stiff::none) {
  auto r = reduced(box_of("box:1,.4,.3/" + mesh, false, stiff != Stiff::none), 4);
  const auto basis = basis_of(r, {.modes = {}, .derivatives = 4, .cut = {.size = 7, .tolerance = 1e-12}});
  Tall u = mesh::to_vertices(r.p.mesh, r.p.dofs, basis.U);
  const auto given = r.p.materials;
  r.p.materials = neo_hookean(given);
  if (stiff == Stiff::stvk) r.p.materials[1] = given[1];
  auto polynomial = at_rest(r.p, u);
  return {std::move(r.p), std::move(u), basis.reduction.stiffness, std::move(polynomial)};
}

/// The force by definition (model::Cubature).
VectorXd force_of(const model::Cubature& c, const fem::Materials& materials, const model::Polynomial& polynomial,
                  const VectorXd& z) {
  const auto exact = runtime::make_polynomial_force<double>(polynomial);
  auto at = runtime::make_evaluation(exact);
  runtime::evaluate<double>(exact, z, at);
  const bool beyond = c.integrand == Integrand::beyond_polynomial;
  VectorXd force = beyond ? VectorXd(at.force) : VectorXd::Zero(z.size());
  for (std::size_t cell = 0; cell < c.cells.size(); ++cell) {
    const auto& material = materials[static_cast<std::size_t>(c.regions[cell])];
    const auto rest = material.at_rest();
    const fem::Material plain = stvk(rest.young(), rest.poisson(), 1);
    for (auto p = c.starts[cell]; p < c.starts[cell + 1]; ++p) {
      const auto rows = c.gradients.middleRows(9 * p, 9);
      const VectorXd gradient = rows * z;
      const fem::Matrix<3, 3> G = Eigen::Map<const fem::Matrix<3, 3>>(gradient.data());
      fem::Response law, less;
      fem::respond(material, std::span(&G, 1), std::span(&law, 1));
      fem::respond(plain, std::span(&G, 1), std::span(&less, 1));
      const fem::Matrix<3, 3> stress = beyond ? fem::Matrix<3, 3>(law.stress - less.stress) : law.stress;
      force += c.weights[static_cast<Index>(cell)] * c.volumes[p] * rows.transpose() * stress.reshaped();
    }
  }
  return force;
}

VectorXd full_force(const Body& b, const VectorXd& z) {
  const Tall displaced = b.u * z;
  return algebra::inner(b.p.mesh.comm, b.u, stages::internal_forces(b.p.mesh, b.p.materials, displaced).forces);
}

/// Poses that no training has seen.
stages::Poses other_poses(const Body& b, int count) {
  const auto basis = stages::cell_basis(b.p, b.u);
  return stages::training_poses({basis, b.u, b.stiffness, b.polynomial, .5},
                                {{stages::PoseKind::lift, count, 99}, {stages::PoseKind::statics, count, 98}});
}

/// √ of the mean of the squares of the errors in the energy norm.
double error_of(const model::Cubature& c, const Body& b, const stages::Poses& poses) {
  double sum = 0;
  for (Index s = 0; s < poses.z.cols(); ++s) {
    const VectorXd full = full_force(b, poses.z.col(s)), roots = b.stiffness.cwiseSqrt().cwiseInverse();
    const VectorXd difference = force_of(c, b.p.materials, b.polynomial, poses.z.col(s)) - full;
    sum += roots.cwiseProduct(difference).squaredNorm() / roots.cwiseProduct(full).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(poses.z.cols()));
}

void expect_sound(const model::Cubature& c, const Body& b) {
  const auto T = static_cast<Index>(c.cells.size());
  ASSERT_EQ(c.weights.size(), T);
  ASSERT_EQ(static_cast<Index>(c.regions.size()), T);
  ASSERT_EQ(static_cast<Index>(c.starts.size()), T + 1);
  EXPECT_EQ(c.starts.back(), c.volumes.size());
  EXPECT_EQ(c.gradients.rows(), 9 * c.volumes.size());
  EXPECT_EQ(c.gradients.cols(), b.u.cols());
  EXPECT_GT(c.weights.minCoeff(), 0);
  EXPECT_GT(c.volumes.minCoeff(), 0);
  EXPECT_TRUE(std::ranges::is_sorted(c.cells, std::ranges::less_equal{}) || T < 2);
  EXPECT_EQ(std::set(c.cells.begin(), c.cells.end()).size(), c.cells.size());
  EXPECT_GT(c.largest_energy, 0);
  ASSERT_FALSE(c.errors.empty());
  EXPECT_EQ(c.errors.back().cells, T);
  for (const auto& error : c.errors)
    for (const auto& part : {error.training, error.lifts, error.statics})
      EXPECT_GE(part.largest, part.root_mean_square);
}

class Cubature : public testing::TestWithParam<const char*> {
 protected:
  const Body b = body(GetParam());
};

TEST_P(Cubature, IsAsGoodAsItSaysAtPosesThatItHasNotSeen) {
  const auto poses = other_poses(b, 6);
  for (const auto integrand : {Integrand::energy, Integrand::beyond_polynomial}) {
    const auto c = b.train({.cells = {}, .tolerance = 1e-2, .integrand = integrand, .poses = 80});
    expect_sound(c, b);
    const auto& last = c.errors.back();
    EXPECT_LE(std::max(last.lifts.root_mean_square, last.statics.root_mean_square), 1e-2);
    EXPECT_LE(error_of(c, b, poses), 2e-2);
  }
}

TEST_P(Cubature, IsTheWholeSumWithAllCells) {
  const auto poses = other_poses(b, 3);
  const auto basis = stages::cell_basis(b.p, b.u);
  const auto cells = stages::cubature_candidates(b.p, Integrand::energy);
  MatrixXd sum = MatrixXd::Zero(b.u.cols(), poses.z.cols());
  stages::each_cell_force(basis, Integrand::energy, cells, poses.z,
                          [&](Index, const Eigen::Ref<const MatrixXd>& force) { sum += force; });
  parallel::sum_in_place(b.p.mesh.comm, sum);
  for (Index s = 0; s < poses.z.cols(); ++s) {
    const VectorXd full = full_force(b, poses.z.col(s));
    EXPECT_LE((sum.col(s) - full).norm(), 1e-12 * full.norm());
    EXPECT_LE((poses.exact.forces.col(s) - full).norm(), 1e-12 * full.norm());
    const Tall displaced = b.u * poses.z.col(s);
    EXPECT_NEAR(poses.exact.energies[s] / stages::internal_forces(b.p.mesh, b.p.materials, displaced).energies[0], 1,
                1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(, Cubature, testing::Values("8,4,3/tet4", "3,2,1/tet10", "6,4,3/hex8"), [](const auto& info) {
  const std::string text = info.param;
  return text.substr(text.rfind('/') + 1);
});

TEST(CubatureTraining, HasSmallerErrorsWithMoreCells) {
  const auto b = body("8,4,3/tet4");
  const auto errors = b.train({.cells = 60, .poses = 60}).errors;
  ASSERT_GE(errors.size(), 8u);
  EXPECT_EQ(errors.back().cells, 60);
  const auto& first = errors.front();
  const auto& last = errors.back();
  EXPECT_LT(last.training.root_mean_square, .1 * first.training.root_mean_square);
  EXPECT_LT(last.lifts.root_mean_square, .3 * first.lifts.root_mean_square);
  EXPECT_LT(last.statics.root_mean_square, .3 * first.statics.root_mean_square);
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_LT(errors[i].training.root_mean_square, errors[i - 1].training.root_mean_square);
}

TEST(CubatureTraining, IsBetterBeyondThePolynomialThanOfTheWholeEnergy) {
  const auto b = body("8,4,3/tet4");
  const auto beyond = b.train({.cells = 14, .integrand = Integrand::beyond_polynomial, .amplitude = .2}),
             whole = b.train({.cells = 14, .integrand = Integrand::energy, .amplitude = .2});
  const auto poses = other_poses(b, 8);
  EXPECT_LT(error_of(beyond, b, poses), .7 * error_of(whole, b, poses));
  EXPECT_LT(beyond.errors.back().statics.root_mean_square, .7 * whole.errors.back().statics.root_mean_square);
}

TEST(CubatureTraining, OfStVenantKirchhoffMaterialIsItsPolynomial) {
  auto b = body("8,4,3/tet4");
  b.p.materials = {soft};
  const auto c = b.train({.cells = {}, .tolerance = 1e-3, .integrand = Integrand::energy});
  EXPECT_LT(c.cells.size(), 576u);
  const auto exact = runtime::make_polynomial_force<double>(b.polynomial);
  auto at = runtime::make_evaluation(exact);
  const auto poses = other_poses(b, 4);
  for (Index s = 0; s < poses.z.cols(); ++s) {
    runtime::evaluate<double>(exact, poses.z.col(s), at);
    EXPECT_LE((force_of(c, b.p.materials, b.polynomial, poses.z.col(s)) - at.force).norm(), 1e-2 * at.force.norm());
  }
}

TEST(CubatureTraining, ChoosesOnlyCellsWhoseLawIsNoPolynomial) {
  const auto mixed = body("8,4,3/tet4", Stiff::stvk);
  const auto c = mixed.train({.cells = 20, .integrand = Integrand::beyond_polynomial, .poses = 40});
  expect_sound(c, mixed);
  for (const auto region : c.regions) EXPECT_EQ(region, 0);
  const auto whole = mixed.train({.cells = 20, .integrand = Integrand::energy, .poses = 40});
  EXPECT_NE(std::ranges::count(whole.regions, 1), 0);
  const auto both = body("8,4,3/tet4", Stiff::neo_hookean);
  EXPECT_LE(error_of(both.train({.cells = 80}), both, other_poses(both, 4)), 2e-2);
}

TEST(CubatureTraining, AdmitsNoPoseThatSqueezesACell) {
  const auto b = body("6,3,2/tet4");
  const auto basis = stages::cell_basis(b.p, b.u);
  const auto poses = stages::training_poses({basis, b.u, b.stiffness, b.polynomial, 5},
                                            {{stages::PoseKind::lift, 12, 1}, {stages::PoseKind::statics, 12, 2}});
  EXPECT_GE(poses.exact.squeezed.minCoeff(), .2);
  EXPECT_TRUE(poses.exact.forces.allFinite());
  EXPECT_GT(poses.exact.energies.minCoeff(), 0);
  const auto c = b.train({.cells = 20, .poses = 30, .amplitude = 5});
  expect_sound(c, b);
}

TEST(CubatureTraining, PosesAreLiftsAndEquilibria) {
  const auto b = body("6,3,2/tet4");
  const auto basis = stages::cell_basis(b.p, b.u);
  const auto draw = [&](stages::PoseKind kind, double amplitude) {
    return stages::training_poses({basis, b.u, b.stiffness, b.polynomial, amplitude}, {{kind, 3, 5}}).z;
  };
  // Both are p + O(p²), with the same corrections of second order: halving p divides their difference by eight.
  const auto difference = [&](double amplitude) {
    return (draw(stages::PoseKind::lift, amplitude) - draw(stages::PoseKind::statics, amplitude)).norm();
  };
  EXPECT_NEAR(difference(2e-3) / difference(1e-3), 8, .2);
  const Tall displaced = b.u * draw(stages::PoseKind::lift, 1e-4);
  double largest = 0;
  for (Index v = 0; v < displaced.rows() / 3; ++v)
    largest = std::max(largest, displaced.col(2).segment<3>(3 * v).norm());
  EXPECT_NEAR(parallel::max(b.p.mesh.comm, largest), 1e-4, 1e-6);
}

/// A basis that does not depend on how modes were computed: polynomials in the coordinates that are zero at x = 0.
Tall polynomials(const mesh::Mesh& mesh) {
  Tall u = Tall::Zero(3 * mesh.owned, 5);
  for (int v = 0; v < mesh.owned; ++v) {
    const auto [x, y, z] = std::array{mesh.points(0, v), mesh.points(1, v), mesh.points(2, v)};
    u.middleRows<3>(3 * v) << x, 0, x * x, 0, x * z,  //
        x * y, x, 0, x * x, 0,                        //
        0, x * z, x * y, x, x * x;
  }
  return u;
}

/// The same on all ranks together as on each alone.
TEST(CubatureTraining, IsTheSameOnAnyNumberOfRanks) {
  const auto train = [](MPI_Comm comm) {
    mesh::Source source;
    source.mesh = mesh::parse_box("box:1,.4,.3/6,4,3/tet4");
    Problem p = problem(mesh::read(comm, source), {fixed("xmin")});
    Tall u = polynomials(p.mesh);
    const Tall free = mesh::from_vertices(p.mesh, p.dofs, u);
    const MatrixXd K = algebra::inner(comm, free, algebra::multiply(p.matrices.stiffness, free));
    // Orthogonal with respect to K, with stiffnesses 1, 2, ...
    u *= MatrixXd(K.llt().matrixU()).inverse();
    const VectorXd stiffness = VectorXd::LinSpaced(5, 1, 5);
    u *= stiffness.cwiseSqrt().asDiagonal();
    p.materials = neo_hookean(p.materials);
    auto polynomial = at_rest(p, u);
    const Body b = {std::move(p), std::move(u), stiffness, std::move(polynomial)};
    return b.train({.cells = 24, .poses = 30, .amplitude = .3});
  };
  const auto together = train(MPI_COMM_WORLD), alone = train(MPI_COMM_SELF);
  ASSERT_EQ(together.cells, alone.cells);
  EXPECT_LE((together.weights - alone.weights).lpNorm<Eigen::Infinity>(), 1e-9 * alone.weights.maxCoeff());
  EXPECT_EQ(together.starts, alone.starts);
  EXPECT_LE((together.gradients - alone.gradients).lpNorm<Eigen::Infinity>(), 1e-9 * alone.gradients.maxCoeff());
  ASSERT_EQ(together.errors.size(), alone.errors.size());
  for (std::size_t i = 0; i < alone.errors.size(); ++i)
    EXPECT_NEAR(together.errors[i].statics.largest, alone.errors[i].statics.largest, 1e-9);
}

TEST(CubatureTraining, RefusesWhatItCannotDo) {
  const auto b = body("6,3,2/tet4");
  EXPECT_THROW(b.train({.cells = 1000}), InputError);
  EXPECT_THROW(b.train({.cells = {}, .tolerance = 1e-16, .poses = 10}), NumericalError);
  EXPECT_THROW(b.train({.cells = 100, .poses = 2}), NumericalError);  // no more columns than rows: 14
  auto of_polynomials = body("6,3,2/tet4");
  of_polynomials.p.materials = {soft};
  EXPECT_THROW(of_polynomials.train({.cells = 10}), InputError);
  auto rigid = body("6,3,2/tet4");
  rigid.stiffness[0] = 0;
  EXPECT_THROW(rigid.train({.cells = 10}), InputError);
}

/// The positions in the file and the volumes of cells, by ascending position.
using Volumes = std::map<std::int64_t, double>;

/// Of a box whose cells grow with x, as many candidates.
Volumes candidates(MPI_Comm comm, std::int64_t most) {
  mesh::Source source;
  source.mesh = mesh::parse_box("box:1,.4,.3/12,4,4/tet4");
  mesh::Mesh graded = mesh::read(comm, source);
  graded.points.row(0) = graded.points.row(0).array().pow(3).matrix().eval();
  const Problem p = problem(std::move(graded), {fixed("xmin")});
  std::vector<std::int64_t> numbers;
  std::vector<double> volumes;
  for (const int c : stages::cubature_candidates(p, Integrand::energy, most)) {
    const auto x = p.mesh.corners(c);
    numbers.push_back(p.mesh.cells.numbers[static_cast<std::size_t>(c)]);
    volumes.push_back(std::abs((x.col(1) - x.col(0)).cross(x.col(2) - x.col(0)).dot(x.col(3) - x.col(0))) / 6);
  }
  numbers = parallel::gather_all(comm, numbers);
  volumes = parallel::gather_all(comm, volumes);
  Volumes found;
  for (std::size_t i = 0; i < numbers.size(); ++i) found[numbers[i]] = volumes[i];
  EXPECT_EQ(found.size(), numbers.size());
  return found;
}

double mean(const Volumes& cells) {
  double sum = 0;
  for (const auto& [number, volume] : cells) sum += volume;
  return sum / static_cast<double>(cells.size());
}

TEST(CubatureCandidates, AreASampleOfEverySizeThatNoRankChanges) {
  const Volumes all = candidates(MPI_COMM_WORLD, 2000), some = candidates(MPI_COMM_WORLD, 300);
  EXPECT_EQ(all.size(), 1152u);
  EXPECT_EQ(some.size(), 300u);
  EXPECT_EQ(some, candidates(MPI_COMM_SELF, 300));
  std::set<int> octaves, sampled;
  for (const auto& [number, volume] : all) octaves.insert(std::ilogb(volume));
  for (const auto& [number, volume] : some) sampled.insert(std::ilogb(volume));
  EXPECT_GE(octaves.size(), 6u);
  EXPECT_EQ(sampled, octaves);
  // Half of the shares go by volume: with v for the mean of the cells, it is between v and that weighted by volume.
  double squares = 0;
  for (const auto& [number, volume] : all) squares += volume * volume;
  const double weighted = squares / (mean(all) * 1152);
  EXPECT_GT(mean(some), mean(all) + .2 * (weighted - mean(all)));
  EXPECT_LT(mean(some), mean(all) + .8 * (weighted - mean(all)));
}

}  // namespace
}  // namespace ritz::test
