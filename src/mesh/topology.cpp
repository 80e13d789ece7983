#include "ritz/mesh/topology.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "ritz/base/error.hpp"

namespace ritz::mesh {
namespace {

class Groups {
 public:
  explicit Groups(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t find(std::size_t a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  void join(std::size_t a, std::size_t b) { parent_[std::max(find(a), find(b))] = std::min(find(a), find(b)); }

  /// Numbers the groups 0, 1, ... by their first member.
  std::vector<std::int32_t> numbers(int& count) {
    std::vector<std::int32_t> number(parent_.size());
    count = 0;
    for (std::size_t a = 0; a < parent_.size(); ++a) number[a] = find(a) == a ? count++ : number[find(a)];
    return number;
  }

 private:
  std::vector<std::size_t> parent_;
};

std::vector<CellFace> faces_of_set(const NamedSet& set, const MatchedFaces& matched) {
  std::vector<CellFace> faces;
  for (const auto& face : set.faces) {
    const auto corners = static_cast<std::size_t>(fem::shape(face.type).corners);
    const auto found = matched.boundary.find(face_key(std::span(face.vertices).first(corners)));
    if (found != matched.boundary.end()) faces.push_back(found->second);
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

int count_connected_parts(const FileMesh& mesh) {
  Groups groups(mesh.points.size());
  for (std::size_t c = 0; c < mesh.cell_types.size(); ++c)
    for (Index v = mesh.cell_offsets[c] + 1; v < mesh.cell_offsets[c + 1]; ++v)
      groups.join(static_cast<std::size_t>(mesh.cell_vertices[static_cast<std::size_t>(mesh.cell_offsets[c])]),
                  static_cast<std::size_t>(mesh.cell_vertices[static_cast<std::size_t>(v)]));
  int count = 0;
  groups.numbers(count);
  return count;
}

void find_pieces(const FileMesh& mesh, Topology& topology) {
  Groups groups(mesh.cell_types.size());
  for (const auto& [a, b] : topology.neighbours) groups.join(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
  const auto piece = groups.numbers(topology.pieces);
  topology.vertex_pieces.assign(mesh.points.size(), -1);
  std::map<Index, std::vector<int>> shared;
  for (std::size_t c = 0; c < mesh.cell_types.size(); ++c)
    for (Index i = mesh.cell_offsets[c]; i < mesh.cell_offsets[c + 1]; ++i) {
      const Index v = mesh.cell_vertices[static_cast<std::size_t>(i)];
      auto& first = topology.vertex_pieces[static_cast<std::size_t>(v)];
      if (first < 0) first = piece[c];
      if (first == piece[c]) continue;
      auto& others = shared[v];
      if (others.empty()) others.push_back(first);
      if (std::find(others.begin(), others.end(), piece[c]) == others.end()) others.push_back(piece[c]);
    }
  for (auto& [vertex, pieces] : shared)
    topology.joints.push_back({mesh.points[static_cast<std::size_t>(vertex)], std::move(pieces)});
}

}  // namespace

Topology find_topology(const FileMesh& mesh) {
  Topology topology;
  MatchedFaces matched = match_faces(mesh);
  topology.neighbours = std::move(matched.neighbours);
  topology.hanging_faces = matched.hanging;
  for (const auto& [key, face] : matched.boundary) topology.boundary.push_back(face);
  std::sort(topology.boundary.begin(), topology.boundary.end());
  for (const auto& set : mesh.sets) topology.set_faces.push_back(faces_of_set(set, matched));
  find_pieces(mesh, topology);
  topology.connected_parts = count_connected_parts(mesh);
  if (topology.pieces > max_pieces)
    throw InputError("the mesh falls into " + std::to_string(topology.pieces) +
                     " pieces that share no faces (at most " + std::to_string(max_pieces) +
                     " are allowed); merge coincident vertices or mesh the parts as one body");
  return topology;
}

}  // namespace ritz::mesh
