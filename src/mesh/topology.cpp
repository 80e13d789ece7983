#include "ritz/mesh/topology.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <unordered_map>

#include "ritz/base/error.hpp"
#include "ritz/base/random.hpp"

namespace ritz::mesh {
namespace {

/// A face by its corners, ascending; a triangle has a -1 before them.
using Key = std::array<Index, 4>;

struct KeyHash {
  std::size_t operator()(const Key& k) const {
    std::uint64_t h = 0;
    for (const Index v : k) h = split_mix(h ^ static_cast<std::uint64_t>(v));
    return h;
  }
};

template <class Vertices>
Key key_of(const Vertices& corners) {
  Key key = {-1, -1, -1, -1};
  std::copy(corners.begin(), corners.end(), key.begin());
  std::sort(key.begin(), key.end());
  return key;
}

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

Key face_key(const FileMesh& mesh, Index cell, int face) {
  const auto type = mesh.cell_types[static_cast<std::size_t>(cell)];
  const auto local = fem::face_vertices(type, face);
  std::vector<Index> corners;
  for (int v = 0; v < fem::shape(fem::shape(type).face).corners; ++v)
    corners.push_back(mesh.cell_vertices[static_cast<std::size_t>(mesh.cell_offsets[static_cast<std::size_t>(cell)] +
                                                                  local[static_cast<std::size_t>(v)])]);
  return key_of(corners);
}

using OpenFaces = std::unordered_map<Key, CellFace, KeyHash>;

/// Pairs up equal faces; what stays open is the boundary.
OpenFaces match_faces(const FileMesh& mesh, std::vector<std::array<Index, 2>>& neighbours) {
  OpenFaces open;
  open.reserve(mesh.cell_types.size());
  for (Index c = 0; c < static_cast<Index>(mesh.cell_types.size()); ++c)
    for (int f = 0; f < fem::shape(mesh.cell_types[static_cast<std::size_t>(c)]).faces; ++f) {
      const auto [place, fresh] = open.try_emplace(face_key(mesh, c, f), CellFace{static_cast<int>(c), f});
      if (fresh) continue;
      neighbours.push_back({place->second.cell, c});
      open.erase(place);
    }
  return open;
}

std::vector<CellFace> faces_of_set(const NamedSet& set, const OpenFaces& boundary) {
  std::vector<CellFace> faces;
  for (const auto& face : set.faces) {
    const auto corners = static_cast<std::size_t>(fem::shape(face.type).corners);
    const auto found = boundary.find(key_of(std::span(face.vertices).first(corners)));
    if (found != boundary.end()) faces.push_back(found->second);
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

int count_components(const FileMesh& mesh) {
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
  const OpenFaces open = match_faces(mesh, topology.neighbours);
  for (const auto& [key, face] : open) topology.boundary.push_back(face);
  std::sort(topology.boundary.begin(), topology.boundary.end());
  for (const auto& set : mesh.sets) topology.set_faces.push_back(faces_of_set(set, open));
  find_pieces(mesh, topology);
  topology.components = count_components(mesh);
  if (topology.pieces > max_pieces)
    throw InputError("the mesh falls into " + std::to_string(topology.pieces) +
                     " pieces that share no faces (at most " + std::to_string(max_pieces) +
                     " are allowed); merge coincident vertices or mesh the parts as one body");
  return topology;
}

}  // namespace ritz::mesh
