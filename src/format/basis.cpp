#include <algorithm>
#include <array>
#include <numeric>

#include "collective.hpp"
#include "read.hpp"
#include "ritz/format/parts.hpp"
#include "vtkhdf.hpp"
#include "write.hpp"

namespace ritz::format {

namespace {

constexpr auto units = "kg^-1/2";

std::string column_path(const std::string& group, Index column) {
  return schema::join(schema::join(group, schema::columns), schema::column_name(column));
}

/// HDF5 takes the name of a view's source for a pattern, in which %% is a plain %.
std::string as_pattern(const std::string& path) {
  std::string pattern;
  for (const char c : path) pattern.append(c == '%' ? 2 : 1, c);
  return pattern;
}

/// The dataset U (3n x r) for NumPy's users: a view of the columns, which holds no numbers of its own.
void write_view(const ModelWriter& out, const std::string& group, Index columns, Index vertices) {
  const Quiet quiet;
  const auto n = static_cast<hsize_t>(vertices);
  const std::array<hsize_t, 2> stored{n, 3}, shown{3 * n, static_cast<hsize_t>(columns)}, height{3 * n, 1};
  const Space source(H5Screate_simple(2, stored.data(), nullptr));
  const Space view(H5Screate_simple(2, shown.data(), nullptr));
  const Properties properties(H5Pcreate(H5P_DATASET_CREATE));
  H5Pset_obj_track_times(properties.get(), false);
  H5Pset_alloc_time(properties.get(), H5D_ALLOC_TIME_EARLY);  // HDF5's flavours differ in their default
  bool ok = true;
  for (Index column = 0; column < columns; ++column) {
    const std::array<hsize_t, 2> start{0, static_cast<hsize_t>(column)};
    H5Sselect_hyperslab(view.get(), H5S_SELECT_SET, start.data(), nullptr, height.data(), nullptr);
    const auto path = as_pattern(column_path(group, column));
    ok = ok && H5Pset_virtual(properties.get(), view.get(), ".", path.c_str(), source.get()) >= 0;
  }
  const auto path = schema::join(group, schema::U);
  H5Sselect_all(view.get());
  const Dataset dataset(H5Dcreate2(out.file(), path.c_str(), hdf5_type<double>(), view.get(), H5P_DEFAULT,
                                   properties.get(), H5P_DEFAULT));
  agree(out, ok && dataset, path);
  write_attribute(out, path, schema::units, std::string_view(units));
}

std::vector<Index> chosen(const std::optional<std::vector<Index>>& selection, Index count) {
  if (selection) return *selection;
  std::vector<Index> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

void check_chosen(const ModelReader& in, const std::string& path, const std::vector<Index>& rows, Index count) {
  for (const auto row : rows)
    if (row < 0 || row >= count)
      fail(in, path, "has no number " + std::to_string(row) + ", only 0 to " + std::to_string(count - 1));
}

}  // namespace

void write_basis(ModelWriter& out, const std::vector<ShownColumn>& shown, Index my_vertices, Slice vertices,
                 const ColumnSource& source, std::string_view body) {
  const auto group = schema::body_part(body, schema::basis);
  const auto columns = static_cast<Index>(shown.size());
  create_group(out, schema::join(group, schema::columns));
  write_attribute(out, group, schema::column_count, columns);
  std::vector<double> values(static_cast<std::size_t>(3 * my_vertices));
  for (Index column = 0; column < columns; ++column) {
    source(column, values);
    write_rows<double>(out, column_path(group, column), units, values, vertices, 3);
    write_point_vector(out, body, shown[static_cast<std::size_t>(column)], values, vertices);
  }
  if (columns > 0 && vertices.total > 0) write_view(out, group, columns, vertices.total);
}

void write_basis(ModelWriter& out, const model::Basis& mine, const std::vector<ShownColumn>& columns, Slice vertices,
                 std::string_view body) {
  const auto take = [&](Index column, std::span<double> values) {
    Eigen::Map<Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())) = mine.U.col(column);
  };
  write_basis(out, columns, mine.U.rows() / 3, vertices, take, body);
}

BasisSize basis_size(const ModelReader& in, std::string_view body) {
  const auto group = schema::body_part(body, schema::basis);
  if (!exists(in, group)) fail(in, group, "is missing");
  const auto columns = read_index(in, group, schema::column_count);
  if (columns < 0 || columns != static_cast<Index>(links(in, schema::join(group, schema::columns)).size()))
    fail(in, group, "does not have the " + std::to_string(columns) + " columns that it claims");
  if (columns == 0) return {0, 0};
  const auto shape = stored_shape(in, column_path(group, 0));
  if (shape.size() != 2 || shape[1] != 3) fail(in, column_path(group, 0), "is not a list of vectors");
  const auto points = schema::join(schema::body_part(body, schema::geometry), schema::points);
  if (exists(in, points)) {
    const auto places = stored_shape(in, points);
    if (places.size() != 2 || places[1] != 3) fail(in, points, "is not a list of places");
    if (places.front() != shape.front()) fail(in, group, "does not have the vertices of the geometry");
  }
  return {shape.front(), columns};
}

model::Basis read_basis(const ModelReader& in, const BasisSelection& selection, std::string_view body) {
  const auto group = schema::body_part(body, schema::basis);
  const auto size = basis_size(in, body);
  const auto columns = chosen(selection.columns, size.columns);
  const auto vertices = chosen(selection.vertices, size.vertices);
  check_chosen(in, schema::join(group, schema::columns), columns, size.columns);
  check_chosen(in, column_path(group, 0), vertices, size.vertices);

  model::Basis basis;
  basis.U.resize(static_cast<Eigen::Index>(3 * vertices.size()), static_cast<Eigen::Index>(columns.size()));
  if (basis.U.size() == 0) return basis;
  const auto [low, high] = std::ranges::minmax(vertices);
  model::Points block(high - low + 1, 3);
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const StoredArray array(in, column_path(group, columns[j]));
    array.expect({size.vertices, 3}, hdf5_type<double>());
    array.read(low, block.rows(), block.data());
    require_finite(in, column_path(group, columns[j]), {block.data(), static_cast<std::size_t>(block.size())});
    auto column = basis.U.col(static_cast<Eigen::Index>(j));
    for (std::size_t i = 0; i < vertices.size(); ++i)
      column.segment<3>(static_cast<Eigen::Index>(3 * i)) = block.row(vertices[i] - low).transpose();
  }
  return basis;
}

}  // namespace ritz::format
