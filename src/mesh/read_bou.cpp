#include <algorithm>

#include "ritz/mesh/read_source.hpp"

namespace ritz::mesh {

std::vector<Index> read_bou(const std::filesystem::path& path, Index vertex_count) {
  Sources sources;
  Cursor cursor(sources, open(sources, path));
  std::vector<Index> vertices;
  for (cursor.skip_space(); !cursor.at_end(); cursor.skip_space()) {
    const auto place = cursor.place();
    const Index number = cursor.integer("a vertex number");
    if (number < 1 || number > vertex_count) {
      fail(sources, place,
           "vertex " + std::to_string(number) + " does not exist; the mesh has vertices 1 to " +
               std::to_string(vertex_count));
    }
    vertices.push_back(number - 1);
  }
  if (vertices.empty()) fail(sources, "the file lists no vertices");
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace ritz::mesh
