#include "vtkhdf.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "collective.hpp"
#include "disk.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/files/part_file.hpp"
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

/// "0.7621 Hz", "440.0 Hz", "12345 Hz": four digits, and never an exponent among what audible bodies have.
std::string swinging_at(double hertz) {
  if (hertz > 0 && hertz < 1e-3) return shown(hertz, 4) + " Hz";
  const int decimals = hertz >= 1 ? std::max(0, 3 - static_cast<int>(std::log10(hertz))) : 4;
  return formatted("%.*f Hz", decimals, hertz);
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

void write_point_vector(const ModelWriter& out, std::string_view body, const ShownColumn& shown,
                        std::span<const double> values, Slice vertices) {
  const auto grid = grid_of(out, body);
  if (!exists(out, grid)) return;
  std::vector<float> seen;
  seen.reserve(values.size());
  for (const double value : values) seen.push_back(static_cast<float>(shown.factor * value));
  const auto path = grid + "/PointData/" + shown.name;
  write_rows<float>(out, path, "m", seen, vertices, 3);
  write_attribute(out, path, "factor", shown.factor);
}

std::vector<std::string> column_names(Index columns, const std::optional<model::Modes>& modes,
                                      const std::optional<model::Reduction>& reduction) {
  const bool are_modes = modes && !reduction && static_cast<Index>(modes->kinds.size()) == columns;
  const auto width = static_cast<int>(std::max<std::size_t>(2, std::to_string(columns).size()));
  const Eigen::VectorXd squares = reduction ? reduction->stiffness : are_modes ? modes->eigenvalues : Eigen::VectorXd();
  std::vector<std::string> names;
  for (Index i = 0; i < columns; ++i) {
    auto& name =
        names.emplace_back(formatted("%s %0*d", are_modes ? "mode" : "column", width, static_cast<int>(i + 1)));
    if (are_modes && modes->kinds.at(static_cast<std::size_t>(i)) == model::ModeKind::rigid) name += ", rigid";
    else if (i < squares.size()) name += ", " + swinging_at(std::sqrt(std::max(0.0, squares[i])) / (2 * M_PI));
  }
  return names;
}

double factor_for_the_eye(double largest, double diagonal) { return largest > 0 ? 0.1 * diagonal / largest : 1; }

std::vector<ShownColumn> shown_columns(const model::Body& body) {
  const auto& points = body.geometry.points;
  const auto& U = body.basis.U;
  const double diagonal = points.rows() > 0 ? (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm() : 0;
  std::vector<ShownColumn> shown;
  for (const auto& name : column_names(U.cols(), body.modes, body.reduction)) {
    double largest = 0;
    for (Eigen::Index a = 0; a < U.rows(); a += 3)
      largest = std::max(largest, U.col(static_cast<Eigen::Index>(shown.size())).segment<3>(a).norm());
    shown.push_back({name, factor_for_the_eye(largest, diagonal)});
  }
  return shown;
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
