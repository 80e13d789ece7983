#include "ritz/stages/vertex_graph.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

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

}  // namespace ritz::stages
