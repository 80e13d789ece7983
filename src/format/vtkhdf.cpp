#include "vtkhdf.hpp"

#include <array>

#include "collective.hpp"
#include "write.hpp"

namespace ritz::format {

namespace {

const std::string grid(schema::vtkhdf);
const std::string point_data = grid + "/PointData";

bool exists(const ModelWriter& out, const std::string& path) {
  const Quiet quiet;
  return H5Lexists(out.file(), path.c_str(), H5P_DEFAULT) > 0;
}

void link(const ModelWriter& out, const std::string& from, const std::string& to) {
  const Quiet quiet;
  const bool linked = H5Lcreate_hard(out.file(), from.c_str(), out.file(), to.c_str(), H5P_DEFAULT, H5P_DEFAULT) >= 0;
  agree(out, linked, to);
}

void write_count(const ModelWriter& out, const char* name, Index count) {
  write_vector<Index>(out, schema::join(grid, name), "1", std::array{count});
}

}  // namespace

void write_grid(const ModelWriter& out, const std::string& group, const GeometrySlices& slices) {
  if (exists(out, grid)) return;
  create_group(out, grid);
  write_attribute(out, grid, "Version", std::array<Index, 2>{1, 0});
  write_ascii(out, grid, "Type", "UnstructuredGrid");
  write_count(out, "NumberOfPoints", slices.vertices.total);
  write_count(out, "NumberOfCells", slices.cells.total);
  write_count(out, "NumberOfConnectivityIds", slices.cell_vertices.total);
  link(out, schema::join(group, schema::points), grid + "/Points");
  link(out, schema::join(group, schema::cell_types), grid + "/Types");
  link(out, schema::join(group, schema::cell_offsets), grid + "/Offsets");
  link(out, schema::join(group, schema::cell_vertices), grid + "/Connectivity");
  create_group(out, point_data);
}

void write_point_vector(const ModelWriter& out, const std::string& path, const std::string& name) {
  const auto target = schema::join(point_data, name);
  if (exists(out, grid) && !exists(out, target)) link(out, path, target);
}

}  // namespace ritz::format
