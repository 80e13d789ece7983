#include <algorithm>
#include <map>

#include "read.hpp"
#include "ritz/format/names.hpp"
#include "ritz/format/parts.hpp"
#include "vtkhdf.hpp"
#include "write.hpp"

namespace ritz::format {

namespace {

/// This rank's offsets counted from the first entry of all; the last rank with cells ends them.
std::vector<Index> global_offsets(const model::DrawnCells& cells, const GeometrySlices& slices, bool alone) {
  const auto count = static_cast<Index>(cells.vtk_types.size());
  std::vector<Index> offsets;
  for (Index c = 0; c < count; ++c)
    offsets.push_back(slices.cell_vertices.first + cells.offsets[static_cast<std::size_t>(c)]);
  const bool ends = count > 0 && slices.cells.first + count == slices.cells.total;
  if (ends || (slices.cells.total == 0 && alone)) offsets.push_back(slices.cell_vertices.total);
  return offsets;
}

void write_cells(const ModelWriter& out, const std::string& group, const model::DrawnCells& mine,
                 const GeometrySlices& slices) {
  create_group(out, schema::join(group, "cells"));
  write_rows<std::uint8_t>(out, schema::join(group, schema::cell_types), "1", mine.vtk_types, slices.cells);
  const auto offsets = global_offsets(mine, slices, out.access().writes_small);
  write_rows<Index>(out, schema::join(group, schema::cell_offsets), "1", offsets,
                    {slices.cells.first, slices.cells.total + 1});
  write_rows<Index>(out, schema::join(group, schema::cell_vertices), "1", mine.vertices, slices.cell_vertices);
}

void write_sets(const ModelWriter& out, const std::string& group, const std::vector<model::VertexSet>& sets) {
  for (const auto& set : sets) {
    const auto path = schema::join(schema::join(group, schema::sets), schema::link_name(set.name));
    create_group(out, path);
    write_attribute(out, path, schema::full_count, set.full_count);
    write_vector<Index>(out, schema::join(path, schema::set_rows), "1", set.rows);
  }
}

/// A constant of laws, for all regions: 0 where a region's law has none of that name.
struct Constant {
  fem::Parameter parameter;
  std::vector<double> values;
};

Constant& constant(std::vector<Constant>& all, const fem::Parameter& parameter, std::size_t regions) {
  const auto found = std::ranges::find_if(
      all, [&](const Constant& c) { return std::string_view(c.parameter.name) == parameter.name; });
  if (found != all.end()) return *found;
  return all.emplace_back(parameter, std::vector<double>(regions, 0));
}

void write_materials(const ModelWriter& out, const std::string& group,
                     const std::vector<model::RegionMaterial>& materials) {
  if (materials.empty()) return;
  std::vector<std::string> regions, laws;
  std::vector<double> density;
  std::vector<Constant> constants;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    const auto& [region, material] = materials[i];
    regions.push_back(region);
    laws.emplace_back(fem::name(material.law));
    density.push_back(material.density);
    for (const auto& [parameter, value] : fem::parameters(material.law))
      constant(constants, parameter, materials.size()).values[i] = value;
  }
  const auto path = schema::join(group, schema::materials);
  create_group(out, path);
  write_texts(out, schema::join(path, schema::regions), regions);
  write_texts(out, schema::join(path, schema::laws), laws);
  for (const auto& [parameter, values] : constants)
    write_vector<double>(out, schema::join(path, parameter.name), parameter.units, values);
  write_vector<double>(out, schema::join(path, schema::density), "kg/m^3", density);
}

bool in_range(const std::vector<Index>& rows, Index count) {
  return std::ranges::all_of(rows, [=](Index row) { return 0 <= row && row < count; });
}

/// How many vertices a cell of this VTK type has; 0 for a type that no model has.
Index cell_size(std::uint8_t vtk) {
  if (const auto cell = fem::cell_of_vtk(vtk)) return fem::shape(*cell).vertices;
  if (const auto face = fem::face_of_vtk(vtk)) return fem::shape(*face).vertices;
  return 0;
}

void check_cell_sizes(const ModelReader& in, const std::string& group, const model::DrawnCells& cells) {
  for (std::size_t c = 0; c < cells.vtk_types.size(); ++c) {
    const auto size = cell_size(cells.vtk_types[c]);
    const auto type = std::to_string(cells.vtk_types[c]);
    if (size == 0) fail(in, schema::join(group, schema::cell_types), "has the unknown VTK type " + type);
    if (const auto stored = cells.offsets[c + 1] - cells.offsets[c]; stored != size)
      fail(in, schema::join(group, schema::cell_offsets),
           "gives cell " + std::to_string(c + 1) + " of VTK type " + type + " " + std::to_string(stored) +
               " vertices, not " + std::to_string(size));
  }
}

model::DrawnCells read_cells(const ModelReader& in, const std::string& group, Index points) {
  model::DrawnCells cells;
  cells.vtk_types = read_vector<std::uint8_t>(in, schema::join(group, schema::cell_types));
  const auto offsets = schema::join(group, schema::cell_offsets);
  const auto vertices = schema::join(group, schema::cell_vertices);
  cells.offsets = read_vector<Index>(in, offsets, static_cast<Index>(cells.vtk_types.size()) + 1);
  cells.vertices = read_vector<Index>(in, vertices);
  const auto entries = static_cast<Index>(cells.vertices.size());
  if (cells.offsets.front() != 0 || cells.offsets.back() != entries || !std::ranges::is_sorted(cells.offsets))
    fail(in, offsets, "does not ascend from 0 to the number of entries of " + vertices);
  if (!in_range(cells.vertices, points)) fail(in, vertices, "names vertices that are not stored");
  check_cell_sizes(in, group, cells);
  return cells;
}

std::vector<model::VertexSet> read_sets(const ModelReader& in, const std::string& group, Index points) {
  std::vector<model::VertexSet> sets;
  for (const auto& link : links(in, schema::join(group, schema::sets))) {
    const auto path = schema::join(schema::join(group, schema::sets), link);
    const auto rows = schema::join(path, schema::set_rows);
    sets.push_back(
        {schema::name_of_link(link), read_vector<Index>(in, rows), read_index(in, path, schema::full_count)});
    const auto& [name, stored, full_count] = sets.back();
    if (!in_range(stored, points)) fail(in, rows, "names vertices that are not stored");
    if (std::ranges::adjacent_find(stored, std::ranges::greater_equal{}) != stored.end())
      fail(in, rows, "does not ascend");
    if (full_count < std::ssize(stored)) fail(in, path, "stores more vertices than the set has");
  }
  return sets;
}

}  // namespace

GeometrySlices whole(const model::Geometry& geometry) {
  return {{0, geometry.points.rows()},
          {0, static_cast<Index>(geometry.cells.vtk_types.size())},
          {0, static_cast<Index>(geometry.cells.vertices.size())}};
}

void write_geometry(ModelWriter& out, const model::Geometry& mine, const GeometrySlices& slices,
                    std::string_view body) {
  const auto group = schema::body_part(body, schema::geometry);
  create_group(out, group);
  write_attribute(out, group, schema::rows, name(mine.rows));
  write_attribute(out, group, schema::full_vertices, mine.full_vertices);
  const std::span<const double> points(mine.points.data(), static_cast<std::size_t>(mine.points.size()));
  write_rows<double>(out, schema::join(group, schema::points), "m", points, slices.vertices, 3);
  write_rows<Index>(out, schema::join(group, schema::vertex_ids), "1", mine.vertex_ids, slices.vertices);
  write_cells(out, group, mine.cells, slices);
  write_sets(out, group, mine.sets);
  write_materials(out, group, mine.materials);
  write_grid(out, body, slices);
}

std::vector<model::RegionMaterial> read_materials(const ModelReader& in, std::string_view body) {
  std::vector<model::RegionMaterial> materials;
  const auto path = schema::join(schema::body_part(body, schema::geometry), schema::materials);
  if (!exists(in, path)) return materials;
  const auto regions = read_texts(in, schema::join(path, schema::regions));
  const auto count = static_cast<Index>(regions.size());
  const auto of_laws = schema::join(path, schema::laws);  // since version 1.2
  const auto laws =
      exists(in, of_laws) ? read_texts(in, of_laws) : std::vector<std::string>(regions.size(), fem::default_law);
  if (laws.size() != regions.size()) fail(in, of_laws, "has not one entry a region");
  const auto density = read_vector<double>(in, schema::join(path, schema::density), count);
  std::map<std::string, std::vector<double>> constants;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const auto law = fem::make_law(laws[i], [&](const fem::Parameter& parameter) {
      auto& values = constants[parameter.name];
      if (values.empty()) values = read_vector<double>(in, schema::join(path, parameter.name), count);
      return values[i];
    });
    if (!law) fail(in, of_laws, "gives region '" + regions[i] + "' the unknown law '" + laws[i] + "'");
    if (!(density[i] > 0) || !std::ranges::all_of(fem::parameters(*law), &fem::ParameterValue::possible))
      fail(in, path, "gives region '" + regions[i] + "' a material that cannot be");
    materials.push_back({regions[i], {*law, density[i]}});
  }
  return materials;
}

model::Geometry read_geometry(const ModelReader& in, std::string_view body) {
  const auto group = schema::body_part(body, schema::geometry);
  if (!exists(in, group)) fail(in, group, "is missing");
  model::Geometry geometry;
  if (!parse(read_text(in, group, schema::rows), geometry.rows)) fail(in, group, "stores an unknown kind of rows");
  geometry.full_vertices = read_index(in, group, schema::full_vertices);
  geometry.points = read_matrix(in, schema::join(group, schema::points), any, 3);
  const Index points = geometry.points.rows();
  if (geometry.full_vertices < points) fail(in, group, "stores more vertices than the mesh has");
  geometry.vertex_ids = read_vector<Index>(in, schema::join(group, schema::vertex_ids), points);
  geometry.cells = read_cells(in, group, points);
  geometry.sets = read_sets(in, group, points);
  geometry.materials = read_materials(in, body);
  return geometry;
}

}  // namespace ritz::format
