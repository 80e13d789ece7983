// What a model keeps in another way than ritz does is refused when it is opened, before HDF5 follows it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "format/changed.hpp"
#include "format/expect_same.hpp"
#include "ritz/base/error.hpp"
#include "ritz/format/reader.hpp"
#include "ritz/format/sound.hpp"
#include "support/sample_model.hpp"

namespace ritz::format {
namespace {

using test::Bytes;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

const std::string energies = "/bodies/body/modes/energies", total = "/bodies/body/loads/tip/total";

void expect_refused(const std::function<void(hid_t)>& change, const std::string& path, const char* why) {
  const auto bytes = test::changed(test::sample_model(), change);
  EXPECT_THAT([&] { check(ModelReader(bytes)); }, ThrowsMessage<InputError>(AllOf(HasSubstr(path), HasSubstr(why))));
}

Properties creation() { return Properties(H5Pcreate(H5P_DATASET_CREATE)); }

TEST(Structure, OfViewsInThePlaceOfNumbersIsRefused) {
  for (const auto& [path, shape] : {std::pair{energies, std::vector<hsize_t>{2}}, {total, {2, 3}}})
    for (const auto& source : {path, std::string("/bodies/body/modes/eigenvalues")}) {
      const auto to_itself = [&](hid_t file) {
        const auto view = creation();
        const Space space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr));
        H5Pset_virtual(view.get(), space.get(), ".", source.c_str(), space.get());
        test::put(file, path, shape, {}, view.get());
      };
      expect_refused(to_itself, path, "view");
    }
}

TEST(Structure, OfPackedAndScatteredNumbersIsRefused) {
  const hsize_t piece = 1;
  const auto chunked = creation(), packed = creation(), compact = creation(), elsewhere = creation();
  H5Pset_chunk(chunked.get(), 1, &piece);
  H5Pset_chunk(packed.get(), 1, &piece);
  H5Pset_deflate(packed.get(), 9);
  H5Pset_layout(compact.get(), H5D_COMPACT);
  H5Pset_external(elsewhere.get(), "/etc/passwd", 0, H5F_UNLIMITED);
  const auto with = [](const Properties& properties) {
    return [&](hid_t file) { test::put(file, energies, {2}, {4, 9}, properties.get()); };
  };
  for (const auto* pieces : {&chunked, &packed, &compact}) expect_refused(with(*pieces), energies, "in pieces");
  const auto external = [&](hid_t file) { test::put(file, energies, {2}, {}, elsewhere.get()); };
  expect_refused(external, energies, "other files");
}

TEST(Structure, OfNumbersThatAreNotInTheFileIsRefused) {
  const auto late = creation();
  H5Pset_alloc_time(late.get(), H5D_ALLOC_TIME_LATE);
  const double fill = 1;
  H5Pset_fill_value(late.get(), H5T_IEEE_F64LE, &fill);
  const auto with = [&](const std::vector<hsize_t>& shape) {
    return [&](hid_t file) { test::put(file, energies, shape, {}, late.get()); };
  };
  expect_refused(with({2}), energies, "not in the file");
  expect_refused(with({hsize_t{1} << 40}), energies, "larger than the file");
  expect_refused(with({hsize_t{1} << 30, hsize_t{1} << 30}), energies, "larger than the file");
}

TEST(Structure, OfLinksToElsewhereIsRefused) {
  const auto instead = [](const std::string& path, const auto& link) {
    return [=](hid_t file) {
      H5Lmove(file, path.c_str(), file, "/kept", H5P_DEFAULT, H5P_DEFAULT);
      link(file, path);
    };
  };
  const auto soft = [](hid_t f, const std::string& path) {
    H5Lcreate_soft("/kept", f, path.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  };
  const auto external = [](hid_t f, const std::string& path) {
    H5Lcreate_external("other.h5", "/kept", f, path.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  };
  for (const std::string path : {"/bodies", "/bodies/body/basis", "/bodies/body/modes/energies", "/report/notes"}) {
    expect_refused(instead(path, soft), path, "link to elsewhere");
    expect_refused(instead(path, external), path, "link to elsewhere");
  }
}

TEST(Structure, OfGroupsWithinThemselvesIsRefused) {
  for (const std::string inner : {"/bodies/body/geometry/sets/loop", "/report/loop"})
    for (const std::string outer : {"/", "/bodies", "/bodies/body/geometry/sets"}) {
      const auto loop = [&](hid_t file) {
        H5Lcreate_hard(file, outer.c_str(), file, inner.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      };
      expect_refused(loop, inner, "within itself");
    }
}

TEST(Structure, OfForeignObjectsAndTypesIsRefused) {
  const auto named = [](hid_t file) {
    const Type type(H5Tcopy(H5T_IEEE_F64LE));
    H5Tcommit2(file, "/report/type", type.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  };
  expect_refused(named, "/report/type", "neither a group nor a dataset");
  const auto of_type = [](hid_t type) {
    return [type](hid_t file) {
      const hsize_t two = 2;
      H5Ldelete(file, energies.c_str(), H5P_DEFAULT);
      const Space space(H5Screate_simple(1, &two, nullptr));
      const auto early = creation();
      H5Pset_alloc_time(early.get(), H5D_ALLOC_TIME_EARLY);
      const Dataset made(H5Dcreate2(file, energies.c_str(), type, space.get(), H5P_DEFAULT, early.get(), H5P_DEFAULT));
      const test::Bytes zeros(16);
      if (H5Tget_class(type) <= H5T_FLOAT) H5Dwrite(made.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros.data());
      test::attach_units(made.get());
      test::attach(made.get(), "checksum", checksum(zeros, 8));
    };
  };
  const Type variable(H5Tvlen_create(H5T_IEEE_F64LE)), compound(H5Tcreate(H5T_COMPOUND, 8));
  H5Tinsert(compound.get(), "x", 0, H5T_IEEE_F64LE);
  for (const hid_t type : {variable.get(), compound.get(), H5T_STD_REF_OBJ})
    expect_refused(of_type(type), energies, "neither numbers nor");
  for (const hid_t type : {H5T_IEEE_F64BE, H5T_STD_I64LE}) expect_refused(of_type(type), energies, "wrong type");
}

TEST(Structure, OfAttributesIsCheckedBeforeTheyAreRead) {
  const auto with = [](const std::string& object, const char* name, hid_t type, const std::vector<hsize_t>& shape) {
    return [=](hid_t file) {
      H5Adelete_by_name(file, object.c_str(), name, H5P_DEFAULT);
      const Space space(shape.empty() ? H5Screate(H5S_SCALAR)
                                      : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr));
      const Attribute made(
          H5Acreate_by_name(file, object.c_str(), name, type, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    };
  };
  const std::string modes = "/bodies/body/modes";
  const Type variable(H5Tcopy(H5T_C_S1));
  H5Tset_size(variable.get(), H5T_VARIABLE);
  expect_refused(with(modes, "orthonormality", H5T_IEEE_F64LE, {5000}), modes, "orthonormality");
  expect_refused(with(modes, "orthonormality", H5T_IEEE_F32LE, {}), modes, "wrong type");
  expect_refused(with(modes + "/certificate", "certified", variable.get(), {}), modes, "fixed-length text");
  expect_refused(with(modes + "/certificate", "certified", H5T_C_S1, {7}), modes, "fixed-length text");
  expect_refused(with("/bodies/body/basis", "column_count", H5T_STD_I64LE, {2}), "basis", "not one number");
}

/// Where the mapping of the view basis/U stands, which nothing but h5py reads.
std::size_t heap(const Bytes& bytes) {
  const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return text.find("GCOL");
}

TEST(Structure, OfAHeapThatIsDamagedIsRefusedAndDoesNotHang) {
  const auto intact = test::changed(test::sample_model(), [](hid_t) {});
  const auto at = heap(intact);
  ASSERT_LT(at, intact.size());
  for (const std::size_t start : {at + 16, at + 24, at + 64, at + 128}) {  // sizes, then the mapping and free space
    auto damaged = intact;
    std::fill_n(damaged.begin() + static_cast<std::ptrdiff_t>(start),
                std::min<std::size_t>(512, damaged.size() - start), std::byte{0});
    EXPECT_THAT([&] { check(ModelReader(damaged)); },
                ThrowsMessage<InputError>(AllOf(HasSubstr("basis/U"), HasSubstr("damaged view"))))
        << start - at;
  }
}

TEST(Structure, OfViewsIsListedAndNotRead) {
  const auto bytes = test::changed(test::sample_model(), [](hid_t) {});
  const auto infos = contents(ModelReader(bytes));
  EXPECT_EQ(std::ranges::count(infos, true, &DatasetInfo::is_virtual), 1);
  const auto U = std::ranges::find(infos, true, &DatasetInfo::is_virtual);
  EXPECT_EQ(U->path, "/bodies/body/basis/U");
  EXPECT_EQ(U->shape, (std::vector<std::int64_t>{12, 2}));
  EXPECT_EQ(U->bytes, 0U);
}

}  // namespace
}  // namespace ritz::format
