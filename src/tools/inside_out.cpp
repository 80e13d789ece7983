#include "inside_out.hpp"

#include <span>

#include "ritz/fem/geometry.hpp"

namespace ritz::tools {
namespace {

fem::CellVectors gathered(const model::Points& rows, std::span<const std::int64_t> vertices) {
  fem::CellVectors x(3, static_cast<int>(vertices.size()));
  for (int a = 0; a < x.cols(); ++a) x.col(a) = rows.row(vertices[static_cast<std::size_t>(a)]);
  return x;
}

}  // namespace

std::int64_t inside_out(const model::Geometry& geometry, const model::Points& displacement) {
  const auto& cells = geometry.cells;
  std::int64_t count = 0;
  for (std::size_t c = 0; c < cells.vtk_types.size(); ++c) {
    const auto type = fem::cell_of_vtk(cells.vtk_types[c]);
    if (!type) continue;
    const auto vertices =
        std::span(cells.vertices)
            .subspan(static_cast<std::size_t>(cells.offsets[c]), static_cast<std::size_t>(fem::shape(*type).vertices));
    count += fem::turned_inside_out(*type, gathered(geometry.points, vertices), gathered(displacement, vertices));
  }
  return count;
}

}  // namespace ritz::tools
