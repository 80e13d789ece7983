#include "readers/fixture.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "ritz/base/error.hpp"

namespace ritz::readers::testing {

namespace {

/// A folder of this process, gone when it ends.
struct Folder {
  std::filesystem::path path = std::filesystem::temp_directory_path() / ("ritz-readers-" + std::to_string(getpid()));
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

}  // namespace

TemporaryFile::TemporaryFile(const std::string& name, std::string_view bytes) {
  static const Folder folder;
  path_ = folder.path / name;
  std::ofstream(path_, std::ios::binary) << bytes;
}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

FileMesh read_text(const std::string& name, std::string_view bytes, const Ignored& ignored) {
  const TemporaryFile file(name, bytes);
  return read_file(file.path(), ignored);
}

std::string error_of(const std::string& name, std::string_view bytes, const Ignored& ignored) {
  try {
    read_text(name, bytes, ignored);
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << name << " was read without an error";
  return {};
}

std::string with(std::string text, std::string_view from, std::string_view to) {
  const auto at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("'" + std::string(from) + "' is not in the text");
  return text.replace(at, from.size(), to);
}

std::string with_crlf(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\n') result += '\r';
    result += c;
  }
  return result;
}

std::string without_last_newline(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

const NamedSet* find_set(const FileMesh& mesh, std::string_view name) {
  const auto found = std::find_if(mesh.sets.begin(), mesh.sets.end(), [&](const auto& s) { return s.name == name; });
  return found == mesh.sets.end() ? nullptr : &*found;
}

std::vector<std::string> cell_region_names(const FileMesh& mesh) {
  std::vector<std::string> names;
  for (const auto region : mesh.cell_regions) names.push_back(mesh.regions.at(static_cast<std::size_t>(region)).name);
  return names;
}

void expect_two_tets(const FileMesh& mesh, const std::string& lower, const std::string& upper,
                     const std::string& bottom) {
  expect_consistent(mesh);
  EXPECT_EQ(mesh.points, two_tets_points);
  EXPECT_EQ(mesh.cell_types, std::vector(2, fem::CellType::tet4));
  EXPECT_EQ(mesh.cell_offsets, (std::vector<Index>{0, 4, 8}));
  EXPECT_EQ(mesh.cell_vertices, two_tets_cells);
  EXPECT_EQ(cell_region_names(mesh), (std::vector{lower, upper}));
  ASSERT_TRUE(find_set(mesh, lower) && find_set(mesh, upper));
  EXPECT_EQ(find_set(mesh, lower)->vertices, (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(find_set(mesh, upper)->vertices, (std::vector<Index>{1, 2, 3, 4}));
  EXPECT_TRUE(find_set(mesh, lower)->faces.empty());
  if (bottom.empty()) return;
  ASSERT_TRUE(find_set(mesh, bottom));
  const auto& set = *find_set(mesh, bottom);
  EXPECT_EQ(set.vertices, (std::vector<Index>{0, 1, 2}));
  ASSERT_EQ(set.faces.size(), 1u);
  EXPECT_EQ(set.faces[0].type, fem::FaceType::tri3);
  EXPECT_EQ(std::vector<Index>(set.faces[0].vertices.begin(), set.faces[0].vertices.begin() + 3),
            (std::vector<Index>{0, 2, 1}));
}

void expect_consistent(const FileMesh& mesh) {
  const auto points = static_cast<Index>(mesh.points.size());
  const auto inside = [&](Index v) { return v >= 0 && v < points; };
  EXPECT_EQ(mesh.vertex_ids.size(), mesh.points.size());
  EXPECT_EQ(mesh.cell_ids.size(), mesh.cell_types.size());
  EXPECT_EQ(mesh.cell_regions.size(), mesh.cell_types.size());
  ASSERT_EQ(mesh.cell_offsets.size(), mesh.cell_types.size() + 1);
  EXPECT_FALSE(mesh.cell_types.empty());
  for (std::size_t c = 0; c < mesh.cell_types.size(); ++c) {
    EXPECT_EQ(mesh.cell_offsets[c + 1] - mesh.cell_offsets[c], fem::shape(mesh.cell_types[c]).vertices);
    EXPECT_TRUE(mesh.cell_regions[c] >= 0 && mesh.cell_regions[c] < static_cast<int>(mesh.regions.size()));
  }
  EXPECT_EQ(mesh.cell_offsets.back(), static_cast<Index>(mesh.cell_vertices.size()));
  EXPECT_TRUE(std::all_of(mesh.cell_vertices.begin(), mesh.cell_vertices.end(), inside));
  for (const auto& set : mesh.sets) {
    EXPECT_TRUE(std::all_of(set.vertices.begin(), set.vertices.end(), inside)) << set.name;
    EXPECT_TRUE(std::adjacent_find(set.vertices.begin(), set.vertices.end(), std::greater_equal<>()) ==
                set.vertices.end())
        << set.name << " is not ascending";
    for (const auto& face : set.faces) {
      for (int i = 0; i < fem::shape(face.type).vertices; ++i) {
        EXPECT_TRUE(std::binary_search(set.vertices.begin(), set.vertices.end(), face.vertices[i])) << set.name;
      }
    }
  }
}

std::string inp_with(const std::string& more) { return with(inp_text(), "*STEP\n", more + "*STEP\n"); }

}  // namespace ritz::readers::testing
