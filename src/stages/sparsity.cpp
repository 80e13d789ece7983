#include "ritz/stages/sparsity.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "ritz/algebra/check.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::stages {

std::size_t VertexGraph::place(const std::vector<mesh::Index>& global, int row, int column) const {
  const auto r = static_cast<std::size_t>(row);
  const auto begin = columns.begin() + static_cast<std::ptrdiff_t>(starts[r]);
  const auto end = columns.begin() + static_cast<std::ptrdiff_t>(starts[r + 1]);
  const auto wanted = global[static_cast<std::size_t>(column)];
  const auto found = std::lower_bound(
      begin, end, wanted, [&](int v, mesh::Index number) { return global[static_cast<std::size_t>(v)] < number; });
  return static_cast<std::size_t>(found - columns.begin());
}

CellsOfVertices cells_of_vertices(const mesh::Mesh& mesh) {
  CellsOfVertices around;
  around.starts.assign(static_cast<std::size_t>(mesh.local_vertices()) + 1, 0);
  for (const int v : mesh.cells.vertices) ++around.starts[static_cast<std::size_t>(v) + 1];
  std::partial_sum(around.starts.begin(), around.starts.end(), around.starts.begin());
  around.cells.resize(mesh.cells.vertices.size());
  auto next = around.starts;
  for (const int c : mesh.cells.file_order)
    for (const int v : mesh.cells.of(c)) around.cells[next[static_cast<std::size_t>(v)]++] = c;
  return around;
}

VertexGraph vertex_graph(const mesh::Mesh& mesh) {
  const CellsOfVertices around = cells_of_vertices(mesh);
  VertexGraph graph;
  std::vector<int> seen_by(static_cast<std::size_t>(mesh.local_vertices()), -1);
  for (int row = 0; row < mesh.owned; ++row) {
    const auto begin = static_cast<std::ptrdiff_t>(graph.columns.size());
    for (auto i = around.starts[static_cast<std::size_t>(row)]; i < around.starts[static_cast<std::size_t>(row) + 1];
         ++i)
      for (const int v : mesh.cells.of(around.cells[i]))
        if (std::exchange(seen_by[static_cast<std::size_t>(v)], row) != row) graph.columns.push_back(v);
    std::sort(graph.columns.begin() + begin, graph.columns.end(), [&](int a, int b) {
      return mesh.global[static_cast<std::size_t>(a)] < mesh.global[static_cast<std::size_t>(b)];
    });
    graph.starts.push_back(graph.columns.size());
  }
  return graph;
}

namespace {

void append(std::vector<PetscInt>& to, const std::vector<PetscInt>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// What the rows of a vertex have in common: their columns, and where each neighbour's begin.
algebra::Rows columns_of(const mesh::Mesh& mesh, const mesh::Dofs& dofs, int row, BlockPattern& pattern) {
  algebra::Rows shared;
  for (auto p = pattern.graph.starts[static_cast<std::size_t>(row)];
       p < pattern.graph.starts[static_cast<std::size_t>(row) + 1]; ++p) {
    const int column = pattern.graph.columns[p];
    auto& columns = part(shared, mesh, column).columns;
    pattern.offsets.push_back(static_cast<PetscInt>(columns.size()));
    const mesh::Index origin = column < mesh.owned ? dofs.first : 0;
    for (int j = 0; j < mesh::components; ++j)
      if (!dofs.fixed(column, j)) columns.push_back(static_cast<PetscInt>(dofs.number(column, j) - origin));
  }
  return shared;
}

}  // namespace

algebra::Csr& part(algebra::Rows& rows, const mesh::Mesh& mesh, int column) {
  return column < mesh.owned ? rows.own : rows.other;
}

BlockRows empty_rows(const mesh::Mesh& mesh, const mesh::Dofs& dofs) {
  BlockRows blocks;
  auto& [pattern, rows] = blocks;
  pattern.graph = vertex_graph(mesh);
  const auto entries = parallel::max(mesh.comm, 9 * static_cast<std::int64_t>(pattern.graph.columns.size()));
  algebra::refuse_beyond_index("a rank holds " + std::to_string(entries) + " entries of K (more ranks hold fewer each)",
                               entries);
  pattern.offsets.reserve(pattern.graph.columns.size());
  rows.own.columns.reserve(9 * pattern.graph.columns.size());
  for (int row = 0; row < mesh.owned; ++row) {
    const algebra::Rows shared = columns_of(mesh, dofs, row, pattern);
    for (int i = 0; i < mesh::components; ++i) {
      if (dofs.fixed(row, i)) continue;
      append(rows.own.columns, shared.own.columns);
      append(rows.other.columns, shared.other.columns);
      for (algebra::Csr* part : {&rows.own, &rows.other})
        part->starts.push_back(static_cast<PetscInt>(part->columns.size()));
    }
  }
  for (algebra::Csr* part : {&rows.own, &rows.other}) part->values.assign(part->columns.size(), 0);
  return blocks;
}

void add_block(algebra::Rows& rows, const BlockPattern& pattern, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
               std::size_t place, int row, int column, const Eigen::Matrix3d& block) {
  algebra::Csr& to = part(rows, mesh, column);
  for (int i = 0; i < mesh::components; ++i) {
    if (dofs.fixed(row, i)) continue;
    const auto local = static_cast<std::size_t>(dofs.number(row, i) - dofs.first);
    auto at = static_cast<std::size_t>(to.starts[local] + pattern.offsets[place]);
    for (int j = 0; j < mesh::components; ++j)
      if (!dofs.fixed(column, j)) to.values[at++] += block(i, j);
  }
}

}  // namespace ritz::stages
