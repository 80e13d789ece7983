#include "ritz/base/error.hpp"
#include "ritz/mesh/file_mesh.hpp"
#include "ritz/mesh/read_inp.hpp"
#include "ritz/mesh/read_msh.hpp"
#include "ritz/mesh/read_veg.hpp"
#include "ritz/mesh/read_vtu.hpp"

namespace ritz::mesh {
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

}  // namespace ritz::mesh
