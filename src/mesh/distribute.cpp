#include "ritz/mesh/part.hpp"

#include <algorithm>
#include <limits>

#include "ritz/mesh/topology.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/parallel/guard.hpp"

namespace ritz::mesh {
namespace {

/// A vertex belongs to the lowest rank that owns one of its cells.
std::vector<std::int32_t> vertex_owners(const FileMesh& mesh, const std::vector<std::int32_t>& cell_owners) {
  std::vector<std::int32_t> owners(mesh.points.size(), std::numeric_limits<std::int32_t>::max());
  for (std::size_t c = 0; c < cell_owners.size(); ++c)
    for (Index i = mesh.cell_offsets[c]; i < mesh.cell_offsets[c + 1]; ++i) {
      auto& owner = owners[static_cast<std::size_t>(mesh.cell_vertices[static_cast<std::size_t>(i)])];
      owner = std::min(owner, cell_owners[c]);
    }
  return owners;
}

/// Cuts the whole mesh into parts, one rank after another.
class Cutter {
 public:
  Cutter(const FileMesh& mesh, const Topology& topology, const std::vector<std::int32_t>& cell_owners)
      : mesh_(mesh),
        topology_(topology),
        cell_owners_(cell_owners),
        owners_(vertex_owners(mesh, cell_owners)),
        local_cell_(mesh.cell_types.size(), -1),
        local_(mesh.points.size(), 0) {}

  Part cut(int rank) {
    Part part;
    for (std::size_t c = 0; c < cell_owners_.size(); ++c)
      if (cell_owners_[c] == rank) add_cell(part, c);
    part.owned_cells = static_cast<Index>(part.types.size());
    for (std::size_t c = 0; c < cell_owners_.size(); ++c)
      if (cell_owners_[c] != rank && touches(c, rank)) add_cell(part, c);
    add_vertices(part);
    add_faces(part, rank);
    for (const auto& support : mesh_.supports) part.supports.push_back({present(support.vertices), support.held});
    for (const Index v : part.positions) local_[static_cast<std::size_t>(v)] = 0;
    return part;
  }

 private:
  bool touches(std::size_t c, int rank) const {
    for (Index i = mesh_.cell_offsets[c]; i < mesh_.cell_offsets[c + 1]; ++i)
      if (owners_[static_cast<std::size_t>(mesh_.cell_vertices[static_cast<std::size_t>(i)])] == rank) return true;
    return false;
  }

  void add_cell(Part& part, std::size_t c) {
    local_cell_[c] = static_cast<int>(part.types.size());
    part.types.push_back(mesh_.cell_types[c]);
    part.numbers.push_back(static_cast<Index>(c));
    part.cell_ids.push_back(mesh_.cell_ids[c]);
    part.regions.push_back(mesh_.cell_regions[c]);
    part.cell_vertices.insert(part.cell_vertices.end(), mesh_.cell_vertices.begin() + mesh_.cell_offsets[c],
                              mesh_.cell_vertices.begin() + mesh_.cell_offsets[c + 1]);
  }

  void add_vertices(Part& part) {
    for (const Index v : part.cell_vertices) local_[static_cast<std::size_t>(v)] = 1;
    for (std::size_t v = 0; v < local_.size(); ++v) {
      if (!local_[v]) continue;
      part.positions.push_back(static_cast<Index>(v));
      part.ids.push_back(mesh_.vertex_ids[v]);
      part.owners.push_back(owners_[v]);
      part.pieces.push_back(topology_.vertex_pieces[v]);
      part.points.insert(part.points.end(), mesh_.points[v].begin(), mesh_.points[v].end());
    }
  }

  std::vector<CellFace> owned_faces(const std::vector<CellFace>& faces, int rank) const {
    std::vector<CellFace> local;
    for (const auto& f : faces)
      if (cell_owners_[static_cast<std::size_t>(f.cell)] == rank)
        local.push_back({local_cell_[static_cast<std::size_t>(f.cell)], f.face});
    return local;
  }

  void add_faces(Part& part, int rank) const {
    part.boundary = owned_faces(topology_.boundary, rank);
    for (std::size_t s = 0; s < mesh_.sets.size(); ++s)
      part.sets.push_back(
          {present(mesh_.sets[s].vertices), owned_faces(topology_.set_faces[s], rank), !mesh_.sets[s].faces.empty()});
  }

  std::vector<Index> present(const std::vector<Index>& vertices) const {
    std::vector<Index> here;
    for (const Index v : vertices)
      if (local_[static_cast<std::size_t>(v)]) here.push_back(v);
    return here;
  }

  const FileMesh& mesh_;
  const Topology& topology_;
  const std::vector<std::int32_t>& cell_owners_;
  std::vector<std::int32_t> owners_;
  std::vector<int> local_cell_;
  std::vector<std::uint8_t> local_;  ///< 1 for the vertices of the part being cut
};

}  // namespace

std::pair<Part, Shared> distribute(MPI_Comm comm, const FileMesh& mesh, Partitioner partitioner) {
  Topology topology;
  Shared shared;
  std::vector<std::int32_t> owners;
  const int ranks = parallel::size(comm);
  parallel::on_root(comm, [&] {
    topology = find_topology(mesh);
    shared.vertices_total = static_cast<Index>(mesh.points.size());
    shared.cells_total = static_cast<Index>(mesh.cell_types.size());
    shared.regions = mesh.regions;
    for (const auto& set : mesh.sets) shared.set_names.push_back(set.name);
    shared.pieces = topology.pieces;
    shared.connected_parts = topology.connected_parts;
    shared.hanging_faces = topology.hanging_faces;
    shared.joints = topology.joints;
    shared.notes = mesh.notes;
    if (partitioner == Partitioner::metis)
      owners = partition_metis(static_cast<Index>(mesh.cell_types.size()), topology.neighbours, ranks);
  });
  if (partitioner == Partitioner::ptscotch)
    owners = partition_ptscotch(comm, static_cast<Index>(mesh.cell_types.size()), topology.neighbours);
  broadcast_shared(comm, shared);

  if (parallel::rank(comm) != 0) return {receive_part(comm), std::move(shared)};
  Cutter cutter(mesh, topology, owners);
  for (int p = 1; p < ranks; ++p) send_part(comm, cutter.cut(p), p);
  return {cutter.cut(0), std::move(shared)};
}

Index drop_unused_vertices(FileMesh& mesh) {
  std::vector<Index> renumber(mesh.points.size(), -1);
  for (const Index v : mesh.cell_vertices) renumber[static_cast<std::size_t>(v)] = 0;
  Index used = 0;
  for (std::size_t v = 0; v < renumber.size(); ++v) {
    if (renumber[v] < 0) continue;
    renumber[v] = used;
    mesh.points[static_cast<std::size_t>(used)] = mesh.points[v];
    mesh.vertex_ids[static_cast<std::size_t>(used)] = mesh.vertex_ids[v];
    ++used;
  }
  const Index dropped = static_cast<Index>(renumber.size()) - used;
  if (dropped == 0) return 0;
  mesh.points.resize(static_cast<std::size_t>(used));
  mesh.vertex_ids.resize(static_cast<std::size_t>(used));
  const auto update = [&](std::vector<Index>& vertices) {
    for (auto& v : vertices) v = renumber[static_cast<std::size_t>(v)];
    std::erase(vertices, Index{-1});
  };
  update(mesh.cell_vertices);
  for (auto& set : mesh.sets) {
    update(set.vertices);
    for (auto& face : set.faces)
      for (int i = 0; i < fem::shape(face.type).vertices; ++i) {
        auto& v = face.vertices[static_cast<std::size_t>(i)];
        v = renumber[static_cast<std::size_t>(v)];
      }
  }
  for (auto& support : mesh.supports) update(support.vertices);
  return dropped;
}

}  // namespace ritz::mesh
