// A model whose checksums are right and whose numbers cannot be: refused by whoever reads the part.
#include "ritz/format/sound.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "format/changed.hpp"
#include "ritz/base/error.hpp"
#include "support/nonlinear_sample_model.hpp"

namespace ritz::format {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();

class Sound : public testing::Test {
 protected:
  /// Both what --check does and reading everything refuse the model, and name `path`.
  void wrong(const char* path, const char* sentence, const std::function<void(model::Body&)>& change) const {
    wrong_of(test::nonlinear_sample_model(), path, sentence, change);
  }
  void wrong_of(model::Model model, const char* path, const char* sentence,
                const std::function<void(model::Body&)>& change) const {
    change(model.bodies[0]);
    write(folder_ / "model.h5", model);
    const auto refused = ThrowsMessage<InputError>(AllOf(HasSubstr(path), HasSubstr(sentence)));
    EXPECT_THAT([&] { check(ModelReader(folder_ / "model.h5")); }, refused) << path << ' ' << sentence;
    EXPECT_THAT([&] { read(folder_ / "model.h5"); }, refused) << path << ' ' << sentence;
  }

  test::Folder folder_;
};

TEST_F(Sound, IsTheSample) {
  for (const auto& model : {test::sample_model(), test::nonlinear_sample_model()}) {
    write(folder_ / "model.h5", model);
    const auto body = check(ModelReader(folder_ / "model.h5")).at(0);
    EXPECT_EQ(body.modes->eigenvalues, model.bodies[0].modes->eigenvalues);
    EXPECT_EQ(body.basis.U.size(), 0);
    EXPECT_EQ(orthonormality_error(*body.inertia), orthonormality_error(*model.bodies[0].inertia));
  }
}

TEST_F(Sound, NumbersAreFinite) {
  wrong("geometry/points", "finite", [](auto& b) { b.geometry.points(1, 1) = nan; });
  wrong("columns/0001", "finite", [](auto& b) { b.basis.U(0, 0) = infinite; });
  wrong("columns/0002", "finite", [](auto& b) { b.basis.U(11, 1) = nan; });
  wrong("modes/eigenvalues", "finite", [](auto& b) { b.modes->eigenvalues[1] = infinite; });
  wrong("modes/residuals", "finite", [](auto& b) { b.modes->residuals[0] = nan; });
  wrong("certificate", "finite", [](auto& b) { b.modes->certificate.shift = nan; });
  wrong("modes", "finite", [](auto& b) { b.modes->orthonormality = nan; });
  wrong("reduction/stiffness", "finite", [](auto& b) { b.reduction->stiffness[0] = nan; });
  wrong("reduction", "finite", [](auto& b) { b.reduction->discarded = infinite; });
  wrong("polynomial/quartic", "finite", [](auto& b) { b.polynomial->quartic[3] = nan; });
  wrong("inertia/gram", "finite", [](auto& b) { b.inertia->gram(5, 5) = nan; });
  wrong("inertia/origin", "finite", [](auto& b) { b.inertia->origin[2] = infinite; });
  wrong("loads/tip/total", "finite", [](auto& b) { b.loads[0].total(0, 0) = nan; });
  wrong("pressure", "finite", [](auto& b) { b.loads[1].pressure[0] = infinite; });
  wrong("materials/young", "finite", [](auto& b) { b.geometry.materials[0].material.law = fem::StVK{nan, .3}; });
}

TEST_F(Sound, CellsHaveTheVerticesOfTheirTypes) {
  const auto cell = [](std::uint8_t type, std::vector<std::int64_t> vertices) {
    return [=](auto& b) { b.geometry.cells = {{type}, {0, static_cast<std::int64_t>(vertices.size())}, vertices}; };
  };
  wrong("cells/offsets", "of VTK type 24 1 vertices, not 10", cell(24, {3}));
  wrong("cells/offsets", "of VTK type 12 4 vertices, not 8", cell(12, {0, 1, 2, 3}));
  wrong("cells/offsets", "of VTK type 10 5 vertices, not 4", cell(10, {0, 1, 2, 3, 0}));
  wrong("cells/types", "unknown VTK type 42", cell(42, {0, 1, 2, 3}));
  wrong("cells/types", "unknown VTK type 0", cell(0, {}));
  wrong("cells/vertices", "not stored", cell(10, {0, 1, 2, 4}));
  wrong("cells/offsets", "ascend", [](auto& b) { b.geometry.cells = {{10, 10}, {0, 5, 4}, {0, 1, 2, 3}}; });
}

TEST_F(Sound, SetsAscendAndAreOfTheMesh) {
  wrong("sets/tip", "not stored", [](auto& b) { b.geometry.sets[0].rows = {-1}; });
  wrong("cells/rows", "ascend", [](auto& b) { b.geometry.sets[1].rows = {1, 0}; });
  wrong("cells/rows", "ascend", [](auto& b) { b.geometry.sets[1].rows = {1, 1}; });
  wrong("sets/tip", "more vertices than the set", [](auto& b) { b.geometry.sets[0].full_count = 0; });
  wrong("geometry", "more vertices than the mesh", [](auto& b) { b.geometry.full_vertices = 3; });
}

TEST_F(Sound, MaterialsCanBe) {
  for (const double young : {0.0, -1.0})
    wrong("materials", "'steel'", [=](auto& b) { b.geometry.materials[0].material.law = fem::StVK{young, .3}; });
  for (const double poisson : {0.5, -1.0, 7.0})
    wrong("materials", "'rubber'", [=](auto& b) {
      b.geometry.materials[1].material.law = fem::NeoHookean{1e6, poisson};
    });
  wrong("materials", "'steel'", [](auto& b) { b.geometry.materials[0].material.density = 0; });
}

TEST_F(Sound, ModesAreOnes) {
  wrong("modes", "do not ascend", [](auto& b) { b.modes->eigenvalues << 9, 4; });
  wrong("modes", "mode 1 is flexible with the eigenvalue -4", [](auto& b) { b.modes->eigenvalues[0] = -4; });
  wrong("modes", "mode 1 is rigid with the eigenvalue 4", [](auto& b) { b.modes->kinds[0] = model::ModeKind::rigid; });
  wrong("modes", "a residual is negative", [](auto& b) { b.modes->residuals[0] = -1; });
  wrong("modes", "neither 0 nor 1", [](auto& b) { b.modes->floor_applies[0] = 7; });
  wrong("certificate", "negative", [](auto& b) { b.modes->certificate.found = -1; });
}

TEST_F(Sound, TheReductionDescendsAndTheInertiaIsAMass) {
  wrong("reduction", "negative", [](auto& b) { b.reduction->stiffness << -4, 9; });
  wrong("reduction", "do not descend", [](auto& b) { b.reduction->singular_values << 1, 2, 3; });
  wrong("inertia", "mass is not", [](auto& b) { b.inertia->gram(0, 0) = 0; });
  wrong("inertia", "not symmetric", [](auto& b) { b.inertia->gram(0, 8) += 1; });
  wrong("loads/tip", "no vertices", [](auto& b) { b.loads[0].vertices = 0; });
  wrong("loads/end", "negative area", [](auto& b) { b.loads[1].area = -1; });
}

TEST_F(Sound, PartsAgreeInTheirShapes) {
  wrong("basis", "vertices of the geometry", [](auto& b) { b.basis.U = model::RowMatrix::Zero(600, 2); });
  wrong("basis", "vertices of the geometry", [](auto& b) { b.basis.U = model::RowMatrix::Zero(9, 2); });
  wrong("inertia", "columns of the basis", [](auto& b) { b.inertia->gram = Eigen::MatrixXd::Identity(7, 7); });
  wrong("loads", "columns of the basis", [](auto& b) { b.loads[0].total = Eigen::MatrixXd::Zero(3, 3); });
  wrong("polynomial", "columns of the basis", [](auto& b) {
    b.polynomial = model::Polynomial{1, Eigen::VectorXd::Zero(1), Eigen::VectorXd::Zero(1), Eigen::VectorXd::Zero(1)};
  });
}

TEST_F(Sound, ACubatureFitsItselfAndTheBody) {
  const auto wrong = [&](const char* sentence, const std::function<void(model::Cubature&)>& change) {
    wrong_of(test::cubature_sample_model(), "/cubature", sentence, [&](model::Body& b) { change(*b.cubature); });
  };
  wrong("no cells", [](auto& c) {
    c.cells = c.regions = {};
    c.starts = {0};
    c.weights.resize(0);
    c.volumes.resize(0);
    c.gradients.resize(0, 2);
  });
  wrong("do not ascend", [](auto& c) { c.cells = {7, 7}; });
  wrong("not positive", [](auto& c) { c.weights[1] = 0; });
  wrong("finite", [](auto& c) { c.weights[1] = nan; });
  wrong("finite", [](auto& c) { c.gradients(3, 1) = infinite; });
  wrong("follow each other", [](auto& c) { c.starts = {0, 0, 3}; });
  wrong("follow each other", [](auto& c) { c.starts = {1, 2, 3}; });
  wrong("negative", [](auto& c) { c.regions[0] = -1; });
  wrong("energy of the training", [](auto& c) { c.largest_energy = 0; });
  wrong("an error is negative", [](auto& c) { c.errors[0].lifts.largest = -1; });
  wrong("volumes", [](auto& c) { c.volumes.conservativeResize(2); });
  wrong("gradients", [](auto& c) { c.gradients.conservativeResize(18, 2); });
  wrong("columns of the basis", [](auto& c) { c.gradients.conservativeResize(27, 3); });
  wrong("one too many", [](auto& c) { c.integrand = model::Integrand::energy; });
  wrong_of(test::cubature_sample_model(), "/cubature", "polynomial is missing", [](auto& b) { b.polynomial.reset(); });
  auto model = test::cubature_sample_model();
  model.bodies[0].cubature->regions[1] = 2;
  write(folder_ / "model.h5", model);
  EXPECT_THAT([&] { check(ModelReader(folder_ / "model.h5")); },
              ThrowsMessage<InputError>(HasSubstr("region without a material")));
}

/// What reading part by part cannot know: of the whole model.
TEST_F(Sound, NothingIsMissingAndTheWitnessesHold) {
  const auto wrong_alone = [&](const char* sentence, const std::function<void(model::Body&)>& change) {
    auto model = test::nonlinear_sample_model();
    change(model.bodies[0]);
    write(folder_ / "model.h5", model);
    EXPECT_THAT([&] { check(ModelReader(folder_ / "model.h5")); }, ThrowsMessage<InputError>(HasSubstr(sentence)));
  };
  wrong_alone("no column", [](model::Body& b) {
    b.basis.U.resize(12, 0);
    b.reduction->stiffness.resize(0);
    b.polynomial.reset();
    b.inertia->gram = Eigen::MatrixXd(b.inertia->gram.topLeftCorner(4, 4));
    b.loads.clear();
  });
  wrong_alone("materials are missing", [](model::Body& b) { b.geometry.materials.clear(); });
  wrong_alone("modes are missing", [](model::Body& b) { b.modes.reset(), b.reduction.reset(); });
  wrong_alone("load on the set 'tip'", [](model::Body& b) { b.loads.erase(b.loads.begin()); });
  wrong_alone("K̃(0)", [](model::Body& b) { b.polynomial->quadratic[1] = 1e-7; });
  wrong_alone("UᵀMU", [](model::Body& b) { b.inertia->gram(8, 8) += 2e-12; });
  wrong_alone("3 eigenvalues lie below", [](model::Body& b) { b.modes->certificate.counted = 3; });
}

}  // namespace
}  // namespace ritz::format
