// What is not a model that this version reads is refused when it is opened, with the reason.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "format/temporary.hpp"
#include "ritz/base/error.hpp"
#include "ritz/format/parts.hpp"
#include "support/sample_model.hpp"

namespace ritz::format {
namespace {

using test::Folder;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

template <class Matcher>
void expect_refused(const std::filesystem::path& path, Matcher reason) {
  EXPECT_THAT([&] { ModelReader{path}; }, ThrowsMessage<InputError>(AllOf(HasSubstr(path.string()), reason)));
}

TEST(Refusal, SaysWhyAFileCannotBeOpened) {
  const Folder folder;
  expect_refused(folder / "none.h5", HasSubstr("No such file"));
  std::filesystem::create_directory(folder / "folder");
  expect_refused(folder / "folder", HasSubstr("folder"));
  test::save(folder / "empty.h5", {});
  expect_refused(folder / "empty.h5", HasSubstr("not an HDF5 file"));
  test::save(folder / "zeros.h5", test::Bytes(5000));
  expect_refused(folder / "zeros.h5", HasSubstr("not an HDF5 file"));
}

TEST(Refusal, SaysThatAFileIsHalfWritten) {
  const Folder folder;
  ModelWriter out(folder / "model.h5");
  write_geometry(out, test::sample_geometry(), whole(test::sample_geometry()));
  const auto part = std::filesystem::directory_iterator(folder / "")->path();
  expect_refused(part, HasSubstr("half-written"));

  H5Fflush(out.file(), H5F_SCOPE_GLOBAL);  // as a run that was killed leaves it, renamed by hand
  std::filesystem::copy_file(part, folder / "copy.h5");
  expect_refused(folder / "copy.h5", HasSubstr("half-written"));
}

TEST(Refusal, SaysThatAFileIsNotAModel) {
  const Folder folder;
  const auto path = folder / "other.h5";
  { const File other(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)); }
  expect_refused(path, HasSubstr("not a ritz model"));
}

TEST(Refusal, NamesTheProgramThatCanReadAFutureVersion) {
  const Folder folder;
  const auto path = folder / "model.h5";
  const auto with_version = [&](std::int64_t major, std::int64_t minor) {
    write(path, test::sample_model());
    const File file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT));
    const Attribute version(H5Aopen(file.get(), schema::version, H5P_DEFAULT));
    H5Awrite(version.get(), H5T_NATIVE_INT64, std::array{major, minor}.data());
  };
  with_version(3, 0);
  expect_refused(path, AllOf(HasSubstr("3.0"), HasSubstr("sample 1.0"), HasSubstr("reads 2.x")));
  with_version(0, 9);
  expect_refused(path, HasSubstr("no sensible format version"));
  with_version(1, 7);
  EXPECT_EQ(ModelReader(path).version().minor, 7);
  EXPECT_NO_THROW(read(path));
}

TEST(Refusal, OfMemoryThatHoldsNoModel) {
  EXPECT_THROW(ModelReader(std::span<const std::byte>()), InputError);
  EXPECT_THAT([] { ModelReader(test::Bytes(100), "a blob"); }, ThrowsMessage<InputError>(HasSubstr("a blob")));
}

}  // namespace
}  // namespace ritz::format
