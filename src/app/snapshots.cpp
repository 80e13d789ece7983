#include "ritz/app/snapshots.hpp"

#include <array>
#include <cstdint>
#include <fstream>
#include <memory>
#include <regex>
#include <string>

#include "ritz/base/error.hpp"
#include "ritz/base/regular_file.hpp"
#include "ritz/format/motion_reader.hpp"
#include "ritz/parallel/guard.hpp"

namespace ritz::app {
namespace {

/// The text between the magic string and the numbers; empty where the file is none of NumPy's.
std::string header_text(std::istream& in) {
  std::array<unsigned char, 8> start{};
  in.read(reinterpret_cast<char*>(start.data()), start.size());
  const std::string magic(start.begin(), start.begin() + 6);
  if (!in || magic != "\x93NUMPY" || start[6] < 1 || start[6] > 3) return "";
  std::array<unsigned char, 4> length{};
  in.read(reinterpret_cast<char*>(length.data()), start[6] == 1 ? 2 : 4);
  const std::size_t bytes =
      length[0] + (std::size_t{length[1]} << 8) + (std::size_t{length[2]} << 16) + (std::size_t{length[3]} << 24);
  constexpr std::size_t most = 1 << 16;
  if (!in || bytes > most) return "";
  std::string text(bytes, ' ');
  in.read(text.data(), static_cast<std::streamsize>(bytes));
  return in ? text : "";
}

std::string without_padding(std::string text) {
  text.erase(text.find_last_not_of(" \n") + 1);
  constexpr std::size_t most = 1000;  // std::regex recurses
  return text.size() > most ? "" : text;
}

}  // namespace

NpyArray read_npy_header(const std::filesystem::path& file, const std::string& option) {
  const auto refuse = [&](const std::string& why) { throw InputError(option + " " + file.string() + ": " + why); };
  std::ifstream in(file, std::ios::binary);
  const auto text = header_text(in);
  if (text.empty()) refuse("that is not a .npy file of version 1, 2 or 3; write it with numpy.save");
  const std::regex form(
      R"(\{ *'descr': *'<f8', *'fortran_order': *False, *'shape': *\((\d{1,15}), *(\d{1,15}),?\),? *\})");
  std::smatch found;
  const auto header = without_padding(text);
  if (!std::regex_match(header, found, form))
    refuse("snapshots must be a float64 array of two dimensions in C order, a snapshot a row");
  const NpyArray array{static_cast<std::int64_t>(in.tellg()), std::stoll(found[1]), std::stoll(found[2])};
  const auto bytes = static_cast<std::int64_t>(std::filesystem::file_size(file)) - array.first_byte;
  const std::int64_t row = 8 * array.columns;
  if (row > 0 && bytes / row < array.rows)
    refuse("the file ends before its snapshot " + std::to_string(bytes / row + 1));
  if (bytes != row * array.rows) refuse("the file is longer than its header says; write it again with numpy.save");
  return array;
}

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
