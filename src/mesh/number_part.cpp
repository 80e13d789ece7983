#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "ritz/base/random.hpp"
#include "ritz/mesh/part.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::mesh {
namespace {

/// Local numbers: owned vertices by file position, then ghosts by file position.
std::vector<std::size_t> local_order(const Part& part, int rank) {
  std::vector<std::size_t> order(part.positions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_partition(order.begin(), order.end(), [&](std::size_t v) { return part.owners[v] == rank; });
  return order;
}

/// Asks each ghost's owner for the ghost's global number.
void number_ghosts(Mesh& mesh, const std::vector<std::int32_t>& owners) {
  std::vector<std::vector<Index>> asked(static_cast<std::size_t>(parallel::size(mesh.comm)));
  for (auto v = static_cast<std::size_t>(mesh.owned); v < owners.size(); ++v)
    asked[static_cast<std::size_t>(owners[v])].push_back(mesh.file_positions[v]);
  auto answers = parallel::exchange(mesh.comm, asked);
  for (auto& list : answers)
    for (auto& position : list) {
      const auto end = mesh.file_positions.begin() + mesh.owned;
      position =
          mesh.first + (std::lower_bound(mesh.file_positions.begin(), end, position) - mesh.file_positions.begin());
    }
  answers = parallel::exchange(mesh.comm, answers);
  std::vector<std::size_t> next(answers.size(), 0);
  for (auto v = static_cast<std::size_t>(mesh.owned); v < owners.size(); ++v) {
    const auto p = static_cast<std::size_t>(owners[v]);
    mesh.global[v] = answers[p][next[p]++];
  }
}

std::uint64_t bits(double x) {
  std::uint64_t b = 0;
  std::memcpy(&b, &x, sizeof b);
  return b;
}

/// A sum of hashes over owned vertices and cells, so that the number of ranks does not matter.
std::uint64_t checksum(const Mesh& mesh) {
  std::uint64_t sum = 0;
  for (int v = 0; v < mesh.owned; ++v) {
    std::uint64_t h = static_cast<std::uint64_t>(mesh.file_positions[static_cast<std::size_t>(v)]);
    for (int d = 0; d < 3; ++d) h = split_mix(h ^ bits(mesh.points(d, v)));
    sum += h;
  }
  for (int c = 0; c < mesh.cells.owned; ++c) {
    const auto i = static_cast<std::size_t>(c);
    std::uint64_t h = split_mix(static_cast<std::uint64_t>(mesh.cells.numbers[i]) * 64 +
                                static_cast<std::uint64_t>(mesh.cells.types[i]));
    for (const int v : mesh.cells.of(c))
      h = split_mix(h ^ static_cast<std::uint64_t>(mesh.file_positions[static_cast<std::size_t>(v)]));
    sum += split_mix(h ^ static_cast<std::uint64_t>(mesh.cells.regions[i]));
  }
  return parallel::sum(mesh.comm, sum);
}

/// Looks up local numbers by file position.
class Lookup {
 public:
  explicit Lookup(const Mesh& mesh) : mesh_(mesh) {}
  int operator()(Index position) const {
    const auto& all = mesh_.file_positions;
    const auto ghosts = all.begin() + mesh_.owned;
    auto found = std::lower_bound(all.begin(), ghosts, position);
    if (found == ghosts || *found != position) found = std::lower_bound(ghosts, all.end(), position);
    return static_cast<int>(found - all.begin());
  }
  std::vector<int> operator()(const std::vector<Index>& positions) const {
    std::vector<int> local;
    local.reserve(positions.size());
    for (const Index p : positions) local.push_back((*this)(p));
    std::sort(local.begin(), local.end());
    return local;
  }

 private:
  const Mesh& mesh_;
};

Cells make_cells(Part& part, const Lookup& local) {
  Cells cells;
  cells.owned = static_cast<int>(part.owned_cells);
  cells.types = std::move(part.types);
  cells.regions = std::move(part.regions);
  cells.numbers = std::move(part.numbers);
  cells.ids = std::move(part.cell_ids);
  cells.offsets.reserve(cells.types.size() + 1);
  for (const auto type : cells.types) cells.offsets.push_back(cells.offsets.back() + fem::shape(type).vertices);
  cells.vertices.reserve(part.cell_vertices.size());
  for (const Index v : part.cell_vertices) cells.vertices.push_back(local(v));
  cells.file_order.resize(cells.numbers.size());
  std::iota(cells.file_order.begin(), cells.file_order.end(), 0);
  std::ranges::sort(cells.file_order, {}, [&](int c) { return cells.numbers[static_cast<std::size_t>(c)]; });
  return cells;
}

/// Where the file lists no faces, a set's surface is every boundary face whose vertices all belong to the set.
std::vector<CellFace> faces_within(const Mesh& mesh, const std::vector<int>& vertices) {
  std::vector<CellFace> inside;
  for (const CellFace face : mesh.boundary) {
    const auto corners = face_vertices(mesh, face);
    if (std::all_of(corners.begin(), corners.end(),
                    [&](int v) { return std::binary_search(vertices.begin(), vertices.end(), v); }))
      inside.push_back(face);
  }
  return inside;
}

Set make_set(const Mesh& mesh, const std::string& name, PartSet& from, const Lookup& local) {
  Set set{.name = name, .vertices = local(from.vertices), .faces = std::move(from.faces)};
  const bool listed = parallel::max(mesh.comm, static_cast<std::int32_t>(from.has_faces)) > 0;
  if (!listed) set.faces = faces_within(mesh, set.vertices);
  const auto owned = std::lower_bound(set.vertices.begin(), set.vertices.end(), mesh.owned) - set.vertices.begin();
  set.vertices_total = parallel::sum(mesh.comm, static_cast<Index>(owned));
  set.faces_total = parallel::sum(mesh.comm, static_cast<Index>(set.faces.size()));
  return set;
}

}  // namespace

Mesh number_part(MPI_Comm comm, Part part, Shared shared) {
  Mesh mesh;
  mesh.comm = comm;
  const auto order = local_order(part, parallel::rank(comm));
  const auto n = order.size();
  std::vector<std::int32_t> owners(n);
  mesh.points.resize(3, static_cast<Eigen::Index>(n));
  for (std::size_t v = 0; v < n; ++v) {
    const auto from = order[v];
    mesh.file_positions.push_back(part.positions[from]);
    mesh.ids.push_back(part.ids[from]);
    mesh.vertex_pieces.push_back(part.pieces[from]);
    owners[v] = part.owners[from];
    mesh.points.col(static_cast<Eigen::Index>(v)) = Eigen::Map<const Eigen::Vector3d>(&part.points[3 * from]);
  }
  mesh.owned = static_cast<int>(std::count(owners.begin(), owners.end(), parallel::rank(comm)));
  mesh.first = parallel::sum_before(comm, static_cast<Index>(mesh.owned));
  mesh.global.resize(n);
  std::iota(mesh.global.begin(), mesh.global.begin() + mesh.owned, mesh.first);
  number_ghosts(mesh, owners);
  mesh.halo = Halo(mesh);

  const Lookup local(mesh);
  mesh.cells = make_cells(part, local);
  mesh.boundary = std::move(part.boundary);
  mesh.vertices_total = shared.vertices_total;
  mesh.cells_total = shared.cells_total;
  mesh.dropped_vertices = shared.dropped_vertices;
  mesh.hanging_faces = shared.hanging_faces;
  mesh.regions = std::move(shared.regions);
  mesh.notes = std::move(shared.notes);
  mesh.pieces = shared.pieces;
  mesh.connected_parts = shared.connected_parts;
  mesh.joints = std::move(shared.joints);
  for (std::size_t s = 0; s < shared.set_names.size(); ++s)
    mesh.sets.push_back(make_set(mesh, shared.set_names[s], part.sets[s], local));
  for (const auto& support : part.supports) mesh.supports.push_back({local(support.vertices), support.held});
  mesh.checksum = checksum(mesh);
  return mesh;
}

Eigen::Matrix<double, 3, Eigen::Dynamic> Mesh::corners(int cell) const {
  const auto vertices = cells.of(cell);
  Eigen::Matrix<double, 3, Eigen::Dynamic> x(3, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t a = 0; a < vertices.size(); ++a) x.col(static_cast<Eigen::Index>(a)) = points.col(vertices[a]);
  return x;
}

const Set* Mesh::find(const std::string& name) const {
  const auto found = std::find_if(sets.begin(), sets.end(), [&](const Set& s) { return s.name == name; });
  return found == sets.end() ? nullptr : &*found;
}

std::vector<int> face_vertices(const Mesh& mesh, CellFace face) {
  const auto cell = mesh.cells.of(face.cell);
  std::vector<int> vertices;
  for (const int v : fem::face_vertices(mesh.cells.types[static_cast<std::size_t>(face.cell)], face.face))
    vertices.push_back(cell[static_cast<std::size_t>(v)]);
  return vertices;
}

}  // namespace ritz::mesh
