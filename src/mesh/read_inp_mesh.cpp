// *NODE and *ELEMENT.
#include <algorithm>

#include "ritz/mesh/read_inp_model.hpp"

namespace ritz::mesh {
namespace {

struct InpType {
  std::string_view name;
  Shape shape;
};

// Lower-dimensional elements only carry sets.
constexpr InpType types[] = {
    {"C3D4", Shape::tet4},    {"C3D10", Shape::tet10},   {"C3D8", Shape::hex8},   {"CPS3", Shape::tri3},
    {"CPE3", Shape::tri3},    {"CAX3", Shape::tri3},     {"S3", Shape::tri3},     {"S3R", Shape::tri3},
    {"STRI3", Shape::tri3},   {"M3D3", Shape::tri3},     {"SFM3D3", Shape::tri3}, {"R3D3", Shape::tri3},
    {"CPS6", Shape::tri6},    {"CPE6", Shape::tri6},     {"CAX6", Shape::tri6},   {"S6", Shape::tri6},
    {"STRI65", Shape::tri6},  {"M3D6", Shape::tri6},     {"SFM3D6", Shape::tri6}, {"CPS4", Shape::quad4},
    {"CPE4", Shape::quad4},   {"CAX4", Shape::quad4},    {"S4", Shape::quad4},    {"CPS4R", Shape::quad4},
    {"CPE4R", Shape::quad4},  {"S4R", Shape::quad4},     {"M3D4", Shape::quad4},  {"M3D4R", Shape::quad4},
    {"SFM3D4", Shape::quad4}, {"SFM3D4R", Shape::quad4}, {"R3D4", Shape::quad4},  {"T3D2", Shape::line2},
    {"B31", Shape::line2},    {"B31R", Shape::line2},    {"T2D2", Shape::line2},  {"B21", Shape::line2},
    {"T3D3", Shape::line3},   {"B32", Shape::line3},     {"B32R", Shape::line3},  {"T2D3", Shape::line3}};

Shape shape_of(const Deck& deck, const Keyword& keyword) {
  const auto name = upper(needed(deck, keyword, "TYPE"));
  const auto type = std::find_if(std::begin(types), std::end(types), [&](const auto& t) { return t.name == name; });
  if (type == std::end(types)) {
    deck.fail(keyword.place, "element type " + name + " is not supported; ritz has C3D4, C3D10 and C3D8");
  }
  return type->shape;
}

// The numbers of an element; they go on in the next line after a comma at the end of one.
void read_vertices(Deck& deck, Line line, Cursor cursor, Index id, std::span<Index> vertices) {
  for (Index& vertex : vertices) {
    while (cursor.line_ends()) {
      const auto more = line.text.ends_with(',') ? deck.next_data() : std::nullopt;
      if (!more) {
        deck.fail(line.place, "element " + std::to_string(id) + " has too few vertices; its type needs " +
                                  std::to_string(vertices.size()));
      }
      line = *more;
      cursor = deck.cursor(line);
    }
    vertex = cursor.integer("a vertex number");
  }
  cursor.end_line();
}

// The set that a keyword's parameter names, if it has one.
InpSet* parameter_set(InpSets& sets, const Keyword& keyword, std::string_view parameter) {
  const auto name = keyword.value(parameter);
  return name ? &sets.sets[sets.made(*name)] : nullptr;
}

}  // namespace

void read_inp_node(Deck& deck, const Keyword& keyword, InpModel& model) {
  if (upper(keyword.value("SYSTEM").value_or("R")) != "R") {
    deck.fail(keyword.place, "only rectangular coordinates (SYSTEM=R) are supported");
  }
  auto* const set = parameter_set(model.node_sets, keyword, "NSET");
  while (const auto line = deck.next_data()) {
    auto cursor = deck.cursor(*line);
    const Index id = cursor.integer("a vertex number");
    std::array<double, 3> point;
    for (double& x : point) x = cursor.real("a coordinate");
    cursor.end_line();
    if (set) set->positions.push_back(static_cast<Index>(model.mesh.points.size()));
    add_vertex(model.mesh, id, point, line->place);
  }
}

void read_inp_element(Deck& deck, const Keyword& keyword, InpModel& model) {
  const auto shape = shape_of(deck, keyword);
  auto* const set = parameter_set(model.element_sets, keyword, "ELSET");
  std::array<Index, fem::max_cell_vertices> storage;
  const auto vertices = std::span(storage).first(static_cast<std::size_t>(traits(shape).vertices));
  while (const auto line = deck.next_data()) {
    auto cursor = deck.cursor(*line);
    const Index id = cursor.integer("an element number");
    read_vertices(deck, *line, cursor, id, vertices);
    if (set) set->positions.push_back(static_cast<Index>(model.mesh.shapes.size()));
    add_cell(model.mesh, shape, id, vertices, line->place);
  }
}

}  // namespace ritz::mesh
