// *MATERIAL and its density, *SOLID SECTION and other sections.
#include "ritz/readers/inp_model.hpp"

#include <algorithm>

namespace ritz::readers {

namespace {

std::string dependent(const Keyword& keyword) {
  return "*" + keyword.title + " with constants that depend on temperature or fields is not supported";
}

/// The full name of a section's orientation, that of the instance or else of the model; empty if it has none.
std::string orientation_of(const Keyword& keyword, const InpModel& model) {
  const auto name = keyword.value("ORIENTATION");
  if (!name) return {};
  const auto own = full_name(model.scope, upper(*name));
  return model.orientations.contains(own) ? own : upper(*name);
}

}  // namespace

InpMaterial& current_material(const Deck& deck, const Keyword& keyword, InpModel& model) {
  if (model.material.empty()) deck.fail(keyword.place, "*" + keyword.title + " stands before any *MATERIAL");
  return model.materials[model.material];
}

void read_inp_material(Deck& deck, const Keyword& keyword, InpModel& model) {
  model.material = upper(needed(deck, keyword, "NAME"));
  if (!model.materials.try_emplace(model.material, InpMaterial{}).second) {
    deck.fail(keyword.place, "material " + model.material + " is defined twice");
  }
}

void read_inp_other_law(Deck& deck, const Keyword& keyword, InpModel& model) {
  current_material(deck, keyword, model).law = {"the material law *" + keyword.title + " is not supported",
                                                keyword.place};
}

void read_inp_density(Deck& deck, const Keyword& keyword, InpModel& model) {
  auto& material = current_material(deck, keyword, model);
  std::optional<double> first;
  bool depends = false;
  while (const auto line = deck.next_data()) {
    const double density = deck.cursor(*line).real("the density");
    if (!(density > 0)) deck.fail(line->place, "the density must be positive");
    depends = depends || (first && *first != density);
    first = first.value_or(density);
  }
  if (!first) deck.fail(keyword.place, "*DENSITY has no data line");
  if (depends) material.unread_density = {dependent(keyword), keyword.place};
  else material.density = first;
}

void read_inp_expansion(Deck&, const Keyword&, InpModel& model) { model.expands = true; }

void read_inp_section(Deck& deck, const Keyword& keyword, InpModel& model) {
  if (keyword.has("COMPOSITE"))
    deck.fail(keyword.place, "a composite (layered) *SOLID SECTION is not supported; ritz has one material a section");
  model.sections.push_back({.element_set = full_name(model.scope, needed(deck, keyword, "ELSET")),
                            .material = upper(needed(deck, keyword, "MATERIAL")),
                            .orientation = orientation_of(keyword, model),
                            .place = keyword.place});
}

void read_inp_structure(Deck& deck, const Keyword& keyword, InpModel& model) {
  model.structures.push_back(
      {.word = keyword.name,
       .what = "*" + keyword.title + " gives elements stiffness and mass, which ritz cannot do: here they carry sets",
       .set = full_name(model.scope, needed(deck, keyword, "ELSET")),
       .place = keyword.place});
}

}  // namespace ritz::readers
