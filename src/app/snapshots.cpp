#include "ritz/app/snapshots.hpp"

#include <hdf5.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "ritz/app/npy.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/regular_file.hpp"
#include "ritz/format/checksum.hpp"
#include "ritz/format/schema.hpp"
#include "ritz/format/stored_file.hpp"
#include "ritz/parallel/guard.hpp"

namespace ritz::app {
namespace {

using Row = Eigen::VectorXd;

[[noreturn]] void refuse_snapshots(const std::filesystem::path& file, const std::string& why) {
  throw InputError("option -snapshots " + file.string() + ": " + why);
}

/// One vector after another out of a file, from the first to the last.
class Snapshots {
 public:
  virtual ~Snapshots() = default;
  virtual void read(std::int64_t row, Row& into) = 0;

  std::int64_t count = 0, length = 0;
};

class NumpySnapshots : public Snapshots {
 public:
  explicit NumpySnapshots(const std::filesystem::path& file)
      : file_(file), in_(file, std::ios::binary), array_(read_npy_header(file, "option -snapshots")) {
    count = array_.rows;
    length = array_.columns;
  }

  void read(std::int64_t row, Row& into) override {
    in_.seekg(array_.first_byte + 8 * row * length);
    in_.read(reinterpret_cast<char*>(into.data()), 8 * length);
    if (!in_) refuse_snapshots(file_, "the file ends before its snapshot " + std::to_string(row + 1));
  }

 private:
  std::filesystem::path file_;
  std::ifstream in_;
  NpyArray array_;
};

/// Rows of /snapshots of a file that ritz-full wrote, whose checksum is verified with the last of them, or of another.
class Hdf5Snapshots : public Snapshots {
 public:
  explicit Hdf5Snapshots(const std::filesystem::path& path)
      : path_(path),
        in_(path, "option -snapshots " + path.string(), {.kind = "file of snapshots", .writer = "ritz-full"}) {
    const auto objects = format::survey(in_, std::array<std::string_view, 1>{name}, format::Storage::foreign);
    if (objects.empty() || objects.front().kind != format::StoredObject::Kind::dataset)
      refuse_snapshots(path, "the file has no dataset /snapshots; ritz-full writes one when it writes frames");
    if (objects.front().shape.size() != 2) refuse_snapshots(path, "/snapshots must have two dimensions");
    count = objects.front().shape[0];
    length = objects.front().shape[1];
    dataset_ = format::Dataset(H5Dopen2(in_.file(), name, H5P_DEFAULT));
    space_ = format::Space(H5Dget_space(dataset_.get()));
    if (format::has_attribute(in_, name, format::schema::checksum))
      checksum_ = format::read_bits(in_, name, format::schema::checksum);
  }

  void read(std::int64_t row, Row& into) override {
    const std::array<hsize_t, 2> start{static_cast<hsize_t>(row), 0}, counts{1, static_cast<hsize_t>(length)};
    const format::Space memory(H5Screate_simple(1, &counts[1], nullptr));
    H5Sselect_hyperslab(space_.get(), H5S_SELECT_SET, start.data(), nullptr, counts.data(), nullptr);
    if (H5Dread(dataset_.get(), H5T_NATIVE_DOUBLE, memory.get(), space_.get(), H5P_DEFAULT, into.data()) < 0)
      refuse_snapshots(path_, "/snapshots cannot be read as numbers");
    constexpr std::size_t vertex = 3 * sizeof(double);
    const auto bytes = std::as_bytes(std::span(into.data(), static_cast<std::size_t>(length)));
    if (length % 3 == 0) sum_ += format::checksum(bytes, vertex, row * length / 3);
    if (row + 1 == count && checksum_ && *checksum_ != sum_)
      refuse_snapshots(
          path_, "/snapshots does not have the checksum it was written with: the file is damaged; write it again");
  }

 private:
  static constexpr auto name = "/snapshots";
  std::filesystem::path path_;
  format::StoredFile in_;
  format::Dataset dataset_;
  format::Space space_;
  std::optional<std::uint64_t> checksum_;
  std::uint64_t sum_ = 0;
};

std::unique_ptr<Snapshots> open(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) refuse_snapshots(file, "there is no such file");
  refuse_irregular(file, "option -snapshots " + file.string());
  if (file.extension() == ".npy") return std::make_unique<NumpySnapshots>(file);
  return std::make_unique<Hdf5Snapshots>(file);
}

std::unique_ptr<Snapshots> open_for(const mesh::Mesh& mesh, const std::filesystem::path& file) {
  auto in = open(file);
  if (in->length != 3 * mesh.vertices_total)
    refuse_snapshots(file, "its vectors have " + std::to_string(in->length) + " numbers, but the mesh has " +
                               std::to_string(mesh.vertices_total) + " vertices, so they must have " +
                               std::to_string(3 * mesh.vertices_total));
  if (in->count == 0) refuse_snapshots(file, "it holds no snapshot");
  return in;
}

petsc::Tall read_rows(const std::filesystem::path& file, const mesh::Mesh& mesh) {
  const auto in = open_for(mesh, file);
  petsc::Tall u(3 * mesh.owned, in->count);
  Row row(in->length);
  for (std::int64_t s = 0; s < in->count; ++s) {
    in->read(s, row);
    if (!row.allFinite())
      refuse_snapshots(file, "snapshot " + std::to_string(s + 1) + " holds a number that is not finite");
    for (int v = 0; v < mesh.owned; ++v)
      u.col(s).segment<3>(3 * v) = row.segment<3>(3 * mesh.file_positions[static_cast<std::size_t>(v)]);
  }
  return u;
}

}  // namespace

mesh::FreeRows read_snapshots(const std::filesystem::path& file, const mesh::Mesh& mesh, const mesh::Dofs& dofs) {
  petsc::Tall u;
  parallel::together(mesh.comm, [&] { u = read_rows(file, mesh); });
  return mesh::from_vertices(mesh, dofs, u);
}

std::int64_t count_snapshots(const std::filesystem::path& file, const mesh::Mesh& mesh) {
  std::int64_t count = 0;
  parallel::together(mesh.comm, [&] { count = open_for(mesh, file)->count; });
  return count;
}

}  // namespace ritz::app
