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

/// The grid of the vertices: half the cells' spacing for quadratic cells, else the same. Not every place on it has a
/// vertex: Hex20 and Wedge15 have none in the middles of cells and of some faces.
class VertexGrid {
 public:
  VertexGrid(const Grid& cells, fem::CellType type)
      : type_(type), step_(fem::shape(type).quadratic() ? 2 : 1), size_{0, 0, 0} {
    for (std::size_t d = 0; d < 3; ++d) size_[d] = step_ * cells[d] + 1;
  }

  Index step() const { return step_; }  ///< grid steps a cell
  Index last(std::size_t d) const { return size_[d] - 1; }
  Index count() const { return before_plane(size_[2]); }
  /// x runs fastest, then y, then z.
  Index number(const Grid& v) const {
    return before_plane(v[2]) + before_row(v[1], odd(v[2])) + v[0] / spacing(odd(v[1]), odd(v[2]));
  }

 private:
  static bool odd(Index i) { return i % 2 != 0; }

  /// Steps between vertices in a row along x, or 0 if it has none.
  Index spacing(bool odd_y, bool odd_z) const {
    if (type_ == fem::CellType::hex20) return odd_y && odd_z ? 0 : odd_y || odd_z ? 2 : 1;
    if (type_ == fem::CellType::wedge15) return odd_z ? (odd_y ? 0 : 2) : 1;
    return 1;
  }
  Index in_row(bool odd_y, bool odd_z) const {
    const Index s = spacing(odd_y, odd_z);
    return s == 0 ? 0 : (size_[0] - 1) / s + 1;
  }
  /// Of the rows 0 ... y - 1 of a plane.
  Index before_row(Index y, bool odd_z) const {
    return (y + 1) / 2 * in_row(false, odd_z) + y / 2 * in_row(true, odd_z);
  }
  Index before_plane(Index z) const {
    return (z + 1) / 2 * before_row(size_[1], false) + z / 2 * before_row(size_[1], true);
  }

  fem::CellType type_;
  Index step_;
  Grid size_;
};

int owner_of(const Grid& v, const VertexGrid& grid, const Cut& cut) {
  int owner = std::numeric_limits<int>::max();
  for (int corner = 0; corner < 8; ++corner) {
    Grid h{};
    bool inside = true;
    for (std::size_t d = 0; d < 3; ++d) {
      const Index shifted = v[d] - ((corner >> d) & 1);
      inside = inside && shifted >= 0 && shifted < grid.last(d);
      h[d] = shifted / grid.step();
    }
    if (inside) owner = std::min(owner, cut.rank_of(h));
  }
  return owner;
}

/// The corners of the cells that fill one hexahedron of the grid, as offsets 0 or 1 in each direction.
std::vector<std::vector<Grid>> hexahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
}

std::vector<std::vector<Grid>> two_wedges() {
  return {{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}},
          {{0, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
}

std::vector<std::vector<Grid>> six_tetrahedra() {
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

/// The cells of one hexahedron by their vertices, in steps of the vertex grid.
std::vector<std::vector<Grid>> pattern(fem::CellType type) {
  const auto shape = fem::shape(type);
  auto cells = shape.linear == fem::CellType::hex8     ? hexahedron()
               : shape.linear == fem::CellType::wedge6 ? two_wedges()
                                                       : six_tetrahedra();
  if (!shape.quadratic()) return cells;
  for (auto& cell : cells) {
    const auto corners = cell;
    for (auto& v : cell) v = {2 * v[0], 2 * v[1], 2 * v[2]};
    for (const auto& [i, j] : shape.edges) {
      const auto &a = corners[static_cast<std::size_t>(i)], &b = corners[static_cast<std::size_t>(j)];
      cell.push_back({a[0] + b[0], a[1] + b[1], a[2] + b[2]});
    }
  }
  return cells;
}

/// Makes cells of a block of hexahedra and of the ring around it that touches owned vertices.
class Maker {
 public:
  Maker(const Box& box, int rank, int ranks)
      : box_(box), rank_(rank), cut_(box.cells, ranks), grid_(box.cells, box.type), pattern_(pattern(box.type)) {
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
        for (std::size_t d = 0; d < 3; ++d) v[d] += grid_.step() * h[d];
        touches = touches || owner_of(v, grid_, cut_) == rank_;
      }
      if (!touches) continue;
      const Index number = hexahedron * static_cast<Index>(pattern_.size()) + static_cast<Index>(c);
      part_.numbers.push_back(number);
      part_.cell_ids.push_back(number + 1);
      part_.types.push_back(box_.type);
      part_.regions.push_back(0);
      for (const auto& v : at) {
        const Index vertex = grid_.number(v);
        part_.cell_vertices.push_back(vertex);
        places_.emplace_back(vertex, v);
      }
      if (owned) add_faces(at);
    }
  }

  void add_faces(const std::vector<Grid>& at) {
    const int cell = static_cast<int>(part_.types.size()) - 1;
    for (int f = 0; f < std::ssize(fem::shape(box_.type).faces); ++f) {
      for (std::size_t side = 0; side < 6; ++side) {
        const std::size_t d = side / 2;
        const Index plane = side % 2 ? grid_.last(d) : 0;
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
    std::sort(places_.begin(), places_.end());
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    for (const auto& [n, v] : places_) {
      part_.positions.push_back(n);
      part_.ids.push_back(n + 1);
      part_.owners.push_back(owner_of(v, grid_, cut_));
      part_.pieces.push_back(0);
      for (std::size_t d = 0; d < 3; ++d) {
        const Index last = grid_.last(d);
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
  std::vector<std::pair<Index, Grid>> places_;  ///< of vertices, by their numbers
  Part part_;
};

template <class T>
T parse_number(std::string_view word, std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    throw InputError("option -mesh " + std::string(text) + ": '" + std::string(word) +
                     "' is not a number; write box:LX,LY,LZ/NX,NY,NZ/tet4 (or tet10, hex8, hex20, wedge6, wedge15)");
  return value;
}

template <class T>
std::array<T, 3> parse_three(std::string_view words, std::string_view text) {
  std::array<T, 3> values{};
  for (std::size_t d = 0; d < 3; ++d) {
    const auto comma = d < 2 ? words.find(',') : words.size();
    if (comma == words.npos)
      throw InputError("option -mesh " + std::string(text) +
                       " needs three lengths and three counts; write box:LX,LY,LZ/NX,NY,NZ/tet4 (or tet10, hex8, "
                       "hex20, wedge6, wedge15)");
    values[d] = parse_number<T>(words.substr(0, comma), text);
    words.remove_prefix(std::min(words.size(), comma + 1));
  }
  return values;
}

fem::CellType parse_type(std::string_view word, std::string_view text) {
  for (const auto type : fem::cell_types)
    if (fem::shape(type).name == word && type != fem::CellType::pyramid5) return type;
  throw InputError("option -mesh " + std::string(text) +
                   ": a box is made of tet4, tet10, hex8, hex20, wedge6 or wedge15, not '" + std::string(word) + "'");
}

}  // namespace

bool names_box(std::string_view text) { return text.starts_with("box:"); }

Box parse_box(std::string_view text) {
  const auto body = text.substr(4);
  const auto slash = body.find('/');
  const auto last = body.rfind('/');
  if (slash == last)
    throw InputError("option -mesh " + std::string(text) +
                     " is not of the form box:LX,LY,LZ/NX,NY,NZ/tet4 (or tet10, hex8, hex20, wedge6, wedge15)");
  const Box box{parse_three<double>(body.substr(0, slash), text),
                parse_three<Index>(body.substr(slash + 1, last - slash - 1), text),
                parse_type(body.substr(last + 1), text)};
  for (std::size_t d = 0; d < 3; ++d)
    if (!(box.lengths[d] > 0) || !std::isfinite(box.lengths[d]) || box.cells[d] < 1)
      throw InputError("option -mesh " + std::string(text) + ": lengths and counts must be positive");
  double vertices = 1;
  for (const auto n : box.cells) vertices *= static_cast<double>(n) * (fem::shape(box.type).quadratic() ? 2 : 1) + 1;
  if (vertices > 1e9)
    throw InputError("option -mesh " + std::string(text) + ": more than 1e9 vertices; use a coarser grid");
  return box;
}

std::pair<Part, Shared> make_box(MPI_Comm comm, const Box& box) {
  Maker maker(box, parallel::rank(comm), parallel::size(comm));
  Shared shared;
  shared.vertices_total = VertexGrid(box.cells, box.type).count();
  shared.cells_total = box.cells[0] * box.cells[1] * box.cells[2] * std::ssize(pattern(box.type));
  shared.regions = {{"body", {}}};
  shared.set_names = {"xmin", "xmax", "ymin", "ymax", "zmin", "zmax", "body"};
  return {maker.make(), std::move(shared)};
}

}  // namespace ritz::mesh
