#include "ritz/app/snapshots.hpp"

#include <cstdint>
#include <fstream>
#include <memory>
#include <string>

#include "ritz/app/npy.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/regular_file.hpp"
#include "ritz/format/motion_reader.hpp"
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

/// Of a file that ritz-full wrote, or of another.
class StoredSnapshots : public Snapshots {
 public:
  explicit StoredSnapshots(const std::filesystem::path& file) : in_(file, "option -snapshots " + file.string()) {
    count = in_.count();
    length = in_.length();
  }

  void read(std::int64_t row, Row& into) override {
    in_.read(row, {into.data(), static_cast<std::size_t>(into.size())});
  }

 private:
  format::SnapshotReader in_;
};

std::unique_ptr<Snapshots> open(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) refuse_snapshots(file, "there is no such file");
  refuse_irregular(file, "option -snapshots " + file.string());
  if (file.extension() == ".npy") return std::make_unique<NumpySnapshots>(file);
  return std::make_unique<StoredSnapshots>(file);
}

std::unique_ptr<Snapshots> open_for(const mesh::Mesh& mesh, const std::filesystem::path& file) {
  auto in = open(file);
  if (in->length != mesh::components * mesh.vertices_total)
    refuse_snapshots(file, "its vectors have " + std::to_string(in->length) + " numbers, but the mesh has " +
                               std::to_string(mesh.vertices_total) + " vertices, so they must have " +
                               std::to_string(mesh::components * mesh.vertices_total));
  if (in->count == 0) refuse_snapshots(file, "it holds no snapshot");
  return in;
}

algebra::Tall read_rows(const std::filesystem::path& file, const mesh::Mesh& mesh) {
  const auto in = open_for(mesh, file);
  algebra::Tall u(mesh::components * mesh.owned, in->count);
  Row row(in->length);
  for (std::int64_t s = 0; s < in->count; ++s) {
    in->read(s, row);
    if (!row.allFinite())
      refuse_snapshots(file, "snapshot " + std::to_string(s + 1) + " holds a number that is not finite");
    for (int v = 0; v < mesh.owned; ++v)
      mesh::at_vertex(u.col(s), v) = mesh::at_vertex(row, mesh.file_positions[static_cast<std::size_t>(v)]);
  }
  return u;
}

}  // namespace

mesh::FreeRows read_snapshots(const std::filesystem::path& file, const mesh::Mesh& mesh, const mesh::Dofs& dofs) {
  algebra::Tall u;
  parallel::together(mesh.comm, [&] { u = read_rows(file, mesh); });
  return mesh::from_vertices(mesh, dofs, u);
}

std::int64_t count_snapshots(const std::filesystem::path& file, const mesh::Mesh& mesh) {
  std::int64_t count = 0;
  parallel::together(mesh.comm, [&] { count = open_for(mesh, file)->count; });
  return count;
}

}  // namespace ritz::app
