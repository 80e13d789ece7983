// *MATERIAL, *ELASTIC, *DENSITY, *SOLID SECTION and *BOUNDARY.
#include <algorithm>

#include "ritz/mesh/read_inp_model.hpp"

namespace ritz::mesh {
namespace {

InpMaterial& current_material(const Deck& deck, const Keyword& keyword, InpModel& model) {
  if (model.material.empty()) deck.fail(keyword.place, "*" + keyword.name + " stands before any *MATERIAL");
  return model.materials[model.material];
}

Line only_line(Deck& deck, const Keyword& keyword) {
  const auto line = deck.next_data();
  if (!line) deck.fail(keyword.place, "*" + keyword.name + " has no data line");
  if (const auto more = deck.next_data()) {
    deck.fail(more->place,
              "*" + keyword.name + " with more than one line (a dependence on temperature) is not supported");
  }
  return *line;
}

struct NamedCondition {
  std::string_view name;
  std::array<bool, 3> components;
};

constexpr NamedCondition conditions[] = {{"ENCASTRE", {true, true, true}}, {"PINNED", {true, true, true}},
                                         {"XSYMM", {true, false, false}},  {"YSYMM", {false, true, false}},
                                         {"ZSYMM", {false, false, true}},  {"XASYMM", {false, true, true}},
                                         {"YASYMM", {true, false, true}},  {"ZASYMM", {true, true, false}}};

Index degree_of_freedom(const Deck& deck, const Line& field) {
  auto cursor = deck.cursor(field);
  const Index dof = cursor.integer("a degree of freedom");
  cursor.end_line();
  // 4 to 6 are rotations, which the vertices of a solid do not have.
  if (dof < 1 || dof > 6) {
    deck.fail(field.place, "degree of freedom " + std::to_string(dof) + " cannot be fixed; a vertex has 1 to 3");
  }
  return dof;
}

// "dof, last dof, value" or a name.
std::array<bool, 3> fixed_components(const Deck& deck, const std::vector<Line>& parts) {
  const auto name = upper(parts[1].text);
  for (const auto& condition : conditions) {
    if (condition.name == name) return condition.components;
  }
  const Index first = degree_of_freedom(deck, parts[1]);
  const Index last = parts.size() > 2 && !parts[2].text.empty() ? degree_of_freedom(deck, parts[2]) : first;
  if (last < first) deck.fail(parts[2].place, "the last degree of freedom comes before the first");
  if (parts.size() > 3 && !parts[3].text.empty() && deck.cursor(parts[3]).real("a displacement") != 0) {
    deck.fail(parts[3].place, "a prescribed displacement other than zero is not supported");
  }
  std::array<bool, 3> components{};
  for (Index dof = first; dof <= std::min<Index>(last, 3); ++dof) components[static_cast<std::size_t>(dof - 1)] = true;
  return components;
}

}  // namespace

void read_inp_material(Deck& deck, const Keyword& keyword, InpModel& model) {
  model.material = upper(needed(deck, keyword, "NAME"));
  if (!model.materials
           .try_emplace(model.material, InpMaterial{.young = {}, .poisson = {}, .density = {}, .place = keyword.place})
           .second) {
    deck.fail(keyword.place, "material " + model.material + " is defined twice");
  }
}

void read_inp_elastic(Deck& deck, const Keyword& keyword, InpModel& model) {
  auto& material = current_material(deck, keyword, model);
  const auto type = upper(keyword.value("TYPE").value_or("ISOTROPIC"));
  if (!type.starts_with("ISO")) {
    deck.fail(keyword.place, "elasticity of type " + type + " is not supported, only ISOTROPIC");
  }
  const auto line = only_line(deck, keyword);
  auto cursor = deck.cursor(line);
  material.place = line.place;
  material.young = cursor.real("Young's modulus");
  material.poisson = cursor.real("Poisson's ratio");
  const FileMaterial elastic{.young = material.young, .poisson = material.poisson, .density = {}};
  checked(deck.sources(), line.place, elastic);
}

void read_inp_density(Deck& deck, const Keyword& keyword, InpModel& model) {
  auto& material = current_material(deck, keyword, model);
  const auto line = only_line(deck, keyword);
  material.density = deck.cursor(line).real("the density");
  if (!(*material.density > 0)) deck.fail(line.place, "the density must be positive");
}

void read_inp_section(Deck& deck, const Keyword& keyword, InpModel& model) {
  model.sections.push_back({.element_set = needed(deck, keyword, "ELSET"),
                            .material = upper(needed(deck, keyword, "MATERIAL")),
                            .place = keyword.place});
}

void read_inp_boundary(Deck& deck, const Keyword&, InpModel& model) {
  while (const auto line = deck.next_data()) {
    const auto parts = fields(*line);
    if (parts.size() < 2 || parts[0].text.empty()) {
      deck.fail(line->place, "expected a node or node set and the degrees of freedom that are fixed");
    }
    model.boundaries.push_back(
        {.target = plain_name(parts[0].text), .components = fixed_components(deck, parts), .place = line->place});
  }
}

}  // namespace ritz::mesh
