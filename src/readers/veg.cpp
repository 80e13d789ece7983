#include "ritz/readers/formats.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "ritz/readers/listed.hpp"
#include "ritz/readers/source.hpp"

namespace ritz::readers {

namespace {

struct VegRegion {
  std::string set;
  std::string material;
  Place place;
};

struct VegFile {
  Lines lines;
  ListedMesh mesh;
  std::map<std::string, std::vector<std::pair<Index, Place>>> sets;  ///< element numbers as in the file
  std::vector<std::string> set_order;
  std::map<std::string, FileMaterial> materials;
  std::vector<VegRegion> regions;
  Place last;
};

// The next line that says something; included files are gone into.
std::optional<Line> next_line(VegFile& veg) {
  constexpr std::string_view include = "*INCLUDE";
  while (const auto line = veg.lines.next()) {
    if (line->text.empty() || line->text.front() == '#') continue;
    veg.last = line->place;
    if (!line->text.starts_with(include)) return line;
    veg.lines.include(trimmed(line->text.substr(include.size())), line->place);
  }
  return std::nullopt;
}

Line need_line(VegFile& veg, const std::string& what) {
  const auto line = next_line(veg);
  if (!line) veg.lines.fail(veg.last, "expected " + what + ", found the end of the file");
  if (line->text.front() == '*') {
    veg.lines.fail(line->place, "expected " + what + ", found '" + std::string(line->text.substr(0, 24)) + "'");
  }
  return *line;
}

// "COUNT SIZE ...": how many lines follow and how many numbers each has after its own.
Index read_count(VegFile& veg, const std::string& what, Index size) {
  const auto line = need_line(veg, "the number of " + what);
  auto cursor = veg.lines.cursor(line);
  const Index count = cursor.integer("the number of " + what);
  const Index stated = cursor.line_ends() ? size : cursor.integer("how many numbers each has");
  if (count < 0) cursor.fail("the number of " + what + " is negative");
  if (stated != size) cursor.fail(what + " must have " + std::to_string(size) + " numbers each");
  return count;
}

// Numbers must count up from 0 or from 1.
void check_number(const Cursor& cursor, Index number, Index position, const std::vector<Index>& ids) {
  const Index expected = position == 0 ? (number == 0 ? 0 : 1) : ids.front() + position;
  if (number != expected) {
    cursor.fail("expected number " + std::to_string(expected) + ", found " + std::to_string(number) +
                "; Vega's vertices and elements are numbered without gaps from 0 or 1");
  }
}

void read_vertices(VegFile& veg) {
  if (!veg.mesh.points.empty()) veg.lines.fail(veg.last, "*VERTICES stands twice in the file");
  const Index count = read_count(veg, "vertices", 3);
  for (Index i = 0; i < count; ++i) {
    const auto line = need_line(veg, "vertex " + std::to_string(i + 1) + " of " + std::to_string(count));
    auto cursor = veg.lines.cursor(line);
    const Index id = cursor.integer("a vertex number");
    check_number(cursor, id, i, veg.mesh.vertex_ids);
    std::array<double, 3> point;
    for (double& x : point) x = cursor.real("a coordinate");
    cursor.end_line();
    add_vertex(veg.mesh, id, point, line.place);
  }
}

Shape read_shape(VegFile& veg) {
  const auto line = need_line(veg, "TET or CUBIC");
  if (line.text.starts_with("TET")) return Shape::of(fem::CellType::tet4);
  if (line.text.starts_with("CUBIC")) return Shape::of(fem::CellType::hex8);
  veg.lines.fail(line.place, "expected TET or CUBIC, found '" + std::string(line.text.substr(0, 24)) + "'");
}

void read_elements(VegFile& veg) {
  if (!veg.mesh.shapes.empty()) veg.lines.fail(veg.last, "*ELEMENTS stands twice in the file");
  const auto shape = read_shape(veg);
  const Index size = shape.vertices;
  const Index count = read_count(veg, "elements", size);
  for (Index i = 0; i < count; ++i) {
    const auto line = need_line(veg, "element " + std::to_string(i + 1) + " of " + std::to_string(count));
    auto cursor = veg.lines.cursor(line);
    const Index id = cursor.integer("an element number");
    check_number(cursor, id, i, veg.mesh.cell_ids);
    std::array<Index, fem::max_cell_vertices> storage;
    const auto vertices = std::span(storage).first(static_cast<std::size_t>(size));
    for (Index& vertex : vertices) vertex = cursor.integer("a vertex number");
    cursor.end_line();
    add_cell(veg.mesh, shape, id, vertices, line.place);
  }
}

/// The numbers of a material, of which there must be one of `counts`.
std::vector<double> constants_of(VegFile& veg, Cursor& cursor, std::string_view law,
                                 std::initializer_list<std::size_t> counts) {
  std::vector<double> values;
  while (!cursor.line_ends()) values.push_back(cursor.real("a constant of the law"));
  if (std::find(counts.begin(), counts.end(), values.size()) == counts.end())
    veg.lines.fail(cursor.place(), std::string(law) + " has " + std::to_string(*counts.begin()) +
                                       " numbers, the density first; there are " + std::to_string(values.size()));
  return values;
}

/// "density, mu01, mu10, v1": W = mu10 (Ī₁ − 3) + mu01 (Ī₂ − 3) + v1 (J − 1)².
fem::AnyLaw mooney_rivlin(const std::vector<double>& c) { return fem::MooneyRivlin{c[2], c[1], 1 / c[3]}; }

/// "density, E1, E2, E3, nu12, nu23, nu31, G12, G23, G31" and perhaps nine numbers of a rotation, row by row, whose
/// columns are the axes; ν₁₃ = ν₃₁ E₁/E₃.
fem::AnyLaw orthotropic(const std::vector<double>& c) {
  fem::OrthotropicStVK::Values values{c[1], c[2], c[3], c[4], c[6] * c[1] / c[3], c[5], c[7], c[9], c[8], 1, 0,
                                      0,    0,    1,    0};
  if (c.size() > 10) {
    const double* R = c.data() + 10;
    for (std::size_t i = 0; i < 3; ++i) {
      values[9 + i] = R[3 * i];
      values[12 + i] = R[3 * i + 1];
    }
  }
  return fem::OrthotropicStVK(values);
}

void read_material(VegFile& veg, const std::string& name) {
  const auto line = need_line(veg, "the specification of material '" + name + "'");
  const auto comma = line.text.find(',');
  const std::string law(trimmed(line.text.substr(0, comma)));
  if (law.empty() || comma == std::string_view::npos)
    veg.lines.fail(line.place, "expected a law, a comma and its constants: ENU, density, E, nu");
  const auto values = line.text.substr(comma);
  auto cursor =
      veg.lines.cursor({.place = {.file = line.place.file, .offset = line.place.offset + comma}, .text = values});
  FileMaterial material;
  if (law == "ENU") {
    const auto c = constants_of(veg, cursor, law, {3});
    material = {.young = c[1], .poisson = c[2], .density = c[0]};
  } else if (law == "MOONEYRIVLIN") {
    const auto c = constants_of(veg, cursor, law, {4});
    material = {.density = c[0], .law = mooney_rivlin(c)};
  } else if (law == "ORTHOTROPIC" || law == "ORTHOTROPIC_N3G3" || law == "ORTHOTROPIC_N3G3R9") {
    const auto c = constants_of(veg, cursor, law, {10, 19});
    material = {.density = c[0], .law = orthotropic(c)};
  } else {
    const double first = cursor.real("the density");
    while (!cursor.line_ends()) cursor.real("a constant of the law");
    if (law.starts_with("ORTHOTROPIC")) material.density = first;
    material.unread_law = located(veg.lines.sources(), line.place) + "material law " + law.substr(0, 32) +
                          " is not supported; ritz knows ENU, MOONEYRIVLIN and ORTHOTROPIC with all its constants";
  }
  veg.materials[name] = checked(veg.lines.sources(), line.place, material);
  if (material.law) possible(veg.lines.sources(), line.place, *material.law);
}

void read_region(VegFile& veg) {
  const auto line = need_line(veg, "a set and a material");
  const auto comma = line.text.find(',');
  if (comma == std::string_view::npos) veg.lines.fail(line.place, "expected a set, a comma and a material");
  veg.regions.push_back({.set = std::string(trimmed(line.text.substr(0, comma))),
                         .material = std::string(trimmed(line.text.substr(comma + 1))),
                         .place = line.place});
}

void begin_set(VegFile& veg, const std::string& name) {
  if (name.empty()) veg.lines.fail(veg.last, "*SET has no name");
  if (name == "allElements" || veg.sets.contains(name)) {
    veg.lines.fail(veg.last, "set '" + name + "' is defined twice or has a name of Vega's own");
  }
  veg.sets[name];
  veg.set_order.push_back(name);
}

void read_set_line(VegFile& veg, const Line& line) {
  auto cursor = veg.lines.cursor(line);
  while (!cursor.line_ends()) {
    const auto place = cursor.place();
    veg.sets[veg.set_order.back()].emplace_back(cursor.integer("an element number"), place);
  }
}

// A keyword that is not Vega's, on the user's word; its lines go with it.
void leave_out_keyword(VegFile& veg, const Line& line, std::string_view keyword, const Ignored& ignored) {
  const std::string shown(keyword.substr(0, 24));
  leave_out(veg.lines.sources(), line.place, upper(keyword.substr(1)),
            shown + " is none of *VERTICES, *ELEMENTS, *MATERIAL, *SET, *REGION and *INCLUDE, which Vega has", ignored,
            veg.mesh);
}

enum class VegLines { none, set, left_out };

void read_sections(VegFile& veg, const Ignored& ignored) {
  auto more = VegLines::none;
  while (const auto line = next_line(veg)) {
    const auto text = line->text;
    const auto keyword = text.substr(0, text.find_first_of(" \t,"));
    const std::string rest(trimmed(text.substr(keyword.size())));
    if (more != VegLines::none && text.front() != '*') {
      if (more == VegLines::set) read_set_line(veg, *line);
      continue;
    }
    more = keyword == "*SET" ? VegLines::set : VegLines::none;
    if (keyword == "*VERTICES") read_vertices(veg);
    else if (keyword == "*ELEMENTS") read_elements(veg);
    else if (keyword == "*MATERIAL") read_material(veg, rest);
    else if (keyword == "*SET") begin_set(veg, rest);
    else if (keyword == "*REGION") read_region(veg);
    else if (text.front() == '*') {
      leave_out_keyword(veg, *line, keyword, ignored);
      more = VegLines::left_out;
    } else {
      veg.lines.fail(line->place, "expected *VERTICES, *ELEMENTS, *MATERIAL, *SET, *REGION or *INCLUDE, found '" +
                                      std::string(text.substr(0, 24)) + "' (more entries than stated?)");
    }
  }
}

void resolve_sets(VegFile& veg) {
  auto& mesh = veg.mesh;
  ListedSet all{.name = "allElements", .vertices = {}, .cells = {}, .faces = {}};
  all.cells.resize(mesh.shapes.size());
  std::iota(all.cells.begin(), all.cells.end(), Index{0});
  mesh.sets.push_back(std::move(all));
  const Index base = mesh.cell_ids.empty() ? 1 : mesh.cell_ids.front();
  const auto count = static_cast<Index>(mesh.cell_ids.size());
  for (const auto& name : veg.set_order) {
    ListedSet set{.name = name, .vertices = {}, .cells = {}, .faces = {}};
    for (const auto& [number, place] : veg.sets[name]) {
      if (number < base || number - base >= count) {
        veg.lines.fail(place, "set '" + name + "' names element " + std::to_string(number) + ", which does not exist");
      }
      set.cells.push_back(number - base);
    }
    mesh.sets.push_back(std::move(set));
  }
}

void resolve_regions(VegFile& veg) {
  auto& mesh = veg.mesh;
  for (const auto& region : veg.regions) {
    const auto material = veg.materials.find(region.material);
    if (material == veg.materials.end()) {
      veg.lines.fail(region.place, "the region's material '" + region.material + "' is not defined in the file");
    }
    const auto set =
        std::find_if(mesh.sets.begin(), mesh.sets.end(), [&](const auto& s) { return s.name == region.set; });
    if (set == mesh.sets.end()) {
      veg.lines.fail(region.place, "the region's set '" + region.set + "' is not defined in the file");
    }
    for (const Index cell : set->cells) {
      mesh.cell_regions[static_cast<std::size_t>(cell)] = static_cast<std::int32_t>(mesh.regions.size());
    }
    mesh.regions.push_back({.name = region.set, .material = material->second});
  }
}

}  // namespace

FileMesh read_veg(Sources& sources, unsigned file, const Ignored& ignored) {
  VegFile veg{.lines = Lines(sources, file),
              .mesh = {},
              .sets = {},
              .set_order = {},
              .materials = {},
              .regions = {},
              .last = {.file = file, .offset = 0}};
  read_sections(veg, ignored);
  resolve_sets(veg);
  resolve_regions(veg);
  return finish(sources, std::move(veg.mesh));
}

}  // namespace ritz::readers
