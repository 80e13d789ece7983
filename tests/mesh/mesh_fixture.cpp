#include "mesh/mesh_fixture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "ritz/mesh/part.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::mesh::testing {
namespace {

std::vector<Index> first_numbers(Index count) {
  std::vector<Index> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), Index{0});
  return numbers;
}

template <class T>
std::vector<T> head(const std::vector<T>& all, int count) {
  return {all.begin(), all.begin() + count};
}

std::vector<Index> sorted(std::vector<Index> values) {
  std::sort(values.begin(), values.end());
  return values;
}

/// The vertices of every cell of the mesh by the cell's number, from the ranks that own them.
std::map<Index, std::vector<Index>> all_cells(const Mesh& mesh) {
  std::vector<Index> words;
  for (int c = 0; c < mesh.cells.owned; ++c) {
    words.insert(words.end(), {mesh.cells.numbers[static_cast<std::size_t>(c)], std::ssize(mesh.cells.of(c))});
    for (const int v : mesh.cells.of(c)) words.push_back(mesh.file_positions[static_cast<std::size_t>(v)]);
  }
  words = parallel::gather_all(mesh.comm, words);
  std::map<Index, std::vector<Index>> cells;
  for (auto at = words.begin(); at != words.end(); at += 2 + at[1]) cells[at[0]] = {at + 2, at + 2 + at[1]};
  return cells;
}

void expect_cells(const Mesh& mesh) {
  const auto& cells = mesh.cells;
  const auto owned = parallel::gather_all(mesh.comm, head(cells.numbers, cells.owned));
  EXPECT_EQ(sorted(owned), first_numbers(mesh.cells_total));
  const std::set<Index> mine(mesh.file_positions.begin(), mesh.file_positions.begin() + mesh.owned);
  const auto numbers = head(cells.numbers, cells.owned);
  std::set<Index> expected(numbers.begin(), numbers.end());
  const auto all = all_cells(mesh);
  for (const auto& [number, vertices] : all)
    if (std::any_of(vertices.begin(), vertices.end(), [&](Index v) { return mine.contains(v); }))
      expected.insert(number);
  EXPECT_EQ(std::set<Index>(cells.numbers.begin(), cells.numbers.end()), expected);
  EXPECT_EQ(static_cast<std::size_t>(cells.count()), expected.size());
  for (int c = 0; c < cells.count(); ++c) {
    std::vector<Index> vertices;
    for (const int v : cells.of(c)) vertices.push_back(mesh.file_positions[static_cast<std::size_t>(v)]);
    EXPECT_EQ(vertices, all.at(cells.numbers[static_cast<std::size_t>(c)]));
  }
}

void expect_vertices(const Mesh& mesh) {
  const auto mine = head(mesh.file_positions, mesh.owned);
  EXPECT_TRUE(std::is_sorted(mine.begin(), mine.end()));
  EXPECT_EQ(sorted(parallel::gather_all(mesh.comm, mine)), first_numbers(mesh.vertices_total));
  EXPECT_EQ(mesh.first, parallel::sum_before(mesh.comm, Index{mesh.owned}));
  for (int v = 0; v < mesh.owned; ++v) EXPECT_EQ(mesh.global[static_cast<std::size_t>(v)], mesh.first + v);
  std::set<int> used(mesh.cells.vertices.begin(), mesh.cells.vertices.end());
  EXPECT_EQ(static_cast<int>(used.size()), mesh.local_vertices());
  expect_agreement(mesh.file_positions, mesh.global);
  expect_agreement(mesh.file_positions, mesh.ids);
}

}  // namespace

Mesh box_mesh(const std::string& text, MPI_Comm comm) {
  auto [part, shared] = make_box(comm, parse_box(text));
  return number_part(comm, std::move(part), std::move(shared));
}

FileMesh file_of_box(const std::string& text) {
  const auto [part, shared] = make_box(MPI_COMM_SELF, parse_box(text));
  FileMesh mesh;
  mesh.vertex_ids = part.ids;
  for (std::size_t v = 0; v < part.ids.size(); ++v)
    mesh.points.push_back({part.points[3 * v], part.points[3 * v + 1], part.points[3 * v + 2]});
  mesh.cell_types = part.types;
  mesh.cell_ids = part.cell_ids;
  mesh.cell_vertices = part.cell_vertices;
  mesh.cell_regions = part.regions;
  for (const auto type : part.types) mesh.cell_offsets.push_back(mesh.cell_offsets.back() + fem::shape(type).vertices);
  mesh.regions = shared.regions;
  for (std::size_t s = 0; s < part.sets.size(); ++s) {
    NamedSet set{shared.set_names[s], part.sets[s].vertices, {}};
    for (const auto& [cell, face] : part.sets[s].faces) {
      const auto type = part.types[static_cast<std::size_t>(cell)];
      const auto& side = fem::side(type, face);
      FaceCell listed{side.type, {}};
      const auto local = side.vertices();
      for (std::size_t v = 0; v < local.size(); ++v)
        listed.vertices[v] =
            mesh.cell_vertices[static_cast<std::size_t>(mesh.cell_offsets[static_cast<std::size_t>(cell)] + local[v])];
      set.faces.push_back(listed);
    }
    mesh.sets.push_back(std::move(set));
  }
  return mesh;
}

FileMesh tetrahedra(const std::vector<std::array<double, 3>>& points, const std::vector<std::array<Index, 4>>& cells) {
  FileMesh mesh;
  mesh.points = points;
  mesh.regions = {{"body", std::nullopt}};
  for (std::size_t v = 0; v < points.size(); ++v) mesh.vertex_ids.push_back(static_cast<Index>(v) + 1);
  for (const auto& cell : cells) {
    mesh.cell_vertices.insert(mesh.cell_vertices.end(), cell.begin(), cell.end());
    mesh.cell_offsets.push_back(mesh.cell_offsets.back() + 4);
    mesh.cell_types.push_back(fem::CellType::tet4);
    mesh.cell_ids.push_back(std::ssize(mesh.cell_types));
    mesh.cell_regions.push_back(0);
  }
  return mesh;
}

Mesh distributed(const FileMesh& mesh, Partitioner partitioner) {
  const bool root = parallel::rank(world) == 0;  // only rank 0's mesh may be looked at
  auto [part, shared] = distribute(world, root ? mesh : FileMesh{}, partitioner);
  return number_part(world, std::move(part), std::move(shared));
}

void expect_sound(const Mesh& mesh) {
  expect_vertices(mesh);
  expect_cells(mesh);
}

void expect_agreement(const std::vector<Index>& positions, const std::vector<Index>& values) {
  const auto all_positions = parallel::gather_all(world, positions), all_values = parallel::gather_all(world, values);
  std::map<Index, Index> known;
  for (std::size_t i = 0; i < all_positions.size(); ++i) {
    const auto [place, fresh] = known.try_emplace(all_positions[i], all_values[i]);
    EXPECT_EQ(place->second, all_values[i]) << "position " << all_positions[i];
  }
}

}  // namespace ritz::mesh::testing
