#include "inside_out.hpp"

#include "ritz/fem/dispatch.hpp"
#include "ritz/fem/geometry.hpp"

namespace ritz::tools {
namespace {

template <class E>
fem::Coordinates<E> gathered(const model::Points& rows, const std::int64_t* vertices) {
  fem::Coordinates<E> x;
  for (int a = 0; a < E::vertices; ++a) x.col(a) = rows.row(vertices[a]);
  return x;
}

}  // namespace

std::int64_t inside_out(const model::Geometry& geometry, const model::Points& displacement) {
  const auto& cells = geometry.cells;
  std::int64_t count = 0;
  for (std::size_t c = 0; c < cells.vtk_types.size(); ++c)
    for (const auto type : {fem::CellType::tet4, fem::CellType::tet10, fem::CellType::hex8}) {
      if (fem::shape(type).vtk != cells.vtk_types[c]) continue;
      const auto* vertices = cells.vertices.data() + cells.offsets[c];
      count += fem::visit(type, [&]<class E>(E) {
        return fem::turned_inside_out<E>(gathered<E>(geometry.points, vertices), gathered<E>(displacement, vertices));
      });
    }
  return count;
}

}  // namespace ritz::tools
