#include "ritz/readers/file_mesh.hpp"

#include <algorithm>

#include "ritz/base/error.hpp"
#include "ritz/readers/formats.hpp"
#include "ritz/readers/source.hpp"

namespace ritz::readers {

namespace {

using Reader = FileMesh (*)(Sources&, unsigned, const Ignored&);

Reader reader_of(const std::filesystem::path& path) {
  const auto ending = upper(path.extension().string());
  if (ending == ".MSH") return read_msh;
  if (ending == ".VEG") return read_veg;
  if (ending == ".INP") return read_inp;
  if (ending == ".VTU") return read_vtu;
  throw InputError(path.string() + ": the ending tells no mesh format; ritz reads .msh (Gmsh 2.2, 4.1), .veg (Vega), " +
                   ".inp (Abaqus, CalculiX) and .vtu (VTK)");
}

}  // namespace

FileMesh read_file(const std::filesystem::path& path, const Ignored& ignored) {
  const auto reader = reader_of(path);
  Sources sources;
  auto mesh = reader(sources, open(sources, path), ignored);
  for (const auto& source : sources) mesh.files.push_back(source.path);
  return mesh;
}

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

}  // namespace ritz::readers
