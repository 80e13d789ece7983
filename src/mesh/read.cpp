#include "ritz/mesh/read.hpp"

#include <algorithm>

#include "ritz/base/error.hpp"
#include "ritz/mesh/quality.hpp"
#include "ritz/parallel/guard.hpp"

namespace ritz::mesh {
namespace {

void convert(FileMesh& mesh, const Units& units) {
  for (auto& point : mesh.points)
    for (double& x : point) x *= units.length;
  for (auto& region : mesh.regions) region.material = units.to_si(region.material);
}

FileMesh read_whole(const Source& source, const std::filesystem::path& path, Index& dropped) {
  FileMesh mesh = readers::read_file(path, source.ignored);
  for (const auto& list : source.vertex_lists)
    mesh.sets.push_back({list.string(), readers::read_bou(list, static_cast<Index>(mesh.points.size())), {}});
  dropped = drop_unused_vertices(mesh);
  convert(mesh, source.units);
  return mesh;
}

struct FileParts {
  Part part;
  Shared shared;
  std::vector<std::filesystem::path> files;
};

FileParts parts_of_file(MPI_Comm comm, const Source& source, const std::filesystem::path& path) {
  FileMesh mesh;
  Index dropped = 0;
  parallel::on_root(comm, [&] { mesh = read_whole(source, path, dropped); });
  auto [part, shared] = distribute(comm, mesh, source.partitioner);
  MPI_Bcast(&dropped, 1, MPI_INT64_T, 0, comm);
  shared.dropped_vertices = dropped;
  return {std::move(part), std::move(shared), std::move(mesh.files)};
}

}  // namespace

Mesh read(MPI_Comm comm, const Source& source) {
  Mesh mesh;
  if (const auto* box = std::get_if<Box>(&source.mesh)) {
    if (!source.vertex_lists.empty())
      throw InputError("option -fix " + source.vertex_lists.front().string() +
                       ": a list of vertices needs a mesh file; a box has the sets xmin xmax ymin ymax zmin zmax");
    Box si = *box;
    for (double& length : si.lengths) length *= source.units.length;
    auto [part, shared] = make_box(comm, si);
    mesh = number_part(comm, std::move(part), std::move(shared));
  } else {
    auto [part, shared, files] = parts_of_file(comm, source, std::get<std::filesystem::path>(source.mesh));
    mesh = number_part(comm, std::move(part), std::move(shared));
    mesh.files = std::move(files);
  }
  refuse_inverted_cells(mesh);
  return mesh;
}

}  // namespace ritz::mesh
