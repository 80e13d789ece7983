// The surfaces that *DLOAD presses.
#include <algorithm>

#include "ritz/base/set_name.hpp"
#include "ritz/readers/inp_model.hpp"

namespace ritz::readers {

namespace {

constexpr std::uint64_t face_cost = 4;    // of an entry in other sets
constexpr std::size_t most_groups = 256;  // of faces of single elements; every rank knows every set

// Of P1 ... P6, from 0.
std::optional<int> pressed_side(const InpModel& model, const InpLoad& load) {
  if (model.load_keywords[load.keyword].name != "DLOAD" || load.fields.size() < 2) return std::nullopt;
  const auto label = upper(load.fields[1].text);
  if (label.size() != 2 || label[0] != 'P' || label[1] < '1' || label[1] > '6') return std::nullopt;
  return label[1] - '1';
}

std::string free_name(const InpModel& model, std::string name) {
  while (model.set_index.contains(of_kind("surface", upper(name)))) name += '\'';
  return name;
}

bool has_side(const ListedMesh& mesh, Index cell, int side) {
  const auto& cell_type = mesh.shapes[static_cast<std::size_t>(cell)].cell;
  return cell_type && side < std::ssize(fem::shape(*cell_type).faces);
}

void explain_unfit(InpLoad& load) {
  load.unfit = "of which not every element is a solid with a face " + upper(load.fields[1].text);
}

void press_set(InpModel& model, const InpSet& elements, int side, InpLoad& load) {
  const auto& cells = listed_set(model, elements.name, "elset").cells;
  std::vector<ListedFace> faces;
  for (const Index cell : cells)
    if (has_side(model.mesh, cell, side)) faces.push_back({.cell = cell, .face = side});
  if (faces.empty() || faces.size() < cells.size()) return explain_unfit(load);
  load.faces = free_name(model, elements.name + ".P" + std::to_string(side + 1));
  listed_set(model, load.faces, "surface").faces = std::move(faces);
}

/// Single elements that a *DLOAD presses alike: one surface. A face that it lists twice is in two of them.
struct PressedElements {
  std::size_t keyword = 0;                                   ///< of the present *DLOAD
  int blocks = 0;                                            ///< the number of *DLOAD so far
  std::map<std::pair<std::string, int>, std::string> names;  ///< by magnitude and repetition
  std::map<std::pair<Index, int>, int> times;                ///< that a face was listed
  std::size_t all = 0;
};

void press_element(InpModel& model, Index cell, int side, PressedElements& groups, InpLoad& load) {
  if (!has_side(model.mesh, cell, side)) return explain_unfit(load);
  const std::string magnitude(load.fields.size() > 2 ? load.fields[2].text : std::string_view());
  auto& name = groups.names[{magnitude, groups.times[{cell, side}]++}];
  load.joined = !name.empty();
  if (!load.joined) {
    if (groups.all == most_groups) {
      load.unfit = "and the deck has more than " + std::to_string(most_groups) +
                   " different pressures on elements that it lists by number";
      return;
    }
    ++groups.all;
    const auto further = groups.names.size() > 1 ? "." + std::to_string(groups.names.size()) : std::string();
    name = free_name(model, "DLOAD-" + std::to_string(groups.blocks) + further);
  }
  load.faces = name;
  listed_set(model, name, "surface").faces.push_back({.cell = cell, .face = side});
}

}  // namespace

void press_faces(const Sources& sources, InpBudget& budget, InpModel& model) {
  std::map<std::string, const InpLoad*> pressed;  // faces of sets, by set and label
  std::optional<Numbering> ids;
  PressedElements groups;
  for (auto& step : model.steps)
    for (auto& load : step.loads) {
      const auto side = pressed_side(model, load);
      if (!side) continue;
      if (const auto* const set = model.element_sets.find(load.target)) {
        const auto [first, is_first] = pressed.try_emplace(upper(load.target) + "." + std::to_string(*side), &load);
        if (is_first) {
          budget.spend(sources, set->name, face_cost * listed_set(model, set->name, "elset").cells.size());
          press_set(model, *set, *side, load);
        }
        load.faces = first->second->faces;
        load.unfit = first->second->unfit;
        continue;
      }
      if (!ids) ids = numbering(sources, model.mesh);
      if (groups.blocks == 0 || groups.keyword != load.keyword)
        groups = {.keyword = load.keyword, .blocks = groups.blocks + 1, .names = {}, .times = {}, .all = groups.all};
      const auto number = whole_number(load.target);
      const Index cell = number ? ids->cells.find(*number) : -1;
      if (cell >= 0) press_element(model, cell, *side, groups, load);
      else load.unfit = "which is no element set and no element of this file";
    }
}

}  // namespace ritz::readers
