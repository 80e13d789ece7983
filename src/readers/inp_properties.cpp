// *MATERIAL and what stands under it, *SOLID SECTION and other sections.
#include "ritz/readers/inp_model.hpp"

#include <algorithm>

namespace ritz::readers {

namespace {

InpMaterial& current_material(const Deck& deck, const Keyword& keyword, InpModel& model) {
  if (model.material.empty()) deck.fail(keyword.place, "*" + keyword.title + " stands before any *MATERIAL");
  return model.materials[model.material];
}

// The constants in front of each data line, which may go on with a temperature and fields. Nothing where they differ
// from line to line.
template <std::size_t count, class Check>
std::optional<std::array<double, count>> constants(Deck& deck, const Keyword& keyword,
                                                   const std::array<std::string_view, count>& names, Check check) {
  std::optional<std::array<double, count>> first;
  bool depends = false;
  while (const auto line = deck.next_data()) {
    auto cursor = deck.cursor(*line);
    std::array<double, count> values;
    for (std::size_t i = 0; i < count; ++i) values[i] = cursor.real(names[i]);
    check(*line, values);
    depends = depends || (first && *first != values);
    first = first.value_or(values);
  }
  if (!first) deck.fail(keyword.place, "*" + keyword.title + " has no data line");
  return depends ? std::nullopt : first;
}

std::string dependent(const Keyword& keyword) {
  return "*" + keyword.title + " with constants that depend on temperature or fields is not supported";
}

}  // namespace

void read_inp_material(Deck& deck, const Keyword& keyword, InpModel& model) {
  model.material = upper(needed(deck, keyword, "NAME"));
  if (!model.materials.try_emplace(model.material, InpMaterial{.young = {}, .poisson = {}, .density = {}}).second) {
    deck.fail(keyword.place, "material " + model.material + " is defined twice");
  }
}

void read_inp_elastic(Deck& deck, const Keyword& keyword, InpModel& model) {
  auto& material = current_material(deck, keyword, model);
  const auto type = upper(keyword.value("TYPE").value_or("ISOTROPIC"));
  if (!type.starts_with("ISO")) {
    material.law = {"elasticity of type " + type + " is not supported, only ISOTROPIC", keyword.place};
    return;
  }
  const auto check = [&](const Line& line, const std::array<double, 2>& values) {
    const auto parts = fields(line);
    if (parts.size() > 1 && parts[1].text.empty()) deck.fail(line.place, "*ELASTIC has no Poisson's ratio here");
    checked(deck.sources(), line.place, {.young = values[0], .poisson = values[1], .density = {}});
  };
  const auto values = constants<2>(deck, keyword, {"Young's modulus", "Poisson's ratio"}, check);
  if (!values) {
    material.law = {dependent(keyword), keyword.place};
    return;
  }
  material.young = (*values)[0];
  material.poisson = (*values)[1];
}

void read_inp_other_law(Deck& deck, const Keyword& keyword, InpModel& model) {
  current_material(deck, keyword, model).law = {"the material law *" + keyword.title + " is not supported",
                                                keyword.place};
}

void read_inp_density(Deck& deck, const Keyword& keyword, InpModel& model) {
  auto& material = current_material(deck, keyword, model);
  const auto check = [&](const Line& line, const std::array<double, 1>& values) {
    if (!(values[0] > 0)) deck.fail(line.place, "the density must be positive");
  };
  const auto values = constants<1>(deck, keyword, {"the density"}, check);
  if (values) material.density = values->front();
  else material.unread_density = {dependent(keyword), keyword.place};
}

void read_inp_expansion(Deck&, const Keyword&, InpModel& model) { model.expands = true; }

void read_inp_section(Deck& deck, const Keyword& keyword, InpModel& model) {
  if (keyword.has("COMPOSITE"))
    deck.fail(keyword.place, "a composite (layered) *SOLID SECTION is not supported; ritz has one material a section");
  model.sections.push_back({.element_set = full_name(model.scope, needed(deck, keyword, "ELSET")),
                            .material = upper(needed(deck, keyword, "MATERIAL")),
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
