// Damage of every kind costs one sentence, never a crash or a wrong number.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "format/expect_same.hpp"
#include "format/temporary.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/random.hpp"
#include "ritz/format/reader.hpp"
#include "ritz/format/sound.hpp"
#include "support/sample_model.hpp"

namespace ritz::format {
namespace {

using test::Bytes;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

Bytes sample_bytes() {
  const test::Folder folder;
  write(folder / "model.h5", test::sample_model());
  return test::load(folder / "model.h5");
}

void read_all(std::span<const std::byte> image) {
  const ModelReader in(image);
  for (const auto& info : contents(in)) verify(in, info);
}

std::size_t offset(const ModelReader& in, const std::string& path) {
  const Dataset dataset(H5Dopen2(in.file(), path.c_str(), H5P_DEFAULT));
  return H5Dget_offset(dataset.get());
}

TEST(Damage, InEachDatasetIsFoundAndNamed) {
  const auto intact = sample_bytes();
  const ModelReader in(intact);
  int tried = 0;
  for (const auto& info : contents(in)) {
    if (info.bytes == 0) continue;
    for (const auto at : {std::uint64_t{0}, info.bytes / 2, info.bytes - 1}) {
      auto damaged = intact;
      damaged[offset(in, info.path) + at] ^= std::byte{0x10};
      EXPECT_THAT([&] { read_all(damaged); },
                  ThrowsMessage<InputError>(AllOf(HasSubstr(info.path), HasSubstr("checksum"))))
          << info.path;
      ++tried;
    }
  }
  EXPECT_GT(tried, 100);
}

TEST(Damage, InAnyByteIsFoundOrHarmless) {
  const auto intact = sample_bytes();
  int found = 0;
  for (std::size_t at = 0; at < intact.size(); at += 17) {
    auto damaged = intact;
    damaged[at] ^= std::byte{0xff};
    try {
      test::expect_same(read(ModelReader(damaged)), test::sample_model());
    } catch (const InputError&) {
      ++found;
    }
  }
  EXPECT_GT(found, static_cast<int>(intact.size()) / 17 / 3);
}

/// The fewest bytes that a disk loses at once, and bytes of no sense in their place.
TEST(Damage, InAnyBlockIsFoundOrHarmless) {
  const auto intact = sample_bytes();
  constexpr std::size_t sector = 512, stride = 128;
  int found = 0;
  for (std::size_t at = 0; at < intact.size(); at += stride)
    for (const unsigned seed : {0U, 1U}) {
      auto damaged = intact;
      for (std::size_t i = at; i < std::min(at + sector, intact.size()); ++i)
        damaged[i] = seed == 0 ? std::byte{0} : static_cast<std::byte>(split_mix(i) >> 32);
      try {
        const ModelReader in(damaged);
        check(in);
        test::expect_same(read(in), test::sample_model());
      } catch (const InputError&) {
        ++found;
      }
    }
  EXPECT_GT(found, static_cast<int>(intact.size() / stride));
}

TEST(Damage, ByTruncationIsFoundAtAnyLength) {
  const auto intact = sample_bytes();
  for (std::size_t length = 0; length < intact.size(); length += 1 + length / 50)
    EXPECT_THROW(read_all(std::span(intact).first(length)), InputError) << length;
  EXPECT_THROW(read_all(std::span(intact).first(intact.size() - 1)), InputError);
  EXPECT_NO_THROW(read_all(intact));
}

/// The sample with `change` done to it behind the writer's back.
template <class Change>
void read_changed(Change change) {
  const test::Folder folder;
  const auto path = folder / "model.h5";
  write(path, test::sample_model());
  {
    const File file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT));
    change(file.get());
  }
  read(path);
}

TEST(Damage, ByMissingObjectsIsFoundAndNamed) {
  for (const std::string path :
       {"/provenance", "/bodies/body/geometry", "/bodies/body/geometry/points", "/bodies/body/geometry/vertex_ids",
        "/bodies/body/geometry/cells/types", "/bodies/body/geometry/sets/tip/rows", "/bodies/body/geometry/cells",
        "/bodies/body/geometry/materials/young", "/bodies/body/basis", "/bodies/body/modes/eigenvalues",
        "/bodies/body/modes/kinds", "/bodies/body/modes/certificate", "/bodies/body/inertia/gram",
        "/bodies/body/loads/tip/total", "/report/seconds"})
    EXPECT_THAT(([&] { read_changed([&](hid_t file) { H5Ldelete(file, path.c_str(), H5P_DEFAULT); }); }),
                ThrowsMessage<InputError>(HasSubstr(path)))
        << path;
  EXPECT_THROW(read_changed([](hid_t file) { H5Ldelete(file, "/bodies", H5P_DEFAULT); }), InputError);
  EXPECT_THROW(read_changed([](hid_t file) { H5Ldelete(file, "/bodies/body/basis/columns/0002", H5P_DEFAULT); }),
               InputError);
}

TEST(Damage, ByMissingAttributesIsFoundAndNamed) {
  const std::vector<std::pair<std::string, std::string>> attributes = {{"/bodies/body/geometry", "rows"},
                                                                       {"/bodies/body/geometry/points", "checksum"},
                                                                       {"/bodies/body/basis", "column_count"},
                                                                       {"/bodies/body/modes/certificate", "shift"},
                                                                       {"/provenance", "program"},
                                                                       {"/bodies/body/loads/tip", "vertices"}};
  for (const auto& [object, name] : attributes)
    EXPECT_THAT(
        ([&] { read_changed([&](hid_t f) { H5Adelete_by_name(f, object.c_str(), name.c_str(), H5P_DEFAULT); }); }),
        ThrowsMessage<InputError>(AllOf(HasSubstr(object), HasSubstr(name))));
}

void replace(hid_t file, const std::string& path, std::vector<hsize_t> dims, hid_t type) {
  H5Ldelete(file, path.c_str(), H5P_DEFAULT);
  const Space space(H5Screate_simple(static_cast<int>(dims.size()), dims.data(), nullptr));
  const Properties stored(H5Pcreate(H5P_DATASET_CREATE));
  const bool small = dims.empty() || dims.front() < 1'000;
  H5Pset_alloc_time(stored.get(), small ? H5D_ALLOC_TIME_EARLY : H5D_ALLOC_TIME_LATE);
  const Dataset made(H5Dcreate2(file, path.c_str(), type, space.get(), H5P_DEFAULT, stored.get(), H5P_DEFAULT));
}

TEST(Damage, ByWrongShapesIsFoundAndNamed) {
  const std::vector<std::pair<std::string, std::vector<hsize_t>>> shapes = {
      {"/bodies/body/geometry/points", {4, 2}},
      {"/bodies/body/geometry/points", {12}},
      {"/bodies/body/geometry/points", {1'000'000'000'000, 3}},
      {"/bodies/body/geometry/points", {}},
      {"/bodies/body/basis/columns/0001", {4, 4}},
      {"/bodies/body/basis/columns/0002", {5, 3}},
      {"/bodies/body/modes/energies", {3}},
      {"/bodies/body/inertia/origin", {4}},
      {"/bodies/body/inertia/gram", {10, 9}},
      {"/bodies/body/loads/tip/total", {2, 2}}};
  for (const auto& [path, dims] : shapes)
    EXPECT_THAT(([&] { read_changed([&](hid_t file) { replace(file, path, dims, H5T_IEEE_F64LE); }); }),
                ThrowsMessage<InputError>(HasSubstr(path)))
        << path;
}

TEST(Damage, ByWrongTypesIsFoundAndNamed) {
  EXPECT_THAT(([&] {
                read_changed([](hid_t f) { replace(f, "/bodies/body/geometry/points", {4, 3}, H5T_IEEE_F32LE); });
              }),
              ThrowsMessage<InputError>(HasSubstr("points has the wrong type")));
  EXPECT_THROW(read_changed([](hid_t f) { replace(f, "/bodies/body/modes/kinds", {2}, H5T_IEEE_F64LE); }), InputError);
}

/// One value in place of a dataset, with its checksum and units as they were.
void replace_by_one(hid_t file, const std::string& path, hid_t type) {
  const std::string kept = path + "-kept";
  H5Lmove(file, path.c_str(), file, kept.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  const Dataset old(H5Dopen2(file, kept.c_str(), H5P_DEFAULT));
  const Space space(H5Screate(H5S_SCALAR));
  const Dataset made(H5Dcreate2(file, path.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  H5Aiterate2(
      old.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr,
      [](hid_t from, const char* name, const H5A_info_t*, void* to) -> herr_t {
        const Attribute attribute(H5Aopen(from, name, H5P_DEFAULT));
        const Type kind(H5Aget_type(attribute.get()));
        const Space one(H5Aget_space(attribute.get()));
        std::vector<std::byte> bytes(H5Tget_size(kind.get()));
        H5Aread(attribute.get(), kind.get(), bytes.data());
        const Attribute copy(
            H5Acreate2(*static_cast<hid_t*>(to), name, kind.get(), one.get(), H5P_DEFAULT, H5P_DEFAULT));
        return H5Awrite(copy.get(), kind.get(), bytes.data());
      },
      std::array<hid_t, 1>{made.get()}.data());
  H5Ldelete(file, kept.c_str(), H5P_DEFAULT);
}

TEST(Damage, BySingleValuesIsFoundAndNamed) {
  const Type fixed(H5Tcopy(H5T_C_S1)), variable(H5Tcopy(H5T_C_S1));
  H5Tset_size(variable.get(), H5T_VARIABLE);
  const test::Folder folder;
  const auto path = folder / "model.h5";
  for (const hid_t type : {H5T_IEEE_F64LE, fixed.get(), variable.get()})
    for (const std::string name : {"eigenvalues", "kinds"}) {
      write(path, test::sample_model());
      const auto place = "/bodies/body/modes/" + name;
      {
        const File file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT));
        replace_by_one(file.get(), place, type);
      }
      const auto complains = ThrowsMessage<InputError>(AllOf(HasSubstr(place), HasSubstr("single value")));
      EXPECT_THAT([&] { read(path); }, complains);
      EXPECT_THAT([&] { read_all(test::load(path)); }, complains);
    }
}

TEST(Damage, ByTextsOfAnyLengthIsFoundAndNamed) {
  const Type variable(H5Tcopy(H5T_C_S1));
  H5Tset_size(variable.get(), H5T_VARIABLE);
  EXPECT_THAT(([&] { read_changed([&](hid_t f) { replace(f, "/bodies/body/modes/kinds", {2}, variable.get()); }); }),
              ThrowsMessage<InputError>(AllOf(HasSubstr("modes/kinds"), HasSubstr("fixed-length"))));
}

TEST(Damage, ByPartsThatDoNotFitTogetherIsFound) {
  const test::Folder folder;
  const auto refuses = [&](auto change) {
    auto model = test::sample_model();
    change(model.bodies[0]);
    write(folder / "model.h5", model);
    EXPECT_THROW(read(folder / "model.h5"), InputError);
  };
  refuses([](model::Body& b) { b.basis.U = model::RowMatrix::Zero(9, 2); });
  refuses([](model::Body& b) { b.basis.U = model::RowMatrix::Zero(12, 3); });
  refuses([](model::Body& b) { b.geometry.cells.vertices[2] = 4; });
  refuses([](model::Body& b) { b.geometry.cells.vertices[2] = -1; });
  refuses([](model::Body& b) { b.geometry.sets[0].rows = {4}; });
  refuses([](model::Body& b) { b.loads[0].total = Eigen::MatrixXd::Zero(3, 3); });
}

}  // namespace
}  // namespace ritz::format
