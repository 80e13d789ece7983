#include "ritz/mesh/box.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "ritz/base/error.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::mesh {
namespace {

using Grid = std::array<Index, 3>;

/// The hexahedra [from, to) of the grid.
struct Block {
  Grid from, to;
  Index count() const { return (to[0] - from[0]) * (to[1] - from[1]) * (to[2] - from[2]); }
  bool holds(const Grid& h) const {
    for (std::size_t d = 0; d < 3; ++d)
      if (h[d] < from[d] || h[d] >= to[d]) return false;
    return true;
  }
};

/// Recursive bisection of the grid along its longest side, in proportion to the ranks of each half.
class Cut {
 public:
  Cut(const Grid& cells, int ranks) : whole_{{0, 0, 0}, cells}, ranks_(ranks) {}

  Block block_of(int rank) const {
    return descend([&](const Block&, const Block&, int first_right) { return rank >= first_right; }).first;
  }
  int rank_of(const Grid& h) const {
    return descend([&](const Block& left, const Block&, int) { return !left.holds(h); }).second;
  }

 private:
  template <class GoRight>
  std::pair<Block, int> descend(GoRight go_right) const {
    Block block = whole_;
    int first = 0, last = ranks_;
    while (last - first > 1) {
      const int middle = first + (last - first) / 2;
      std::size_t d = 0;
      for (std::size_t e = 1; e < 3; ++e)
        if (block.to[e] - block.from[e] > block.to[d] - block.from[d]) d = e;
      Block left = block, right = block;
      left.to[d] = right.from[d] =
          block.from[d] + ((block.to[d] - block.from[d]) * (middle - first) + (last - first) / 2) / (last - first);
      const bool right_half = go_right(left, right, middle);
      block = right_half ? right : left;
      (right_half ? first : last) = middle;
    }
    return {block, first};
  }

  Block whole_;
  int ranks_;
};

/// Positions on the vertex grid: half the cells' spacing for Tet10, else the same.
struct VertexGrid {
  Grid cells;
  Index step;  ///< vertex grid steps a cell: 2 for Tet10, else 1

  Index points(std::size_t d) const { return step * cells[d] + 1; }
  Index number(const Grid& v) const { return v[0] + points(0) * (v[1] + points(1) * v[2]); }
  Grid position(Index n) const { return {n % points(0), n / points(0) % points(1), n / points(0) / points(1)}; }
};

int owner_of(const Grid& v, const VertexGrid& grid, const Cut& cut) {
  int owner = std::numeric_limits<int>::max();
  for (int corner = 0; corner < 8; ++corner) {
    Grid h{};
    bool inside = true;
    for (std::size_t d = 0; d < 3; ++d) {
      const Index shifted = v[d] - ((corner >> d) & 1);
      inside = inside && shifted >= 0 && shifted < grid.step * grid.cells[d];
      h[d] = shifted / grid.step;
    }
    if (inside) owner = std::min(owner, cut.rank_of(h));
  }
  return owner;
}

/// The corners of the cells of one hexahedron, as offsets 0 or 1 in each direction.
std::vector<std::vector<Grid>> cell_corners(fem::CellType type) {
  if (type == fem::CellType::hex8)
    return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
  std::vector<std::vector<Grid>> tets;
  std::array<std::size_t, 3> axes = {0, 1, 2};
  do {
    std::vector<Grid> path(4, Grid{0, 0, 0});
    for (std::size_t s = 0; s < 3; ++s) {
      path[s + 1] = path[s];
      path[s + 1][axes[s]] = 1;
    }
    const bool even = (axes[1] == (axes[0] + 1) % 3);
    if (!even) std::swap(path[1], path[2]);
    tets.push_back(path);
  } while (std::next_permutation(axes.begin(), axes.end()));
  return tets;
}

std::vector<Grid> with_midpoints(std::vector<Grid> corners) {
  constexpr std::array<std::pair<std::size_t, std::size_t>, 6> edges = {
      {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
  std::vector<Grid> all;
  for (const auto& c : corners) all.push_back({2 * c[0], 2 * c[1], 2 * c[2]});
  for (const auto& [a, b] : edges)
    all.push_back({corners[a][0] + corners[b][0], corners[a][1] + corners[b][1], corners[a][2] + corners[b][2]});
  return all;
}

/// Makes cells of a block of hexahedra and of the ring around it that touches owned vertices.
class Maker {
 public:
  Maker(const Box& box, int rank, int ranks)
      : box_(box),
        rank_(rank),
        cut_(box.cells, ranks),
        grid_{box.cells, box.type == fem::CellType::tet10 ? 2 : 1},
        pattern_(cell_corners(box.type)) {
    if (box.type == fem::CellType::tet10)
      for (auto& cell : pattern_) cell = with_midpoints(cell);
    part_.sets.resize(7);
    for (auto& set : part_.sets) set.has_faces = true;
    part_.sets[6].has_faces = false;
  }

  Part make() {
    const Block own = cut_.block_of(rank_);
    if (own.count() > 0) {
      each(own, [&](const Grid& h) { add(h, true); });
      part_.owned_cells = static_cast<Index>(part_.types.size());
      Block ring = own;
      for (std::size_t d = 0; d < 3; ++d) {
        ring.from[d] = std::max<Index>(0, own.from[d] - 1);
        ring.to[d] = std::min(box_.cells[d], own.to[d] + 1);
      }
      each(ring, [&](const Grid& h) {
        if (!own.holds(h)) add(h, false);
      });
    }
    add_vertices();
    return std::move(part_);
  }

 private:
  template <class F>
  static void each(const Block& b, F f) {
    for (Index k = b.from[2]; k < b.to[2]; ++k)
      for (Index j = b.from[1]; j < b.to[1]; ++j)
        for (Index i = b.from[0]; i < b.to[0]; ++i) f(Grid{i, j, k});
  }

  void add(const Grid& h, bool owned) {
    const Index hexahedron = h[0] + box_.cells[0] * (h[1] + box_.cells[1] * h[2]);
    for (std::size_t c = 0; c < pattern_.size(); ++c) {
      std::vector<Grid> at = pattern_[c];
      bool touches = owned;
      for (auto& v : at) {
        for (std::size_t d = 0; d < 3; ++d) v[d] += grid_.step * h[d];
        touches = touches || owner_of(v, grid_, cut_) == rank_;
      }
      if (!touches) continue;
      const Index number = hexahedron * static_cast<Index>(pattern_.size()) + static_cast<Index>(c);
      part_.numbers.push_back(number);
      part_.cell_ids.push_back(number + 1);
      part_.types.push_back(box_.type);
      part_.regions.push_back(0);
      for (const auto& v : at) part_.cell_vertices.push_back(grid_.number(v));
      if (owned) add_faces(at);
    }
  }

  void add_faces(const std::vector<Grid>& at) {
    const int cell = static_cast<int>(part_.types.size()) - 1;
    for (int f = 0; f < fem::shape(box_.type).faces; ++f) {
      for (std::size_t side = 0; side < 6; ++side) {
        const std::size_t d = side / 2;
        const Index plane = side % 2 ? grid_.step * box_.cells[d] : 0;
        const auto local = fem::face_vertices(box_.type, f);
        if (!std::all_of(local.begin(), local.end(),
                         [&](int v) { return at[static_cast<std::size_t>(v)][d] == plane; }))
          continue;
        part_.boundary.push_back({cell, f});
        part_.sets[side].faces.push_back({cell, f});
      }
    }
  }

  void add_vertices() {
    part_.positions = part_.cell_vertices;
    std::sort(part_.positions.begin(), part_.positions.end());
    part_.positions.erase(std::unique(part_.positions.begin(), part_.positions.end()), part_.positions.end());
    for (const Index n : part_.positions) {
      const Grid v = grid_.position(n);
      part_.ids.push_back(n + 1);
      part_.owners.push_back(owner_of(v, grid_, cut_));
      part_.pieces.push_back(0);
      for (std::size_t d = 0; d < 3; ++d) {
        const Index last = grid_.step * box_.cells[d];
        part_.points.push_back(box_.lengths[d] * static_cast<double>(v[d]) / static_cast<double>(last));
        if (v[d] == 0) part_.sets[2 * d].vertices.push_back(n);
        if (v[d] == last) part_.sets[2 * d + 1].vertices.push_back(n);
      }
    }
    part_.sets[6].vertices = part_.positions;
  }

  Box box_;
  int rank_;
  Cut cut_;
  VertexGrid grid_;
  std::vector<std::vector<Grid>> pattern_;
  Part part_;
};

template <class T>
T parse_number(std::string_view word, std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    throw InputError("option -mesh " + std::string(text) + ": '" + std::string(word) +
                     "' is not a number; write box:LX,LY,LZ/NX,NY,NZ/tet4 (or tet10, hex8)");
  return value;
}

template <class T>
std::array<T, 3> parse_three(std::string_view words, std::string_view text) {
  std::array<T, 3> values{};
  for (std::size_t d = 0; d < 3; ++d) {
    const auto comma = d < 2 ? words.find(',') : words.size();
    if (comma == words.npos)
      throw InputError("option -mesh " + std::string(text) +
                       " needs three lengths and three counts; write box:LX,LY,LZ/NX,NY,NZ/tet4 (or tet10, hex8)");
    values[d] = parse_number<T>(words.substr(0, comma), text);
    words.remove_prefix(std::min(words.size(), comma + 1));
  }
  return values;
}

fem::CellType parse_type(std::string_view word, std::string_view text) {
  for (const auto type : {fem::CellType::tet4, fem::CellType::tet10, fem::CellType::hex8})
    if (fem::shape(type).name == word) return type;
  throw InputError("option -mesh " + std::string(text) + ": a box is made of tet4, tet10 or hex8, not '" +
                   std::string(word) + "'");
}

}  // namespace

bool names_box(std::string_view text) { return text.starts_with("box:"); }

Box parse_box(std::string_view text) {
  const auto body = text.substr(4);
  const auto slash = body.find('/');
  const auto last = body.rfind('/');
  if (slash == last)
    throw InputError("option -mesh " + std::string(text) +
                     " is not of the form box:LX,LY,LZ/NX,NY,NZ/tet4 (or tet10, hex8)");
  const Box box{parse_three<double>(body.substr(0, slash), text),
                parse_three<Index>(body.substr(slash + 1, last - slash - 1), text),
                parse_type(body.substr(last + 1), text)};
  for (std::size_t d = 0; d < 3; ++d)
    if (!(box.lengths[d] > 0) || !std::isfinite(box.lengths[d]) || box.cells[d] < 1)
      throw InputError("option -mesh " + std::string(text) + ": lengths and counts must be positive");
  double vertices = 1;
  for (const auto n : box.cells) vertices *= static_cast<double>(n) * (box.type == fem::CellType::tet10 ? 2 : 1) + 1;
  if (vertices > 1e9)
    throw InputError("option -mesh " + std::string(text) + ": more than 1e9 vertices; use a coarser grid");
  return box;
}

std::pair<Part, Shared> make_box(MPI_Comm comm, const Box& box) {
  Maker maker(box, parallel::rank(comm), parallel::size(comm));
  Shared shared;
  const VertexGrid grid{box.cells, box.type == fem::CellType::tet10 ? 2 : 1};
  shared.vertices_total = grid.points(0) * grid.points(1) * grid.points(2);
  shared.cells_total = box.cells[0] * box.cells[1] * box.cells[2] * (box.type == fem::CellType::hex8 ? 1 : 6);
  shared.regions = {{"body", {}}};
  shared.set_names = {"xmin", "xmax", "ymin", "ymax", "zmin", "zmax", "body"};
  return {maker.make(), std::move(shared)};
}

}  // namespace ritz::mesh
