#include <algorithm>

#include "read.hpp"
#include "ritz/format/names.hpp"
#include "ritz/format/parts.hpp"
#include "write.hpp"

namespace ritz::format {
namespace {

constexpr Index figures = 6;  ///< of an error: mean square and largest, of training, lifts and statics

model::RowMatrix figures_of(const std::vector<model::CubatureError>& errors) {
  model::RowMatrix rows(std::ssize(errors), figures);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const auto& [cells, training, lifts, statics] = errors[i];
    rows.row(static_cast<Index>(i)) << training.root_mean_square, training.largest, lifts.root_mean_square,
        lifts.largest, statics.root_mean_square, statics.largest;
  }
  return rows;
}

std::vector<model::CubatureError> read_errors(const ModelReader& in, const std::string& group) {
  const auto cells = read_vector<Index>(in, schema::join(group, schema::error_cells));
  const auto rows = read_matrix(in, schema::join(group, schema::error_figures), std::ssize(cells), figures);
  require((rows.array() >= 0).all(), in, group, "an error is negative");
  std::vector<model::CubatureError> errors;
  for (Index i = 0; i < rows.rows(); ++i)
    errors.push_back({cells[static_cast<std::size_t>(i)],
                      {rows(i, 0), rows(i, 1)},
                      {rows(i, 2), rows(i, 3)},
                      {rows(i, 4), rows(i, 5)}});
  return errors;
}

void check_cells(const ModelReader& in, const std::string& group, const model::Cubature& cubature) {
  const auto ascend = [](const auto& values) {
    return std::ranges::adjacent_find(values, std::greater_equal()) == values.end();
  };
  require(!cubature.cells.empty(), in, group, "the cubature has no cells");
  require(ascend(cubature.cells), in, group, "the numbers of the cells do not ascend");
  require(cubature.weights.minCoeff() > 0, in, group, "a weight is not positive");
  require(cubature.starts.front() == 0 && ascend(cubature.starts), in, group,
          "the points of the cells do not follow each other");
  require(std::ranges::all_of(cubature.regions, [](Index region) { return region >= 0; }), in, group,
          "a region is negative");
  require(cubature.largest_energy > 0, in, group, "the energy of the training is not positive");
}

}  // namespace

void write_cubature(ModelWriter& out, const model::Cubature& cubature, std::string_view body) {
  raise_version(out, schema::with_cubature);
  const auto group = schema::body_part(body, schema::cubature);
  create_group(out, group);
  write_attribute(out, group, schema::integrand, name(cubature.integrand));
  write_attribute(out, group, schema::largest_energy, cubature.largest_energy);
  write_vector<Index>(out, schema::join(group, schema::numbers), "1", cubature.cells);
  write_vector<double>(out, schema::join(group, schema::weights), "1", view(cubature.weights));
  write_vector<Index>(out, schema::join(group, schema::cell_regions), "1", cubature.regions);
  write_vector<Index>(out, schema::join(group, schema::starts), "1", cubature.starts);
  write_vector<double>(out, schema::join(group, schema::volumes), "m^3", view(cubature.volumes));
  write_matrix(out, schema::join(group, schema::gradients), "1/(m kg^1/2)", cubature.gradients);
  std::vector<Index> cells;
  for (const auto& error : cubature.errors) cells.push_back(error.cells);
  create_group(out, schema::join(group, "errors"));
  write_vector<Index>(out, schema::join(group, schema::error_cells), "1", cells);
  write_matrix(out, schema::join(group, schema::error_figures), "1", figures_of(cubature.errors));
}

std::optional<model::Cubature> read_cubature(const ModelReader& in, std::string_view body) {
  const auto group = schema::body_part(body, schema::cubature);
  if (!exists(in, group)) return {};
  model::Cubature cubature;
  if (!parse(read_text(in, group, schema::integrand), cubature.integrand)) fail(in, group, "has an unknown integrand");
  cubature.largest_energy = read_double(in, group, schema::largest_energy);
  cubature.cells = read_vector<Index>(in, schema::join(group, schema::numbers));
  const auto count = std::ssize(cubature.cells);
  cubature.weights = read_column(in, schema::join(group, schema::weights), count);
  cubature.regions = read_vector<Index>(in, schema::join(group, schema::cell_regions), count);
  cubature.starts = read_vector<Index>(in, schema::join(group, schema::starts), count + 1);
  check_cells(in, group, cubature);
  cubature.volumes = read_column(in, schema::join(group, schema::volumes), cubature.starts.back());
  cubature.gradients = read_matrix(in, schema::join(group, schema::gradients), 9 * cubature.volumes.size(), any);
  cubature.errors = read_errors(in, group);
  return cubature;
}

}  // namespace ritz::format
