#include "ritz/app/snapshots.hpp"

#include <hdf5.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>

#include "ritz/base/error.hpp"
#include "ritz/format/handle.hpp"
#include "ritz/parallel/guard.hpp"

namespace ritz::app {
namespace {

using Row = Eigen::VectorXd;

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
  throw InputError("option -snapshots " + file.string() + ": " + why);
}

/// One vector after another out of a file.
class Snapshots {
 public:
  virtual ~Snapshots() = default;
  virtual void read(std::int64_t row, Row& into) = 0;

  std::int64_t count = 0, length = 0;
};

class NumpySnapshots : public Snapshots {
 public:
  explicit NumpySnapshots(const std::filesystem::path& file) : file_(file), in_(file, std::ios::binary) {
    std::array<char, 10> start{};
    in_.read(start.data(), start.size());
    if (!in_ || std::string(start.data(), 6) != "\x93NUMPY" || start[6] != 1)
      refuse(file, "that is not a .npy file of version 1; write it with numpy.save");
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(start[i]); };
    std::string header(static_cast<std::size_t>(byte(8) + 256 * byte(9)), ' ');
    in_.read(header.data(), static_cast<std::streamsize>(header.size()));
    first_ = static_cast<std::int64_t>(start.size() + header.size());
    long long rows = 0, columns = 0;
    constexpr auto form = "{'descr': '<f8', 'fortran_order': False, 'shape': (%15lld, %15lld)";
    if (std::sscanf(header.c_str(), form, &rows, &columns) != 2 || rows < 0)
      refuse(file, "snapshots must be a float64 array of two dimensions in C order, a snapshot a row");
    count = rows;
    length = columns;
    const auto numbers = (static_cast<std::int64_t>(std::filesystem::file_size(file)) - first_) / 8;
    if (length > 0 && numbers / length < count)
      refuse(file, "the file ends before its snapshot " + std::to_string(numbers / length + 1));
  }

  void read(std::int64_t row, Row& into) override {
    in_.seekg(first_ + 8 * row * length);
    in_.read(reinterpret_cast<char*>(into.data()), 8 * length);
    if (!in_) refuse(file_, "the file ends before its snapshot " + std::to_string(row + 1));
  }

 private:
  std::filesystem::path file_;
  std::ifstream in_;
  std::int64_t first_ = 0;
};

class Hdf5Snapshots : public Snapshots {
 public:
  explicit Hdf5Snapshots(const std::filesystem::path& path)
      : path_(path), file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) {
    if (!file_) refuse(path, "that is neither a .npy nor a readable HDF5 file");
    if (H5Lexists(file_.get(), "snapshots", H5P_DEFAULT) > 0)
      dataset_ = format::Dataset(H5Dopen2(file_.get(), "snapshots", H5P_DEFAULT));
    if (!dataset_) refuse(path, "the file has no dataset /snapshots; ritz-full writes one when it writes frames");
    space_ = format::Space(H5Dget_space(dataset_.get()));
    std::array<hsize_t, 2> shape{};
    if (H5Sget_simple_extent_ndims(space_.get()) != 2) refuse(path, "/snapshots must have two dimensions");
    H5Sget_simple_extent_dims(space_.get(), shape.data(), nullptr);
    count = static_cast<std::int64_t>(shape[0]);
    length = static_cast<std::int64_t>(shape[1]);
  }

  void read(std::int64_t row, Row& into) override {
    const std::array<hsize_t, 2> start{static_cast<hsize_t>(row), 0}, counts{1, static_cast<hsize_t>(length)};
    const format::Space memory(H5Screate_simple(1, &counts[1], nullptr));
    H5Sselect_hyperslab(space_.get(), H5S_SELECT_SET, start.data(), nullptr, counts.data(), nullptr);
    const format::Type type(H5Dget_type(dataset_.get()));
    if (H5Tget_class(type.get()) != H5T_FLOAT) refuse(path_, "/snapshots must hold floating point numbers");
    if (H5Dread(dataset_.get(), H5T_NATIVE_DOUBLE, memory.get(), space_.get(), H5P_DEFAULT, into.data()) < 0)
      refuse(path_, "/snapshots cannot be read as numbers");
  }

 private:
  std::filesystem::path path_;
  format::File file_;
  format::Dataset dataset_;
  format::Space space_;
};

std::unique_ptr<Snapshots> open(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file) || std::filesystem::is_directory(file)) refuse(file, "there is no such file");
  if (file.extension() == ".npy") return std::make_unique<NumpySnapshots>(file);
  return std::make_unique<Hdf5Snapshots>(file);
}

std::unique_ptr<Snapshots> open_for(const mesh::Mesh& mesh, const std::filesystem::path& file) {
  auto in = open(file);
  if (in->length != 3 * mesh.vertices_total)
    refuse(file, "its vectors have " + std::to_string(in->length) + " numbers, but the mesh has " +
                     std::to_string(mesh.vertices_total) + " vertices, so they must have " +
                     std::to_string(3 * mesh.vertices_total));
  if (in->count == 0) refuse(file, "it holds no snapshot");
  return in;
}

petsc::Tall read_rows(const std::filesystem::path& file, const mesh::Mesh& mesh) {
  const auto in = open_for(mesh, file);
  petsc::Tall u(3 * mesh.owned, in->count);
  Row row(in->length);
  for (std::int64_t s = 0; s < in->count; ++s) {
    in->read(s, row);
    if (!row.allFinite()) refuse(file, "snapshot " + std::to_string(s + 1) + " holds a number that is not finite");
    for (int v = 0; v < mesh.owned; ++v)
      u.col(s).segment<3>(3 * v) = row.segment<3>(3 * mesh.file_positions[static_cast<std::size_t>(v)]);
  }
  return u;
}

}  // namespace

petsc::Tall read_snapshots(const std::filesystem::path& file, const mesh::Mesh& mesh, const mesh::Dofs& dofs) {
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
