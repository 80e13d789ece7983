#include "ritz/app/snapshots.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <memory>
#include <regex>
#include <string>
#include <vector>

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
      R"(\{ *'descr': *'<f([48])', *'fortran_order': *(False|True), *'shape': *\((\d{1,15}), *(\d{1,15}),?\),? *\})");
  std::smatch found;
  const auto header = without_padding(text);
  if (!std::regex_match(header, found, form))
    refuse("snapshots must be an array of float64 or float32 of two dimensions, a snapshot a row");
  const NpyArray array{.first_byte = static_cast<std::int64_t>(in.tellg()),
                       .rows = std::stoll(found[3]),
                       .columns = std::stoll(found[4]),
                       .number_bytes = std::stoi(found[1]),
                       .order = found[2] == "True" ? NpyOrder::by_columns : NpyOrder::by_rows};
  const auto bytes = static_cast<std::int64_t>(std::filesystem::file_size(file)) - array.first_byte;
  const std::int64_t row = array.number_bytes * array.columns;
  if (row > 0 && bytes / row < array.rows)
    refuse("the file ends before its snapshot " + std::to_string(bytes / row + 1));
  if (bytes != row * array.rows) refuse("the file is longer than its header says; write it again with numpy.save");
  return array;
}

void read_npy(std::istream& in, const NpyArray& array, std::int64_t first, std::span<double> into) {
  in.seekg(array.first_byte + array.number_bytes * first);
  if (array.number_bytes == sizeof(double)) {
    in.read(reinterpret_cast<char*>(into.data()), static_cast<std::streamsize>(into.size_bytes()));
    return;
  }
  std::vector<float> numbers(into.size());
  in.read(reinterpret_cast<char*>(numbers.data()), static_cast<std::streamsize>(sizeof(float) * numbers.size()));
  std::copy(numbers.begin(), numbers.end(), into.begin());
}

namespace {

[[noreturn]] void refuse_snapshots(const std::filesystem::path& file, const std::string& why) {
  throw InputError("option -snapshots " + file.string() + ": " + why);
}

/// The vectors of a file.
class Snapshots {
 public:
  virtual ~Snapshots() = default;
  /// The rows of these vertices, three each, of all snapshots.
  virtual algebra::Tall at(std::span<const std::int64_t> vertices) = 0;

  std::int64_t count = 0, length = 0;

 protected:
  [[noreturn]] void refuse_infinite(const std::filesystem::path& file, std::int64_t snapshot) const {
    refuse_snapshots(file, "snapshot " + std::to_string(snapshot + 1) + " holds a number that is not finite");
  }
  /// By reading one snapshot after another.
  template <class Read>
  algebra::Tall by_snapshot(const std::filesystem::path& file, std::span<const std::int64_t> vertices, Read read) {
    algebra::Tall u(mesh::components * std::ssize(vertices), count);
    Eigen::VectorXd row(length);
    for (std::int64_t s = 0; s < count; ++s) {
      read(s, std::span(row.data(), static_cast<std::size_t>(length)));
      if (!row.allFinite()) refuse_infinite(file, s);
      for (std::size_t v = 0; v < vertices.size(); ++v)
        mesh::at_vertex(u.col(s), static_cast<Eigen::Index>(v)) = mesh::at_vertex(row, vertices[v]);
    }
    return u;
  }
};

class NumpySnapshots : public Snapshots {
 public:
  explicit NumpySnapshots(const std::filesystem::path& file)
      : file_(file), in_(file, std::ios::binary), array_(read_npy_header(file, "option -snapshots")) {
    count = array_.rows;
    length = array_.columns;
  }

  algebra::Tall at(std::span<const std::int64_t> vertices) override {
    if (array_.order == NpyOrder::by_columns) return by_vertex(vertices);
    return by_snapshot(file_, vertices, [&](std::int64_t s, std::span<double> row) {
      read_npy(in_, array_, s * length, row);
      if (!in_) refuse_snapshots(file_, "the file ends before its snapshot " + std::to_string(s + 1));
    });
  }

 private:
  /// In Fortran order the numbers of all snapshots at a component of a vertex stand together.
  algebra::Tall by_vertex(std::span<const std::int64_t> vertices) {
    const Eigen::Index n = mesh::components * std::ssize(vertices);
    algebra::Tall u(n, count);
    algebra::Tall three(count, mesh::components);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      read_npy(in_, array_, mesh::components * vertices[v] * count,
               std::span(three.data(), static_cast<std::size_t>(three.size())));
      if (!in_) refuse_snapshots(file_, "the file ends before all of its snapshots");
      for (std::int64_t s = 0; s < count; ++s)
        if (!three.row(s).allFinite()) refuse_infinite(file_, s);
      u.middleRows<mesh::components>(mesh::components * static_cast<Eigen::Index>(v)) = three.transpose();
    }
    return u;
  }

  std::filesystem::path file_;
  std::ifstream in_;
  NpyArray array_;
};

/// Of a file that ritz-full wrote, or of another.
class StoredSnapshots : public Snapshots {
 public:
  explicit StoredSnapshots(const std::filesystem::path& file)
      : file_(file), in_(file, "option -snapshots " + file.string()) {
    count = in_.count();
    length = in_.length();
  }

  algebra::Tall at(std::span<const std::int64_t> vertices) override {
    return by_snapshot(file_, vertices, [&](std::int64_t s, std::span<double> row) { in_.read(s, row); });
  }

 private:
  std::filesystem::path file_;
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
  return open_for(mesh, file)->at(std::span(mesh.file_positions).first(static_cast<std::size_t>(mesh.owned)));
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
