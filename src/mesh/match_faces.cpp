#include "ritz/mesh/topology.hpp"

#include <algorithm>

#include "ritz/base/error.hpp"
#include "ritz/base/random.hpp"

namespace ritz::mesh {
namespace {

constexpr Index nobody = -1;

/// A face as the first cell that has it sees it, and the second cell.
struct Meeting {
  CellFace first;
  Index second = nobody;
};

using Meetings = std::unordered_map<FaceKey, Meeting, FaceKeyHash>;

fem::CellType type_of(const FileMesh& mesh, Index cell) { return mesh.cell_types[static_cast<std::size_t>(cell)]; }

std::span<const Index> corners_of(const FileMesh& mesh, Index cell) {
  return std::span(mesh.cell_vertices)
      .subspan(static_cast<std::size_t>(mesh.cell_offsets[static_cast<std::size_t>(cell)]),
               static_cast<std::size_t>(fem::shape(type_of(mesh, cell)).corners));
}

/// The corners of a face, around it; the first `count` are used.
struct Around {
  FaceKey vertices;
  std::size_t count;
};

Around around(const FileMesh& mesh, Index cell, int face) {
  const auto local = fem::side(type_of(mesh, cell), face).corners();
  Around corners{{}, local.size()};
  for (std::size_t i = 0; i < corners.count; ++i)
    corners.vertices[i] = corners_of(mesh, cell)[static_cast<std::size_t>(local[i])];
  return corners;
}

std::string id(const FileMesh& mesh, Index cell) {
  return std::to_string(mesh.cell_ids[static_cast<std::size_t>(cell)]);
}

void refuse_twins(const FileMesh& mesh, Index a, Index b) {
  const auto one = corners_of(mesh, a), other = corners_of(mesh, b);
  if (!std::is_permutation(one.begin(), one.end(), other.begin(), other.end())) return;
  throw InputError("cells " + id(mesh, a) + " and " + id(mesh, b) +
                   " of the mesh have the same corners; leave one of them out");
}

[[noreturn]] void refuse_third(const FileMesh& mesh, const Meeting& pair, Index third) {
  throw InputError("cells " + id(mesh, pair.first.cell) + ", " + id(mesh, pair.second) + " and " + id(mesh, third) +
                   " of the mesh share one face, where at most two can meet; leave out what overlaps");
}

bool has_middles(const FileMesh& mesh, Index cell) { return fem::shape(type_of(mesh, cell)).quadratic(); }

void add_pair(const FileMesh& mesh, MatchedFaces& matched, Index a, Index b) {
  matched.neighbours.push_back({a, b});
  matched.hanging += has_middles(mesh, a) != has_middles(mesh, b);
}

Meetings meet(const FileMesh& mesh, MatchedFaces& matched) {
  Meetings meetings;
  meetings.reserve(2 * mesh.cell_types.size());
  for (Index c = 0; c < std::ssize(mesh.cell_types); ++c)
    for (int f = 0; f < std::ssize(fem::shape(type_of(mesh, c)).faces); ++f) {
      const auto corners = around(mesh, c, f);
      const auto key = face_key(std::span(corners.vertices).first(corners.count));
      auto& [first, second] = meetings.try_emplace(key, Meeting{{static_cast<int>(c), f}}).first->second;
      if (first == CellFace{static_cast<int>(c), f}) continue;
      refuse_twins(mesh, first.cell, c);
      if (second != nobody) refuse_third(mesh, {first, second}, c);
      second = c;
      add_pair(mesh, matched, first.cell, c);
    }
  return meetings;
}

/// Joins a quadrilateral of the boundary to the two triangles on one of its diagonals, if they are there.
void match_triangles(const FileMesh& mesh, CellFace quad, MatchedFaces& matched) {
  const auto [v, count] = around(mesh, quad.cell, quad.face);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto a = matched.boundary.find(face_key(std::array{v[i], v[i + 1], v[i + 2]}));
    const auto b = matched.boundary.find(face_key(std::array{v[i + 2], v[(i + 3) % 4], v[i]}));
    if (a == matched.boundary.end() || b == matched.boundary.end()) continue;
    for (const auto triangle : {a->second.cell, b->second.cell}) {
      matched.neighbours.push_back({quad.cell, triangle});
      matched.hanging += has_middles(mesh, quad.cell) || has_middles(mesh, triangle);  // that of the diagonal, too
    }
    matched.boundary.erase(a);
    matched.boundary.erase(b);
    matched.boundary.erase(face_key(v));
    return;
  }
}

}  // namespace

std::size_t FaceKeyHash::operator()(const FaceKey& key) const {
  std::uint64_t h = 0;
  for (const Index v : key) h = split_mix(h ^ static_cast<std::uint64_t>(v));
  return h;
}

FaceKey face_key(std::span<const Index> corners) {
  FaceKey key = {-1, -1, -1, -1};
  std::copy(corners.begin(), corners.end(), key.begin());
  std::sort(key.begin(), key.end());
  return key;
}

MatchedFaces match_faces(const FileMesh& mesh) {
  MatchedFaces matched;
  std::vector<CellFace> quads;
  for (const auto& [key, meeting] : meet(mesh, matched)) {
    if (meeting.second != nobody) continue;
    matched.boundary.emplace(key, meeting.first);
    if (key[0] >= 0) quads.push_back(meeting.first);
  }
  std::sort(quads.begin(), quads.end());
  for (const CellFace quad : quads) match_triangles(mesh, quad, matched);
  return matched;
}

}  // namespace ritz::mesh
