// The same small mesh in every format: two tetrahedra on five vertices, two regions, a face at the bottom.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "ritz/readers/file_mesh.hpp"

namespace ritz::readers::testing {

/// A file that is there as long as the object is.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, std::string_view bytes);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Writes the bytes to a file of that name and reads it.
FileMesh read_text(const std::string& name, std::string_view bytes, const Ignored& ignored = {});
/// The InputError's text; a test failure when there is none.
std::string error_of(const std::string& name, std::string_view bytes, const Ignored& ignored = {});

/// `text` with the first `from` replaced; throws when there is none.
std::string with(std::string text, std::string_view from, std::string_view to);
std::string with_crlf(std::string_view text);
std::string without_last_newline(std::string text);

/// Numbers as they stand in memory.
class Bytes {
 public:
  template <class T>
  Bytes& add(T value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    return *this;
  }
  Bytes& text(std::string_view value) {
    bytes_ += value;
    return *this;
  }
  const std::string& str() const { return bytes_; }

 private:
  std::string bytes_;
};

const NamedSet* find_set(const FileMesh& mesh, std::string_view name);
/// The names of the cells' regions, one a cell.
std::vector<std::string> cell_region_names(const FileMesh& mesh);

extern const std::vector<std::array<double, 3>> two_tets_points;
extern const std::vector<Index> two_tets_cells;  ///< cell_vertices

/// Fails unless the mesh is the two tetrahedra with regions and sets of these names; `bottom` may be absent ("").
void expect_two_tets(const FileMesh& mesh, const std::string& lower, const std::string& upper,
                     const std::string& bottom);
/// Fails unless every offset and number of the mesh is in range.
void expect_consistent(const FileMesh& mesh);

struct NamedFile {
  std::string label;
  std::string name;
  std::string bytes;
};

std::string msh22_text();
std::string msh22_binary();
std::string msh41_text();
std::string msh41_binary();
std::string veg_text();
std::string inp_text();
/// That file with more keywords before its step.
std::string inp_with(const std::string& more);
std::string vtu_text();
enum class VtuForm { inline_base64, appended_base64, appended_raw };
enum class VtuPacking { plain, zlib, lz4, lzma };
enum class VtuFirst { low_byte, high_byte };  ///< of each number
/// Header numbers of 4 or 8 bytes.
std::string vtu_binary(VtuForm form, VtuPacking packing, int header_size, VtuFirst first = VtuFirst::low_byte);

/// One good file of every format and variant.
std::vector<NamedFile> good_files();

}  // namespace ritz::readers::testing
