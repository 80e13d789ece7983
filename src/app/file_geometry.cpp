#include "ritz/app/file_geometry.hpp"

#include <algorithm>

#include "ritz/algebra/multivector.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::app {
namespace {

using std::int64_t;

constexpr int faces_a_cell = 8;  ///< room for a cell's face numbers in a key
constexpr int cell_width = 2 + fem::max_cell_vertices;

/// 1 for every owned vertex that is stored.
std::vector<std::uint8_t> stored(const mesh::Mesh& mesh, config::StoredRows rows) {
  std::vector<std::uint8_t> keep(static_cast<std::size_t>(mesh.owned), 1);
  if (rows == config::StoredRows::all) return keep;
  std::vector<int64_t> touched;
  for (const auto face : mesh.boundary)
    for (const int v : mesh::face_vertices(mesh, face)) touched.push_back(mesh.global[static_cast<std::size_t>(v)]);
  const algebra::Tall ones = algebra::Tall::Ones(static_cast<Eigen::Index>(touched.size()), 1);
  const algebra::Tall counts = algebra::accumulate(mesh.comm, touched, ones, mesh.owned);
  for (int v = 0; v < mesh.owned; ++v) keep[static_cast<std::size_t>(v)] = counts(v, 0) > 0;
  return keep;
}

/// Stored rows by file position: the ascending list of stored positions, the same on all ranks.
std::vector<int64_t> stored_positions(const mesh::Mesh& mesh, const std::vector<std::uint8_t>& keep) {
  std::vector<int64_t> mine;
  for (std::size_t v = 0; v < keep.size(); ++v)
    if (keep[v]) mine.push_back(mesh.file_positions[v]);
  auto all = parallel::gather_all(mesh.comm, mine);
  std::sort(all.begin(), all.end());
  return all;
}

int64_t row_of(const std::vector<int64_t>& positions, int64_t position) {
  const auto found = std::lower_bound(positions.begin(), positions.end(), position);
  return found != positions.end() && *found == position ? found - positions.begin() : -1;
}

/// Cells to draw as rows [VTK type, count, vertices ...] with their keys in the file's order.
struct Drawn {
  std::vector<int64_t> keys, rows;

  void add(int64_t key, int vtk, const std::vector<int64_t>& vertices) {
    keys.push_back(key);
    const auto start = rows.size();
    rows.resize(start + cell_width, -1);
    rows[start] = vtk;
    rows[start + 1] = static_cast<int64_t>(vertices.size());
    std::copy(vertices.begin(), vertices.end(), rows.begin() + static_cast<std::ptrdiff_t>(start) + 2);
  }
};

Drawn drawn_cells(const mesh::Mesh& mesh, const std::vector<int64_t>& positions, config::StoredRows rows) {
  Drawn drawn;
  const auto rows_of = [&](auto&& vertices) {
    std::vector<int64_t> list;
    for (const int v : vertices) list.push_back(row_of(positions, mesh.file_positions[static_cast<std::size_t>(v)]));
    return list;
  };
  if (rows == config::StoredRows::all) {
    for (int c = 0; c < mesh.cells.owned; ++c)
      drawn.add(mesh.cells.numbers[static_cast<std::size_t>(c)] * faces_a_cell,
                fem::shape(mesh.cells.types[static_cast<std::size_t>(c)]).vtk, rows_of(mesh.cells.of(c)));
    return drawn;
  }
  for (const auto face : mesh.boundary) {
    const auto c = static_cast<std::size_t>(face.cell);
    drawn.add(mesh.cells.numbers[c] * faces_a_cell + face.face,
              fem::shape(fem::side(mesh.cells.types[c], face.face).type).vtk, rows_of(mesh::face_vertices(mesh, face)));
  }
  return drawn;
}

void add_cells(const mesh::Mesh& mesh, const Drawn& drawn, FileGeometry& order) {
  const auto rows =
      parallel::sorted_by_key(mesh.comm, drawn.keys, drawn.rows, cell_width, mesh.cells_total * faces_a_cell);
  auto& cells = order.geometry.cells;
  cells.offsets = {0};
  for (std::size_t start = 0; start < rows.size(); start += cell_width) {
    const auto first = rows.begin() + static_cast<std::ptrdiff_t>(start) + 2;
    cells.vtk_types.push_back(static_cast<std::uint8_t>(rows[start]));
    cells.vertices.insert(cells.vertices.end(), first, first + rows[start + 1]);
    cells.offsets.push_back(static_cast<int64_t>(cells.vertices.size()));
  }
  const auto place = [&](std::size_t count) {
    const auto n = static_cast<int64_t>(count);
    return format::Slice{parallel::sum_before(mesh.comm, n), parallel::sum(mesh.comm, n)};
  };
  order.slices.cells = place(cells.vtk_types.size());
  order.slices.cell_vertices = place(cells.vertices.size());
}

std::vector<model::VertexSet> vertex_sets(const mesh::Mesh& mesh, const std::vector<int64_t>& positions) {
  std::vector<model::VertexSet> sets;
  for (const auto& set : mesh.sets) {
    std::vector<int64_t> rows;
    for (const int v : set.vertices) {
      if (v >= mesh.owned) break;
      const int64_t row = row_of(positions, mesh.file_positions[static_cast<std::size_t>(v)]);
      if (row >= 0) rows.push_back(row);
    }
    rows = parallel::gather_all(mesh.comm, rows);
    std::sort(rows.begin(), rows.end());
    sets.push_back({set.name, std::move(rows), set.vertices_total});
  }
  return sets;
}

/// Owned vertices that are stored, and their rows.
struct Stored {
  std::vector<std::size_t> vertices;
  std::vector<int64_t> rows;
};

Stored stored_of(const std::vector<int64_t>& row_of_owned) {
  Stored stored;
  for (std::size_t v = 0; v < row_of_owned.size(); ++v) {
    if (row_of_owned[v] < 0) continue;
    stored.vertices.push_back(v);
    stored.rows.push_back(row_of_owned[v]);
  }
  return stored;
}

}  // namespace

parallel::RowMatrix FileGeometry::to_file(MPI_Comm comm, const parallel::RowMatrix& owned) const {
  const Stored stored = stored_of(row_of_owned);
  return parallel::to_slices(comm, stored.rows, owned(stored.vertices, Eigen::all), slices.vertices.total);
}

std::vector<int64_t> FileGeometry::to_file(MPI_Comm comm, std::span<const int64_t> owned) const {
  const Stored stored = stored_of(row_of_owned);
  std::vector<int64_t> kept;
  for (const auto v : stored.vertices) kept.push_back(owned[v]);
  return parallel::sorted_by_key(comm, stored.rows, kept, 1, slices.vertices.total);
}

parallel::RowMatrix by_vertex(mesh::VertexRef u) {
  return Eigen::Map<const parallel::RowMatrix>(u.data(), u.rows() / mesh::components, mesh::components);
}

std::vector<model::RegionMaterial> named_materials(const mesh::Mesh& mesh, const fem::Materials& materials) {
  std::vector<model::RegionMaterial> named;
  for (std::size_t r = 0; r < materials.size(); ++r) named.push_back({mesh.regions[r].name, materials[r]});
  return named;
}

FileGeometry file_geometry(const mesh::Mesh& mesh, const fem::Materials& materials, config::StoredRows rows) {
  FileGeometry order;
  const auto keep = stored(mesh, rows);
  const auto positions = stored_positions(mesh, keep);
  for (std::size_t v = 0; v < keep.size(); ++v)
    order.row_of_owned.push_back(keep[v] ? row_of(positions, mesh.file_positions[v]) : -1);
  const auto slice = parallel::even_slice(mesh.comm, static_cast<int64_t>(positions.size()));
  order.slices.vertices = {slice.first, slice.total};

  auto& geometry = order.geometry;
  geometry.rows = rows == config::StoredRows::all ? model::Rows::all : model::Rows::surface;
  geometry.full_vertices = mesh.vertices_total;
  geometry.points = order.to_file(mesh.comm, mesh.points.leftCols(mesh.owned).transpose());
  geometry.vertex_ids = order.to_file(mesh.comm, std::span<const int64_t>(mesh.ids).first(keep.size()));
  add_cells(mesh, drawn_cells(mesh, positions, rows), order);
  geometry.sets = vertex_sets(mesh, positions);
  geometry.materials = named_materials(mesh, materials);
  return order;
}

}  // namespace ritz::app
