// *BOUNDARY, *STEP and what stands in a step.
#include "ritz/readers/inp_model.hpp"

#include <algorithm>
#include <functional>

#include "ritz/base/random.hpp"

namespace ritz::readers {

namespace {

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
  // From 4 on: rotations, warping, pressures, temperatures, which hold no vertex of a solid.
  if (dof < 1 || dof > 31) {
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
  std::array<bool, 3> components{};
  for (Index dof = first; dof <= std::min<Index>(last, 3); ++dof) components[static_cast<std::size_t>(dof - 1)] = true;
  return components;
}

InpMotion motion_of(const Deck& deck, const Keyword& keyword, const std::vector<Line>& parts) {
  if (keyword.has("USER") || keyword.has("SUBMODEL")) return InpMotion::prescribed;
  const bool moves = parts.size() > 3 && !parts[3].text.empty() && deck.cursor(parts[3]).real("a displacement") != 0;
  return moves ? InpMotion::prescribed : InpMotion::none;
}

enum class Operation { modify, replace };

Operation operation_of(const Deck& deck, const Keyword& keyword) {
  const auto word = upper(keyword.value("OP").value_or("MOD"));
  if (word != "MOD" && word != "NEW")
    deck.fail(keyword.place, "*BOUNDARY has OP=NEW and OP=MOD, not OP='" + word + "'");
  return word == "NEW" ? Operation::replace : Operation::modify;
}

// The first *BOUNDARY of a step says whether the earlier supports go.
void begin_supports(const Deck& deck, const Keyword& keyword, InpModel& model) {
  auto& step = model.steps.back();
  const bool replaces = operation_of(deck, keyword) == Operation::replace && model.steps.size() > 1;
  if (!step.own_supports) step.replaces_supports = replaces;
  else if (replaces && !step.replaces_supports && model.words.insert("OP=NEW").second)
    model.mesh.notes.push_back(located(deck.sources(), keyword.place) +
                               "OP=NEW comes after a *BOUNDARY of the same step without it; as in CalculiX the first "
                               "one counts, and the earlier supports stay");
  step.own_supports = true;
}

bool spins(const Line& line) {
  const auto parts = fields(line);
  const auto label = parts.size() > 1 ? upper(parts[1].text) : std::string();
  return label.starts_with("CENT") || label.starts_with("CORIO") || label.starts_with("ROT");
}

bool yes(const Keyword& keyword, std::string_view parameter) {
  return keyword.has(parameter) && upper(keyword.value(parameter).value_or("YES")) != "NO";
}

}  // namespace

void read_inp_boundary(Deck& deck, const Keyword& keyword, InpModel& model) {
  begin_supports(deck, keyword, model);
  auto& step = model.steps.back();
  if (keyword.has("FIXED") && !step.fixed) step.fixed = keyword.place;
  while (const auto line = deck.next_data()) {
    const auto parts = fields(*line);
    if (parts.size() < 2 || parts[0].text.empty()) {
      deck.fail(line->place, "expected a node or node set and the degrees of freedom that are fixed");
    }
    step.boundaries.push_back({.target = full_target(deck, parts[0], InpKind::node, model),
                               .components = fixed_components(deck, parts),
                               .motion = motion_of(deck, keyword, parts),
                               .place = line->place});
    step.loaded = step.loaded || step.boundaries.back().motion == InpMotion::prescribed;
  }
}

void read_inp_step(Deck&, const Keyword& keyword, InpModel& model) {
  auto& step = model.steps.emplace_back();
  step.place = keyword.place;
  step.keyword = keyword;
  if (yes(keyword, "PERTURBATION")) step.preloaded = keyword.place;
  if (yes(keyword, "NLGEOM")) step.nonlinear = keyword.place;
}

void read_inp_procedure(Deck& deck, const Keyword& keyword, InpModel& model) {
  auto& procedure = model.steps.back().procedure.emplace(InpLines{keyword});
  while (const auto line = deck.next_data()) procedure.lines.push_back(*line);
}

void read_inp_frequency(Deck& deck, const Keyword& keyword, InpModel& model) {
  model.steps.back().frequency = keyword.place;
  read_inp_procedure(deck, keyword, model);
}

void read_inp_amplitude(Deck& deck, const Keyword& keyword, InpModel& model) {
  const auto name = upper(keyword.value("NAME").value_or(""));
  auto& lines = model.amplitudes.emplace(name, InpLines{keyword})->second.lines;
  while (const auto line = deck.next_data()) lines.push_back(*line);
}

void read_inp_load(Deck& deck, const Keyword& keyword, InpModel& model) {
  auto& step = model.steps.back();
  const auto kind = keyword.name == "CLOAD" ? InpKind::node : InpKind::element;
  while (const auto line = deck.next_data()) {
    step.loaded = true;
    step.spinning = step.spinning || spins(*line);
    const auto parts = fields(*line);
    const bool all = parts[0].text.empty();
    step.loads.push_back({.keyword = model.load_keywords.size(),
                          .target = all ? std::string() : full_target(deck, parts[0], kind, model),
                          .fields = parts});
  }
  model.load_keywords.push_back(keyword);
}

void read_inp_temperature(Deck&, const Keyword& keyword, InpModel& model) {
  model.steps.back().loaded = true;
  if (!model.temperatures) model.temperatures = keyword.place;
}

void read_inp_initial_conditions(Deck& deck, const Keyword& keyword, InpModel& model) {
  // Where a motion begins, and temperatures: constants that depend on them are not read, and what changes them strains.
  constexpr std::string_view harmless[] = {"TEMPERATURE", "VELOCITY",      "ROTATINGVELOCITY", "DISPLACEMENT", "FIELD",
                                           "PRESSURE",    "TOTALPRESSURE", "MASSFLOW",         "SOLUTION"};
  auto type = upper(keyword.value("TYPE").value_or(""));
  std::erase(type, ' ');
  if ((type.ends_with("VELOCITY") || type == "DISPLACEMENT") && !model.in_motion) model.in_motion = keyword.place;
  if (std::find(std::begin(harmless), std::end(harmless), type) != std::end(harmless)) return;
  leave_out(deck.sources(), keyword.place, {keyword.name},
            "*INITIAL CONDITIONS of type '" + type +
                "' give the body a state that changes its stiffness, which ritz "
                "cannot do",
            model);
}

void read_inp_transform(Deck& deck, const Keyword& keyword, InpModel& model) {
  model.transforms.push_back({.word = keyword.name,
                              .what = "*TRANSFORM turns the directions of supports, which ritz cannot do",
                              .set = full_name(model.scope, needed(deck, keyword, "NSET")),
                              .place = keyword.place});
}

namespace {

using Components = std::array<bool, 3>;

/// The supports in effect; `sum` is the same for the same degrees of freedom of the same targets.
struct Supports {
  std::vector<InpBoundary> held;                                    ///< each target with each choice of components once
  std::map<std::pair<std::string, Components>, std::size_t> index;  ///< by target in capitals
  std::map<std::string, Components> components;                     ///< all of a target
  std::uint64_t sum = 0;
};

std::uint64_t hash(const std::string& target, std::size_t component) {
  std::uint64_t h = component;
  for (const char c : target) h = split_mix(h ^ static_cast<unsigned char>(c));
  return h;
}

void add(Supports& supports, const InpBoundary& boundary) {
  const auto target = upper(boundary.target);
  const auto [place, added] = supports.index.try_emplace({target, boundary.components}, supports.held.size());
  if (added) supports.held.push_back(boundary);
  else supports.held[place->second] = boundary;
  auto& all = supports.components[target];
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (boundary.components[i] && !all[i]) supports.sum += hash(target, i);
    all[i] = all[i] || boundary.components[i];
  }
}

void enter(Supports& supports, const InpStep& step) {
  if (step.replaces_supports) supports = {};
  for (const auto& boundary : step.boundaries) add(supports, boundary);
}

std::size_t chosen_step(const InpModel& model) {
  const auto& steps = model.steps;
  const auto found = std::find_if(steps.begin(), steps.end(), [](const auto& step) { return step.frequency; });
  return static_cast<std::size_t>((found != steps.end() ? found : std::prev(steps.end())) - steps.begin());
}

// Stress that the steps before leave in the body stiffens it or softens it.
void refuse_preload(const Sources& sources, InpModel& model, std::size_t chosen) {
  const auto& step = model.steps[chosen];
  const auto before = model.steps.begin() + static_cast<std::ptrdiff_t>(chosen);
  const auto loaded = [](const auto& s) { return s.loaded; };
  const auto nonlinear = [](const auto& s) { return s.loaded && s.nonlinear; };
  if (step.preloaded && (step.spinning || std::any_of(model.steps.begin(), before, loaded)))
    leave_out(sources, *step.preloaded, {"PERTURBATION", "STEP"},
              "*STEP, PERTURBATION starts from the loads of a step, whose stress changes the stiffness, which ritz "
              "cannot do",
              model);
  const auto found = std::find_if(model.steps.begin(), before, nonlinear);
  if (step.frequency && found != before)
    leave_out(sources, *found->nonlinear, {"NLGEOM", "STEP"},
              "*STEP, NLGEOM loads the body before its modes are sought, and in Abaqus this stress changes the "
              "stiffness, which ritz cannot do",
              model);
}

std::optional<Place> moved(const Supports& supports) {
  const auto moves = [](const InpBoundary& held) {
    return held.motion == InpMotion::prescribed && held.components != Components{};
  };
  const auto found = std::find_if(supports.held.begin(), supports.held.end(), moves);
  return found == supports.held.end() ? std::nullopt : std::optional(found->place);
}

void refuse_motion(const Sources& sources, InpModel& model, const InpStep& step) {
  if (!step.moved) return;
  if (step.frequency) {
    model.words.insert("BOUNDARY");
    model.mesh.notes.push_back(located(sources, *step.moved) +
                               "a prescribed displacement: the vertices are held where they stand, as a frequency "
                               "step has it");
    return;
  }
  leave_out(sources, *step.moved, {"BOUNDARY"},
            "a prescribed displacement other than zero is not supported: ritz holds the vertices where they stand",
            model);
}

void note_others(const Sources& sources, InpModel& model, const InpStep& step) {
  const std::string which = step.frequency
                                ? "those of the first frequency step count (-fix replaces them)"
                                : "those of the last step count, as there is no frequency step (-fix replaces them)";
  model.mesh.notes.push_back(located(sources, step.place) + "the steps have different supports (*BOUNDARY); " + which);
}

}  // namespace

void choose_supports(const Sources& sources, InpModel& model) {
  const auto chosen = model.supported_step = chosen_step(model);
  const auto& step = model.steps[chosen];
  Supports supports;
  std::vector<std::uint64_t> sums;
  for (std::size_t s = 0; s < model.steps.size(); ++s) {
    enter(supports, model.steps[s]);
    model.steps[s].supports = supports.sum;
    model.steps[s].moved = moved(supports);
    const bool alike = model.steps[s].frequency.has_value() == step.frequency.has_value();
    if (alike && (s > 0 || chosen == 0)) sums.push_back(supports.sum);
    if (s == chosen) model.boundaries = supports.held;
  }
  refuse_preload(sources, model, chosen);
  refuse_motion(sources, model, step);
  if (std::adjacent_find(sums.begin(), sums.end(), std::not_equal_to<>()) != sums.end())
    note_others(sources, model, step);
  if (model.temperatures && model.expands)
    leave_out(sources, *model.temperatures, {"TEMPERATURE"},
              "*TEMPERATURE with *EXPANSION strains the body, which ritz cannot do", model);
}

}  // namespace ritz::readers
