#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>

#include "format/expect_same.hpp"
#include "format/temporary.hpp"
#include "ritz/base/error.hpp"
#include "ritz/format/parts.hpp"
#include "ritz/format/reader.hpp"
#include "support/nonlinear_sample_model.hpp"

namespace ritz::format {
namespace {

using test::expect_same;
using test::Folder;
using test::sample_model;

TEST(RoundTrip, KeepsEveryPart) {
  const Folder folder;
  const auto path = folder / "model.h5";
  write(path, sample_model());
  expect_same(read(path), sample_model());
}

TEST(RoundTrip, KeepsAReductionAndItsPolynomial) {
  const Folder folder;
  const auto path = folder / "model.h5";
  write(path, test::nonlinear_sample_model());
  expect_same(read(path), test::nonlinear_sample_model());
  auto model = test::nonlinear_sample_model();
  model.bodies[0].polynomial.reset();
  write(path, model);
  expect_same(read(path), model);
  model.bodies[0].reduction->residual_vectors = 1;
  write(path, model);
  expect_same(read(path), model);
  model.bodies[0].reduction->residual_vectors = 3;  // of two columns
  write(path, model);
  EXPECT_THROW(read(path), InputError);
}

TEST(RoundTrip, KeepsACubatureInAFileOfVersionTwo) {
  const Folder folder;
  const auto path = folder / "model.h5";
  write(path, test::cubature_sample_model());
  expect_same(read(path), test::cubature_sample_model());
  EXPECT_EQ(ModelReader(path).version().major, 2);
  auto model = test::cubature_sample_model();
  model.bodies[0].polynomial.reset();
  model.bodies[0].cubature->integrand = model::Integrand::energy;
  model.bodies[0].cubature->errors.clear();
  write(path, model);
  expect_same(read(path), model);
  write(path, test::nonlinear_sample_model());
  EXPECT_EQ(ModelReader(path).version().major, 1);
}

// HDF5's own memory is suppressed where leaks are looked for: what this layer opens is counted here.
TEST(RoundTrip, LeavesNothingOfHdf5Open) {
  const auto open = [] { return H5Fget_obj_count(static_cast<hid_t>(H5F_OBJ_ALL), H5F_OBJ_ALL); };
  const auto before = open();
  const Folder folder;
  write(folder / "model.h5", test::nonlinear_sample_model());
  read(folder / "model.h5");
  { const ModelWriter abandoned(folder / "model.h5"); }
  EXPECT_EQ(open(), before);
}

TEST(RoundTrip, KeepsAbsentPartsAbsent) {
  const Folder folder;
  const auto path = folder / "model.h5";
  auto model = sample_model();
  model.bodies[0].modes.reset();
  model.bodies[0].inertia.reset();
  model.bodies[0].loads.clear();
  model.bodies[0].geometry.sets.clear();
  model.bodies[0].geometry.materials.clear();
  model.provenance.options.clear();
  model.bodies[0].report = {};
  write(path, model);

  const ModelReader in(path);
  expect_same(read(in), model);
  EXPECT_TRUE(in.has(schema::geometry));
  EXPECT_TRUE(in.has(schema::basis));
  EXPECT_FALSE(in.has(schema::modes));
  EXPECT_FALSE(in.has(schema::inertia));
  EXPECT_FALSE(in.has(schema::loads));
}

TEST(RoundTrip, KeepsTheSurfaceOfALargerMesh) {
  const Folder folder;
  auto model = sample_model();
  model.bodies[0].geometry.rows = model::Rows::surface;
  model.bodies[0].geometry.full_vertices = 1'000'000'000'000;
  model.bodies[0].geometry.cells = {{5, 9}, {0, 3, 7}, {0, 1, 2, 0, 1, 2, 3}};
  write(folder / "model.h5", model);
  expect_same(read(folder / "model.h5"), model);
}

TEST(RoundTrip, KeepsOddNumbersAndNames) {
  const Folder folder;
  auto model = sample_model();
  model.bodies[0].name = "upper arm";
  model.bodies[0].modes->residuals << std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max();
  model.bodies[0].geometry.sets.clear();
  for (const auto* name : {"z last first", "", ".", "..", "%2F", "a/b/c", "%", "größe", "new\nline"})
    model.bodies[0].geometry.sets.push_back({name, {0}, 1});
  write(folder / "model.h5", model);
  expect_same(read(folder / "model.h5"), model);
  EXPECT_EQ(ModelReader(folder / "model.h5").bodies(), std::vector<std::string>{"upper arm"});
}

TEST(RoundTrip, KeepsEveryKindOfCertificate) {
  const Folder folder;
  for (const auto kind : {model::Certified::no, model::Certified::probabilistic, model::Certified::inertia_f32}) {
    auto model = sample_model();
    model.bodies[0].modes->certificate.kind = kind;
    model.bodies[0].modes->kinds[0] = model::ModeKind::rigid;
    model.bodies[0].modes->eigenvalues[0] = 0;
    write(folder / "model.h5", model);
    expect_same(read(folder / "model.h5"), model);
  }
}

TEST(RoundTrip, ReadsFromMemory) {
  const Folder folder;
  write(folder / "model.h5", sample_model());
  auto image = test::load(folder / "model.h5");
  const ModelReader in(image, "a blob");
  std::ranges::fill(image, std::byte{0});  // the reader keeps its own copy
  expect_same(read(in), sample_model());
}

TEST(RoundTrip, GivesTheSameBytesEachTime) {
  const Folder folder;
  write(folder / "one.h5", sample_model());
  write(folder / "two.h5", sample_model());
  EXPECT_EQ(test::load(folder / "one.h5"), test::load(folder / "two.h5"));
}

TEST(Contents, ListsEachDatasetOnceWithItsUnits) {
  const Folder folder;
  write(folder / "model.h5", sample_model());
  const ModelReader in(folder / "model.h5");
  std::map<std::string, DatasetInfo> found;
  for (const auto& info : contents(in)) {
    EXPECT_TRUE(found.emplace(info.path, info).second);
    EXPECT_FALSE(info.units.empty()) << info.path;
    EXPECT_NO_THROW(verify(in, info));
  }
  EXPECT_EQ(found.at("/bodies/body/geometry/points").units, "m");
  EXPECT_EQ(found.at("/bodies/body/geometry/points").bytes, 4u * 3 * 8);
  EXPECT_EQ(found.at("/bodies/body/basis/columns/0002").shape, (std::vector<std::int64_t>{4, 3}));
  EXPECT_EQ(found.at("/bodies/body/basis/U").shape, (std::vector<std::int64_t>{12, 2}));
  EXPECT_TRUE(found.at("/bodies/body/basis/U").is_virtual);
  EXPECT_EQ(found.count("/VTKHDF/Points"), 0u);
}

}  // namespace
}  // namespace ritz::format
