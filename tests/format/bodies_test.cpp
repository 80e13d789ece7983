// A file of several bodies: each has its own parts, checksums, report and view, and each is checked.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "format/changed.hpp"
#include "format/expect_same.hpp"
#include "ritz/base/error.hpp"
#include "ritz/format/reader.hpp"
#include "ritz/format/sound.hpp"
#include "support/nonlinear_sample_model.hpp"

namespace ritz::format {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

const std::string arm = "/bodies/arm%2Fupper";

test::Bytes two_bodies() {
  return test::changed(test::two_body_model(), [](hid_t) {});
}

TEST(Bodies, KeepTheirOrderAndAllTheirParts) {
  const ModelReader in(two_bodies());
  const auto model = test::two_body_model();
  EXPECT_THAT(in.bodies(), ElementsAre("body", "arm/upper"));
  EXPECT_EQ(in.first_body(), "body");
  test::expect_same(read(in), model);
  for (const auto& body : model.bodies) test::expect_same(read_body(in, body.name), body);
}

TEST(Bodies, HaveTheSameFileAloneAsTheFirstOfTwoHas) {
  const auto paths = [](const ModelReader& in) {
    std::vector<std::string> found;
    for (const auto& info : contents(in))
      if (!info.path.starts_with(arm)) found.push_back(info.path);
    return found;
  };
  EXPECT_EQ(paths(ModelReader(two_bodies())), paths(ModelReader(test::changed(test::sample_model(), [](hid_t) {}))));
}

TEST(Bodies, AreCheckedEachOfThem) {
  const auto bodies = check(ModelReader(two_bodies()));
  ASSERT_EQ(bodies.size(), 2U);
  EXPECT_EQ(bodies[1].name, "arm/upper");
  EXPECT_EQ(bodies[1].reduction->stiffness, Eigen::Vector2d(4, 9));
  auto model = test::two_body_model();
  model.bodies[1].polynomial->quadratic[1] = 1e-7;
  const auto unsound = test::changed(model, [](hid_t) {});
  EXPECT_THAT([&] { check(ModelReader(unsound)); },
              ThrowsMessage<InputError>(AllOf(HasSubstr(arm + "/polynomial"), HasSubstr("K̃(0)"))));
}

TEST(Bodies, DamageInTheSecondIsFoundAndNamed) {
  const auto intact = two_bodies();
  const ModelReader in(intact);
  int tried = 0;
  for (const auto& info : contents(in)) {
    if (!info.path.starts_with(arm) || info.bytes == 0) continue;
    auto damaged = intact;
    const Dataset dataset(H5Dopen2(in.file(), info.path.c_str(), H5P_DEFAULT));
    damaged[H5Dget_offset(dataset.get()) + info.bytes / 2] ^= std::byte{0x10};
    const auto refused = ThrowsMessage<InputError>(AllOf(HasSubstr(info.path), HasSubstr("checksum")));
    EXPECT_THAT([&] { check(ModelReader(damaged)); }, refused) << info.path;
    ++tried;
  }
  EXPECT_GT(tried, 30);
}

TEST(Bodies, WithoutTheirChecksumsAreRefused) {
  const auto lost = test::changed(test::two_body_model(), [](hid_t file) {
    H5Adelete_by_name(file, arm.c_str(), schema::problem_checksum, H5P_DEFAULT);
  });
  EXPECT_THAT([&] { check(ModelReader(lost)); },
              ThrowsMessage<InputError>(AllOf(HasSubstr(arm), HasSubstr("'problem_checksum'"))));
}

TEST(Bodies, AnUnknownNameCostsASentenceThatNamesTheNearest) {
  const ModelReader in(two_bodies());
  const auto refused = ThrowsMessage<InputError>(HasSubstr("has no body 'arm/uper'; did you mean 'arm/upper'?"));
  EXPECT_THAT([&] { in.require_body("arm/uper"); }, refused);
  EXPECT_THAT([&] { read_body(in, "arm/uper"); }, refused);
  EXPECT_THAT([&] { check_complete(in, "arm/uper"); }, refused);
  EXPECT_NO_THROW(in.require_body("arm/upper"));
}

TEST(Bodies, AreShownToParaViewEachByAFileOfItsOwn) {
  const test::Folder folder;
  write(folder / "model.h5", test::two_body_model());
  EXPECT_EQ(folder.files(), 4U);
  const auto first_x = [&](const char* view) {
    const File file(H5Fopen((folder / view).c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
    const Dataset points(H5Dopen2(file.get(), "/VTKHDF/Points", H5P_DEFAULT));
    model::Points x(4, 3);
    EXPECT_GE(H5Dread(points.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, x.data()), 0) << view;
    return x(0, 0);
  };
  EXPECT_EQ(first_x("model.hdf"), 0);
  EXPECT_EQ(first_x("model.body.hdf"), 0);
  EXPECT_EQ(first_x("model.arm%2Fupper.hdf"), 5);
}

}  // namespace
}  // namespace ritz::format
