#include "ritz/mesh/p_refinement.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "ritz/algebra/check.hpp"
#include "ritz/mesh/part.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::mesh {
namespace {

constexpr std::optional<fem::CellType> quadratic_type(fem::CellType linear) {
  for (const auto type : fem::cell_types)
    if (fem::shape(type).quadratic() && fem::shape(type).linear == linear) return type;
  return std::nullopt;
}

/// Two local vertices of the linear mesh, the one that comes first in the file before the other.
using Ends = std::array<int, 2>;

/// Numbers vertices of the quadratic mesh without communication: corner a is (a, a), the middle of a and b (a, b), by
/// their positions in the file, which are then those of one long row.
class Naming {
 public:
  explicit Naming(const Mesh& linear) : linear_(linear) {}

  Ends ordered(int a, int b) const { return position(a) < position(b) ? Ends{a, b} : Ends{b, a}; }
  Index operator()(const Ends& ends) const { return position(ends[0]) * linear_.vertices_total + position(ends[1]); }

 private:
  Index position(int v) const { return linear_.file_positions[static_cast<std::size_t>(v)]; }
  const Mesh& linear_;
};

std::vector<std::int32_t> owners(const Mesh& mesh) {
  const auto firsts = parallel::gather_all(mesh.comm, std::vector<Index>{mesh.first});
  std::vector<std::int32_t> ranks;
  for (const Index global : mesh.global)
    ranks.push_back(static_cast<std::int32_t>(std::ranges::upper_bound(firsts, global) - firsts.begin() - 1));
  return ranks;
}

void add_cells(const Mesh& linear, const Naming& name, Part& part, std::map<Index, Ends>& vertices) {
  const Cells& cells = linear.cells;
  part.owned_cells = cells.owned;
  part.numbers = cells.numbers;
  part.cell_ids = cells.ids;
  part.regions = cells.regions;
  part.boundary = linear.boundary;
  for (int c = 0; c < cells.count(); ++c) {
    const auto type = *quadratic_type(cells.types[static_cast<std::size_t>(c)]);
    const auto corners = cells.of(c);
    part.types.push_back(type);
    const auto add = [&](const Ends& ends) {
      part.cell_vertices.push_back(name(ends));
      vertices.emplace(part.cell_vertices.back(), ends);
    };
    for (const int v : corners) add({v, v});
    for (const auto& [i, j] : fem::shape(type).edges)
      add(name.ordered(corners[static_cast<std::size_t>(i)], corners[static_cast<std::size_t>(j)]));
  }
}

/// A vertex belongs to the rank of its first end, in whose halo all cells around it are.
void add_vertices(const Mesh& linear, const std::map<Index, Ends>& vertices, Part& part) {
  const auto ranks = owners(linear);
  for (const auto& [position, ends] : vertices) {
    const auto first = static_cast<std::size_t>(ends[0]);
    part.positions.push_back(position);
    part.ids.push_back(position);
    part.owners.push_back(ranks[first]);
    part.pieces.push_back(linear.vertex_pieces[first]);
    const Eigen::Vector3d middle = (linear.points.col(ends[0]) + linear.points.col(ends[1])) / 2;
    part.points.insert(part.points.end(), middle.begin(), middle.end());
  }
}

/// 1 for each component of a vertex that is fixed at all corners of a face there.
struct OnFixedFaces {
  LocalRows linear;               ///< of the corners
  std::vector<std::uint8_t> mid;  ///< of owned vertices of the quadratic mesh
};

OnFixedFaces on_fixed_faces(const Mesh& linear, const Dofs& dofs, const Mesh& quadratic) {
  VertexRows corners = VertexRows::Zero(components * linear.owned, 1);
  OnFixedFaces on{{}, std::vector<std::uint8_t>(components * static_cast<std::size_t>(quadratic.owned), 0)};
  for (int c = 0; c < linear.cells.count(); ++c) {
    const auto of_linear = linear.cells.of(c), of_quadratic = quadratic.cells.of(c);
    for (const auto& side : fem::shape(quadratic.cells.types[static_cast<std::size_t>(c)]).faces)
      for (int i = 0; i < components; ++i) {
        const auto fixed = [&](int v) { return dofs.fixed(of_linear[static_cast<std::size_t>(v)], i); };
        if (!std::ranges::all_of(side.corners(), fixed)) continue;
        for (const int v : side.corners())
          if (const int at = of_linear[static_cast<std::size_t>(v)]; at < linear.owned)
            corners(components * at + i, 0) = 1;
        for (const int v : side.vertices())
          if (const int at = of_quadratic[static_cast<std::size_t>(v)]; at < quadratic.owned)
            on.mid[static_cast<std::size_t>(components * at + i)] = 1;
      }
  }
  on.linear = with_ghosts(linear, corners, components);
  return on;
}

Mask fixed_components(const Mesh& linear, const Dofs& dofs, const PRefinement& refined) {
  const OnFixedFaces on = on_fixed_faces(linear, dofs, refined.mesh);
  Mask mask(components * refined.ends.size(), 0);
  for (int v = 0; v < refined.mesh.owned; ++v) {
    const auto [a, b] = refined.ends[static_cast<std::size_t>(v)];
    for (int i = 0; i < components; ++i) {
      const auto at = static_cast<std::size_t>(components * v + i);
      const bool off_faces = on.linear(components * a + i, 0) == 0 && on.linear(components * b + i, 0) == 0;
      mask[at] = dofs.fixed(a, i) && dofs.fixed(b, i) && (a == b || on.mid[at] || off_faces);
    }
  }
  return mask;
}

}  // namespace

bool can_be_p_refined(fem::CellType type) { return quadratic_type(type).has_value(); }

PRefinement p_refine(const Mesh& mesh, const Dofs& dofs) {
  Part part;
  std::map<Index, Ends> vertices;
  add_cells(mesh, Naming(mesh), part, vertices);
  add_vertices(mesh, vertices, part);
  const auto owned = std::ranges::count(part.owners, parallel::rank(mesh.comm));
  Shared shared;
  shared.vertices_total = parallel::sum(mesh.comm, static_cast<Index>(owned));
  shared.cells_total = mesh.cells_total;
  shared.regions = mesh.regions;
  shared.pieces = mesh.pieces;
  shared.connected_parts = mesh.connected_parts;
  shared.joints = mesh.joints;
  const Index total = components * shared.vertices_total;
  algebra::refuse_beyond_index("with the quadratic cells by which its error is estimated the mesh has " +
                                   std::to_string(total) + " degrees of freedom",
                               total);
  PRefinement refined{number_part(mesh.comm, std::move(part), std::move(shared)), {}, {}};
  for (int v = 0; v < refined.mesh.owned; ++v)
    refined.ends.push_back(vertices.at(refined.mesh.file_positions[static_cast<std::size_t>(v)]));
  refined.dofs = number_free(refined.mesh, fixed_components(mesh, dofs, refined));
  return refined;
}

VertexRows interpolate(const Mesh& linear, const std::vector<std::array<int, 2>>& ends, VertexRef u) {
  const LocalRows local = with_ghosts(linear, u, components);
  VertexRows fine(components * std::ssize(ends), u.cols());
  for (std::size_t v = 0; v < ends.size(); ++v)
    at_vertex(fine, static_cast<Eigen::Index>(v)) = (at_vertex(local, ends[v][0]) + at_vertex(local, ends[v][1])) / 2;
  return fine;
}

}  // namespace ritz::mesh
