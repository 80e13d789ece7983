#include "vtkhdf.hpp"

#include <array>

#include "collective.hpp"
#include "disk.hpp"
#include "write.hpp"

namespace ritz::format {

namespace {

bool exists(const ModelWriter& out, const std::string& path) {
  const Quiet quiet;
  return H5Lexists(out.file(), path.c_str(), H5P_DEFAULT) > 0;
}

void link(const ModelWriter& out, const std::string& from, const std::string& to) {
  const Quiet quiet;
  const bool linked = H5Lcreate_hard(out.file(), from.c_str(), out.file(), to.c_str(), H5P_DEFAULT, H5P_DEFAULT) >= 0;
  agree(out, linked, to);
}

std::string grid_of(const ModelWriter& out, std::string_view body) {
  return home(out, body) + std::string(schema::vtkhdf);
}

}  // namespace

void write_grid(const ModelWriter& out, std::string_view body, const GeometrySlices& slices) {
  const auto grid = grid_of(out, body), group = schema::body_part(body, schema::geometry);
  const auto write_count = [&](const char* name, Index count) {
    write_vector<Index>(out, schema::join(grid, name), "1", std::array{count});
  };
  create_group(out, grid);
  write_attribute(out, grid, "Version", std::array<Index, 2>{1, 0});
  write_ascii(out, grid, "Type", "UnstructuredGrid");
  write_count("NumberOfPoints", slices.vertices.total);
  write_count("NumberOfCells", slices.cells.total);
  write_count("NumberOfConnectivityIds", slices.cell_vertices.total);
  link(out, schema::join(group, schema::points), grid + "/Points");
  link(out, schema::join(group, schema::cell_types), grid + "/Types");
  link(out, schema::join(group, schema::cell_offsets), grid + "/Offsets");
  link(out, schema::join(group, schema::cell_vertices), grid + "/Connectivity");
  create_group(out, schema::join(grid, "PointData"));
}

void write_point_vector(const ModelWriter& out, std::string_view body, const std::string& path,
                        const std::string& name) {
  const auto grid = grid_of(out, body);
  if (exists(out, grid)) link(out, path, grid + "/PointData/" + name);
}

files::PartFile view_file(const std::filesystem::path& model, const std::string& body, const std::string& home) {
  auto path = model;
  files::PartFile part(path.replace_extension(body + ".hdf"));
  const auto room = [&] {
    constexpr std::uint64_t bytes = 1 << 16;
    if (const int error = reserve(part.part(), bytes)) files::fail_to_write(path, error);
  };
  const Quiet quiet;
  room();
  File file(H5Fcreate(part.part().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  room();
  const auto target = home + std::string(schema::vtkhdf);
  if (!file ||
      H5Lcreate_external(model.filename().c_str(), target.c_str(), file.get(), schema::vtkhdf.data(), H5P_DEFAULT,
                         H5P_DEFAULT) < 0 ||
      !file.close())
    files::fail_to_write(path, hdf5_error());
  release_room(part.part());
  part.finish();
  return part;
}

}  // namespace ritz::format
