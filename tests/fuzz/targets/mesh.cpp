// A mesh file of the format that RITZ_FUZZ_MESH names by its ending: refused, or a mesh in which every number is in
// range. What a refusal offers to ignore is ignored, as a user would, and must then be no reason any more.
#include <algorithm>
#include <cmath>
#include <string_view>

#include "fuzz/target.hpp"
#include "ritz/base/error.hpp"
#include "ritz/readers/file_mesh.hpp"

namespace ritz::fuzz {
namespace {

using readers::Index;

void require(bool holds, const char* what) {
  if (!holds) finding(what);
}

bool in_range(const std::vector<Index>& numbers, std::size_t count) {
  return std::all_of(numbers.begin(), numbers.end(), [&](Index i) { return i >= 0 && i < static_cast<Index>(count); });
}

void check_cells(const readers::FileMesh& mesh) {
  const auto cells = mesh.cell_types.size();
  require(cells > 0, "a mesh without cells");
  require(mesh.cell_ids.size() == cells && mesh.cell_regions.size() == cells, "a property of cells has another length");
  require(mesh.cell_offsets.size() == cells + 1 && mesh.cell_offsets.front() == 0 &&
              mesh.cell_offsets.back() == static_cast<Index>(mesh.cell_vertices.size()) &&
              std::is_sorted(mesh.cell_offsets.begin(), mesh.cell_offsets.end()),
          "offsets of cells that are none");
  require(in_range(mesh.cell_vertices, mesh.points.size()), "a cell with a vertex that there is not");
  for (const auto region : mesh.cell_regions)
    require(region >= 0 && static_cast<std::size_t>(region) < mesh.regions.size(),
            "a cell with a region that there is not");
}

void check_points(const readers::FileMesh& mesh) {
  require(mesh.vertex_ids.size() == mesh.points.size(), "as many numbers as points");
  for (const auto& point : mesh.points)
    for (const double x : point) require(std::isfinite(x), "a coordinate that is not finite");
}

void check_sets(const readers::FileMesh& mesh) {
  for (const auto& set : mesh.sets) {
    require(in_range(set.vertices, mesh.points.size()), "a set with a vertex that there is not");
    require(std::adjacent_find(set.vertices.begin(), set.vertices.end(), std::greater_equal<>()) == set.vertices.end(),
            "a set whose vertices do not ascend");
  }
  for (const auto& support : mesh.supports)
    require(in_range(support.vertices, mesh.points.size()), "a support of a vertex that there is not");
}

/// The word of "'-ignore WORD' leaves it out" or "'-ignore WORD' reads it as", where a user could type it. A keyword
/// that has a quote in it is none.
std::string offered(const std::string& refusal) {
  constexpr std::string_view before = "'-ignore ";
  const auto found = refusal.find(before);
  if (found == refusal.npos) return {};
  const auto begin = found + before.size(), end = refusal.find('\'', begin);
  if (end == refusal.npos) return {};
  const auto after = std::string_view(refusal).substr(end + 1);
  if (!after.starts_with(" leaves it out") && !after.starts_with(" reads it as")) return {};
  const auto word = refusal.substr(begin, end - begin);
  return word.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") == word.npos ? word : "";
}

readers::FileMesh read(const std::filesystem::path& path) {
  constexpr std::size_t most = 8;
  readers::Ignored ignored;
  for (;;) {
    try {
      return readers::read_file(path, ignored);
    } catch (const InputError& error) {
      const auto word = offered(error.what());
      if (word.empty() || ignored.size() == most) throw;
      require(std::ranges::find(ignored, word) == ignored.end(), "-ignore does not help as was said");
      ignored.push_back(word);
    }
  }
}

}  // namespace

void read_input(Bytes input) {
  const auto mesh = read(as_file(input, "mesh" RITZ_FUZZ_MESH));
  for (const auto& note : mesh.notes) require(!note.empty(), "a note that says nothing");
  check_points(mesh);
  check_cells(mesh);
  check_sets(mesh);
}

}  // namespace ritz::fuzz
