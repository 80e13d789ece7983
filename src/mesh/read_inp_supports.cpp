// Which of the steps' supports count.
#include <algorithm>
#include <functional>

#include "ritz/base/random.hpp"
#include "ritz/mesh/read_inp_model.hpp"

namespace ritz::mesh {
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

void refuse_motion(const Sources& sources, InpModel& model, const InpStep& step) {
  for (const auto& boundary : model.boundaries) {
    if (boundary.motion != InpMotion::prescribed || boundary.components == Components{}) continue;
    if (step.frequency) {
      model.words.insert("BOUNDARY");
      model.mesh.notes.push_back(located(sources, boundary.place) +
                                 "a prescribed displacement: the vertices are held where they stand, as a frequency "
                                 "step has it");
      return;
    }
    leave_out(sources, boundary.place, {"BOUNDARY"},
              "a prescribed displacement other than zero is not supported: ritz holds the vertices where they stand",
              model);
  }
}

void note_others(const Sources& sources, InpModel& model, const InpStep& step) {
  const std::string which = step.frequency
                                ? "those of the first frequency step count (-fix replaces them)"
                                : "those of the last step count, as there is no frequency step (-fix replaces them)";
  model.mesh.notes.push_back(located(sources, step.place) + "the steps have different supports (*BOUNDARY); " + which);
}

}  // namespace

void choose_supports(const Sources& sources, InpModel& model) {
  const auto chosen = chosen_step(model);
  const auto& step = model.steps[chosen];
  Supports supports;
  std::vector<std::uint64_t> sums;
  for (std::size_t s = 0; s < model.steps.size(); ++s) {
    enter(supports, model.steps[s]);
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

}  // namespace ritz::mesh
