#include "ritz/app/static_loads.hpp"

#include <algorithm>

#include "ritz/base/error.hpp"
#include "ritz/base/printable.hpp"
#include "ritz/base/set_name.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/stages/rigid_modes.hpp"

namespace ritz::app {
namespace {

using stages::LoadPlace, stages::StaticError;

constexpr std::size_t cheap_places = 16;  ///< one block of solves
constexpr double worth_saying = .01;
constexpr std::size_t most_said = 5;

/// A name as -residual_vectors takes it for that name and nothing else, in a shell.
std::string listed(const LoadPlace& place) {
  if (!place) return "gravity";
  const bool plain = place->find_first_of(", \"'") == place->npos && *place != "all" && *place != "gravity";
  return plain ? *place : "'\"" + *place + "\"'";
}

std::string acted_on(const LoadPlace& place) { return place ? "on '" + printable(*place) + "'" : "under gravity"; }

/// The worst axis of each place, worst place first.
std::vector<StaticError> worst_of_places(const std::vector<StaticError>& errors) {
  std::vector<StaticError> worst;
  for (const auto& error : errors) {
    const auto same = std::ranges::find(worst, error.place, &StaticError::place);
    if (same == worst.end()) worst.push_back(error);
    else if (error.missing > same->missing) *same = error;
  }
  std::ranges::stable_sort(worst, std::ranges::greater{}, &StaticError::missing);
  return worst;
}

}  // namespace

std::vector<LoadPlace> residual_places(const config::Config& config, const mesh::Mesh& mesh) {
  std::vector<LoadPlace> places;
  if (!config.residual_vectors) return places;
  const auto& [which, gravity, asked] = *config.residual_vectors;
  std::vector<std::string> known;
  for (const auto& set : mesh.sets) {
    known.push_back(set.name);
    if (which == config::LoadedSets::all && set.vertices_total > 0) places.emplace_back(set.name);
  }
  for (const auto& name : asked) {
    const std::string option = "option -residual_vectors: ";
    const auto& set = *mesh.find(resolve_set(known, name, SetUse::vertices, option + "the mesh"));
    if (set.vertices_total == 0) throw InputError(option + "the set '" + set.name + "' is empty");
    if (std::ranges::find(places, LoadPlace(set.name)) == places.end()) places.emplace_back(set.name);
  }
  if (gravity == config::GravityLoad::included) places.emplace_back(std::nullopt);
  return places;
}

std::vector<LoadPlace> answered_places(const config::Config& config, const stages::Problem& problem,
                                       stages::Strategy strategy, const std::vector<LoadPlace>& residual) {
  std::vector<LoadPlace> all;
  for (const auto& set : problem.mesh.sets)
    if (set.vertices_total > 0) all.emplace_back(set.name);
  all.emplace_back(std::nullopt);
  if (config.static_errors == config::StaticErrors::always) return all;
  const bool exact =
      strategy == stages::Strategy::direct && stages::rigid_motions(problem.mesh, problem.dofs).cols() == 0;
  return exact && all.size() <= cheap_places ? all : residual;
}

algebra::Tall answers_at(const std::vector<LoadPlace>& some, const stages::UnitLoads& loads, mesh::FreeRef answers) {
  std::vector<Eigen::Index> columns;
  for (std::size_t i = 0; i < loads.places.size(); ++i)
    if (std::ranges::find(some, loads.places[i]) != some.end())
      for (int axis = 0; axis < mesh::components; ++axis)
        columns.push_back(mesh::components * static_cast<Eigen::Index>(i) + axis);
  return answers(Eigen::all, columns);
}

std::string static_error_lines(const config::Config& config, const std::vector<StaticError>& errors,
                               const std::vector<LoadPlace>& residual) {
  std::string text;
  for (const auto& place : residual)
    if (std::ranges::find(errors, place, &StaticError::place) == errors.end())
      text +=
          "no residual vector for a load " + acted_on(place) + ": supports or the body's own inertia bear all of it\n";
  std::string list, mended;
  std::size_t said = 0;
  for (const auto& [place, axis, missing] : worst_of_places(errors)) {
    if (!(missing > worth_saying) || ++said > most_said) break;
    list += (list.empty() ? "" : ", ") + formatted("%.3g %% ", 100 * missing) + acted_on(place) + " (along " +
            "xyz"[axis] + ")";
    mended += (mended.empty() ? "" : ",") + listed(place);
  }
  if (list.empty()) return text;
  text += "of the static answer to a load this basis misses, in the energy norm: " + list;
  if (said > most_said) text += " and less of others", mended = "all";
  if (!config.accuracy) text += "; -residual_vectors " + mended + " makes them exact for small displacements";
  return text + '\n';
}

files::Json static_error_summary(const std::vector<StaticError>& errors) {
  if (errors.empty()) return nullptr;
  files::Json::Array list;
  for (std::size_t i = 0; i < errors.size();) {
    const auto& place = errors[i].place;
    files::Json::Array missing(3, files::Json(nullptr));
    for (; i < errors.size() && errors[i].place == place; ++i)
      missing[static_cast<std::size_t>(errors[i].axis)] = errors[i].missing;
    list.emplace_back(files::Json::Object{{"set", place ? files::Json(*place) : files::Json(nullptr)},
                                          {"missing", std::move(missing)}});
  }
  return list;
}

}  // namespace ritz::app
