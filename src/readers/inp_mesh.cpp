#include "ritz/readers/inp_model.hpp"

#include <algorithm>

namespace ritz::readers {

namespace {

struct Known {
  std::string_view name;
  Shape shape;
};

constexpr Shape tri3 = Shape::of(fem::FaceType::tri3), tri6 = Shape::of(fem::FaceType::tri6),
                quad4 = Shape::of(fem::FaceType::quad4), quad8 = Shape::of(fem::FaceType::quad8);

constexpr Known lower[] = {
    {"CPS3", tri3},    {"CPE3", tri3},     {"CPE3H", tri3},  {"CAX3", tri3},    {"S3", tri3},       {"S3R", tri3},
    {"S3RS", tri3},    {"STRI3", tri3},    {"M3D3", tri3},   {"SFM3D3", tri3},  {"R3D3", tri3},     {"CPS6", tri6},
    {"CPE6", tri6},    {"CAX6", tri6},     {"S6", tri6},     {"STRI65", tri6},  {"M3D6", tri6},     {"SFM3D6", tri6},
    {"CPS4", quad4},   {"CPE4", quad4},    {"CAX4", quad4},  {"S4", quad4},     {"CPS4R", quad4},   {"CPE4R", quad4},
    {"CAX4R", quad4},  {"CPS4I", quad4},   {"CPE4I", quad4}, {"CPE4H", quad4},  {"S4R", quad4},     {"S4RS", quad4},
    {"S4R5", quad4},   {"M3D4", quad4},    {"M3D4R", quad4}, {"SFM3D4", quad4}, {"SFM3D4R", quad4}, {"R3D4", quad4},
    {"CPS8", quad8},   {"CPE8", quad8},    {"CAX8", quad8},  {"S8", quad8},     {"CPS8R", quad8},   {"CPE8R", quad8},
    {"CAX8R", quad8},  {"CPE8H", quad8},   {"S8R", quad8},   {"S8R5", quad8},   {"M3D8", quad8},    {"M3D8R", quad8},
    {"SFM3D8", quad8}, {"SFM3D8R", quad8}, {"T3D2", line2},  {"B31", line2},    {"B31R", line2},    {"T2D2", line2},
    {"B21", line2},    {"B33", line2},     {"T3D3", line3},  {"B32", line3},    {"B32R", line3},    {"T2D3", line3}};

struct Suffix {
  std::string_view name;
  std::string_view formulation;
};

// T adds temperatures to the same displacements.
constexpr Suffix of_tetrahedra[] = {{"T", ""},
                                    {"H", "hybrid"},
                                    {"HT", "hybrid"},
                                    {"M", "modified"},
                                    {"MT", "modified"},
                                    {"MH", "modified and hybrid"},
                                    {"MHT", "modified and hybrid"},
                                    {"HS", "hybrid, improved stresses"},
                                    {"I", "improved stresses"}};

constexpr Suffix of_hexahedra[] = {{"T", ""},
                                   {"R", "reduced integration"},
                                   {"RT", "reduced integration"},
                                   {"RH", "reduced integration, hybrid"},
                                   {"RHT", "reduced integration, hybrid"},
                                   {"H", "hybrid"},
                                   {"HT", "hybrid"},
                                   {"I", "incompatible modes"},
                                   {"IH", "incompatible modes, hybrid"},
                                   {"S", "improved stresses"},
                                   {"HS", "hybrid, improved stresses"}};

constexpr Suffix of_wedges[] = {{"T", ""}, {"H", "hybrid"}, {"HT", "hybrid"}, {"R", "reduced integration"}};

struct Solid {
  std::string_view name;
  fem::CellType type;
  InpReading other;  // formulations
  std::span<const Suffix> suffixes;
  std::string_view points = {};  // of the plain element, where others are another thing
};

// A quadratic tetrahedron bends well in any formulation; a hexahedron with reduced integration is another thing.
constexpr Solid solids[] = {
    {"C3D4", fem::CellType::tet4, InpReading::noted, of_tetrahedra},
    {"C3D10", fem::CellType::tet10, InpReading::noted, of_tetrahedra},
    {"C3D8", fem::CellType::hex8, InpReading::on_your_word, of_hexahedra,
     "2 x 2 x 2 points, much stiffer in bending than one of reduced integration or incompatible modes"},
    {"C3D20", fem::CellType::hex20, InpReading::on_your_word, of_hexahedra,
     "3 x 3 x 3 points, stiffer than one of reduced integration"},
    {"C3D6", fem::CellType::wedge6, InpReading::noted, of_wedges},
    {"C3D15", fem::CellType::wedge15, InpReading::noted, of_wedges},
    {"C3D5", fem::CellType::pyramid5, InpReading::noted, of_wedges}};

struct Family {
  std::string_view begin;
  std::string_view keyword;
};

constexpr Family families[] = {{"MASS", "MASS"},     {"ROTARYI", "ROTARYINERTIA"},
                               {"SPRING", "SPRING"}, {"DASHPOT", "DASHPOT"},
                               {"GAP", "GAP"},       {"CONN", "CONNECTORSECTION"}};

}  // namespace

InpType inp_type(const std::string& name) {
  for (const auto& solid : solids) {
    if (!name.starts_with(solid.name)) continue;
    const std::string plain(solid.name), end = name.substr(solid.name.size());
    const auto shape = Shape::of(solid.type);
    if (end.empty()) return {InpReading::same, shape, plain, {}, solid.points};
    for (const auto& suffix : solid.suffixes)
      if (suffix.name == end)
        return {suffix.formulation.empty() ? InpReading::same : solid.other, shape, plain,
                std::string(suffix.formulation), solid.points};
  }
  for (const auto& type : lower)
    if (type.name == name) return {InpReading::same, type.shape, name, {}, {}};
  return {InpReading::none, point, {}, {}, {}};
}

std::vector<std::string> words_of_type(const std::string& name) {
  for (const auto& [begin, keyword] : families)
    if (name.starts_with(begin)) return {std::string(keyword), name};
  return {name};
}

namespace {

// Data lines in a file of their own.
void refuse_input(const Deck& deck, const Keyword& keyword) {
  if (keyword.has("INPUT"))
    deck.fail(keyword.place, "INPUT= of *" + keyword.title +
                                 " is not supported; write *INCLUDE, INPUT=... in the line after the keyword");
}

// The user's word that another formulation is read as ritz's own.
void accept(const Deck& deck, Place place, const std::string& name, const InpType& type, InpModel& model) {
  const auto what = "element type " + name + " (" + type.formulation + ") is not what ritz has: " + type.plain +
                    ", the displacement element of " + std::string(type.points);
  const auto& ignored = model.ignored;
  if (std::find(ignored.begin(), ignored.end(), name) == ignored.end())
    deck.fail(place, what + "; '-ignore " + name + "' reads it as " + type.plain +
                         ", and the result is then of another model");
  if (model.words.insert(name).second)
    model.mesh.notes.push_back(located(deck.sources(), place) + what + "; it is read as " + type.plain + " (-ignore " +
                               name + ")");
}

void note_formulation(const Deck& deck, Place place, const std::string& name, const InpType& type, InpModel& model) {
  if (model.words.insert("TYPE=" + name).second)
    model.mesh.notes.push_back(located(deck.sources(), place) + "element type " + name + " (" + type.formulation +
                               ") is read as " + type.plain + ", the plain displacement element");
}

// Nothing where the elements are left out.
std::optional<Shape> shape_of(const Deck& deck, const Keyword& keyword, InpModel& model) {
  const auto name = upper(needed(deck, keyword, "TYPE"));
  const auto type = inp_type(name);
  switch (type.reading) {
    case InpReading::same: break;
    case InpReading::noted: note_formulation(deck, keyword.place, name, type, model); break;
    case InpReading::on_your_word: accept(deck, keyword.place, name, type, model); break;
    case InpReading::none:
      leave_out(deck.sources(), keyword.place, words_of_type(name),
                "element type " + name + " is not supported; ritz has C3D4, C3D10, C3D8, C3D20, C3D6, C3D15 and C3D5",
                model);
      return std::nullopt;
  }
  model.element_types.emplace_back(static_cast<Index>(model.mesh.shapes.size()), name);
  return type.shape;
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
InpSet* parameter_set(const InpScope& scope, InpSets& sets, const Keyword& keyword, std::string_view parameter) {
  const auto name = keyword.value(parameter);
  return name ? &sets.sets[sets.made(full_name(scope, *name))] : nullptr;
}

// "number, x, y, z" and perhaps a normal: a coordinate that is blank or absent is 0.
std::array<double, 6> read_coordinates(const Deck& deck, const Line& rest) {
  std::array<double, 6> values{};
  std::size_t count = 0;
  for (const auto& field : fields(rest)) {
    auto cursor = deck.cursor(field);
    if (cursor.line_ends()) ++count;
    while (!cursor.line_ends()) {
      if (count >= values.size()) cursor.end_line();
      values[count++] = cursor.real("a coordinate");
    }
  }
  return values;
}

Line after_number(const Line& line, const Cursor& cursor) {
  const auto read = cursor.place().offset - line.place.offset;
  Line rest{.place = cursor.place(), .text = line.text.substr(read)};
  if (const auto comma = rest.text.find_first_not_of(" \t"); comma != rest.text.npos && rest.text[comma] == ',') {
    rest.text.remove_prefix(comma + 1);
    rest.place.offset += comma + 1;
  }
  return rest;
}

}  // namespace

const std::string& element_type(const InpModel& model, Index cell) {
  const auto begins_later = [](Index c, const auto& block) { return c < block.first; };
  const auto& types = model.element_types;
  return std::prev(std::upper_bound(types.begin(), types.end(), cell, begins_later))->second;
}

void read_inp_node(Deck& deck, const Keyword& keyword, InpModel& model) {
  refuse_input(deck, keyword);
  if (upper(keyword.value("SYSTEM").value_or("R")) != "R") {
    deck.fail(keyword.place, "only rectangular coordinates (SYSTEM=R) are supported");
  }
  auto* const set = parameter_set(model.scope, model.node_sets, keyword, "NSET");
  while (const auto line = deck.next_data()) {
    auto cursor = deck.cursor(*line);
    const Index id = full_number(deck, line->place, cursor.integer("a vertex number"), model.scope.nodes);
    const auto [x, y, z, nx, ny, nz] = read_coordinates(deck, after_number(*line, cursor));
    if (set) set->positions.push_back(static_cast<Index>(model.mesh.points.size()));
    add_vertex(model.mesh, id, placed(model.scope, {x, y, z}), line->place);
    model.last_node = std::max(model.last_node, id);
  }
}

void read_inp_element(Deck& deck, const Keyword& keyword, InpModel& model) {
  refuse_input(deck, keyword);
  auto* const set = parameter_set(model.scope, model.element_sets, keyword, "ELSET");
  const auto shape = shape_of(deck, keyword, model);
  if (!shape) return;
  std::array<Index, fem::max_cell_vertices> storage;
  const auto vertices = std::span(storage).first(static_cast<std::size_t>(shape->vertices));
  while (const auto line = deck.next_data()) {
    auto cursor = deck.cursor(*line);
    const Index id = cursor.integer("an element number");
    read_vertices(deck, *line, cursor, id, vertices);
    for (Index& vertex : vertices) vertex = full_number(deck, line->place, vertex, model.scope.nodes);
    turn_wedge(*shape, vertices);
    if (set) set->positions.push_back(static_cast<Index>(model.mesh.shapes.size()));
    const Index full_id = full_number(deck, line->place, id, model.scope.elements);
    add_cell(model.mesh, *shape, full_id, vertices, line->place);
    model.last_element = std::max(model.last_element, full_id);
  }
}

}  // namespace ritz::readers
