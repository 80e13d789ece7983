#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "ritz/base/error.hpp"
#include "ritz/base/nearest.hpp"
#include "ritz/base/set_name.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/config/config.hpp"

namespace ritz::config {
namespace {

std::string underscored(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

std::string option_of(const std::string& region) { return "option -material_" + region + "_...: "; }

/// The region that an option names: by its name, or, where no region is called so, with '_' for its blanks. Names of
/// options do not mind capitals.
std::size_t named_region(const std::string& name, const std::vector<std::string>& regions) {
  std::vector<std::size_t> blank;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    if (edit_distance(regions[i], name) == 0) return i;
    if (edit_distance(underscored(regions[i]), name) == 0) blank.push_back(i);
  }
  if (blank.size() > 1)
    throw InputError(option_of(name) + "that may be region '" + regions[blank[0]] + "' or '" + regions[blank[1]] +
                     "'; write the name with its blanks, in quotes");
  if (blank.empty()) throw InputError(option_of(name) + "the mesh has no region '" + name + "'" + hint(name, regions));
  return blank[0];
}

/// The options of each name that a region or one of its parts has, where there are any.
std::map<std::string, const MaterialOptions*> named_options(const Config& config,
                                                            const std::vector<mesh::Region>& regions) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const auto& region : regions) {
    add(region.name);
    for (const auto& part : region.parts) add(part);
  }
  std::map<std::string, const MaterialOptions*> own;
  for (const auto& [name, material] : config.by_region) {
    const auto& region = names[named_region(name, names)];
    if (own.contains(region))
      throw InputError(option_of(name) + "another option writes the same region with its blanks; write it one way");
    own[region] = &material;
  }
  return own;
}

using Constant = std::optional<double> MaterialOptions::*;

/// What the options of a region's own name say of a member, or else those of its parts: the smallest of nested ones,
/// all alike of others. `word` names the member.
template <class Value>
std::optional<Value> own_value(const std::map<std::string, const MaterialOptions*>& options, const mesh::Region& region,
                               std::optional<Value> MaterialOptions::*member, const std::string& word) {
  const auto stated = [&](const std::string& name) {
    const auto found = options.find(name);
    return found != options.end() ? found->second->*member : std::nullopt;
  };
  const auto& parts = region.parts;
  const bool shared = region.overlap == mesh::Overlap::crossing;
  const bool own_name = std::find(parts.begin(), parts.end(), region.name) == parts.end();
  std::optional<Value> value;
  if (own_name) value = stated(region.name);
  if (value) return value;
  for (const auto& part : parts) {
    const auto of_part = stated(part);
    if (!of_part) continue;
    if (!shared) return of_part;
    if (value && *value != *of_part)
      throw InputError(
          "cells lie in several volumes, " + listed_names(parts) +
          ", none of which is a part of another, and options " + "-material_..._" + word +
          " differ between them; give these the same value" +
          (own_name ? ", or say with -material_" + underscored(region.name) + "_" + word + " what holds there" : ""));
    value = of_part;
  }
  return value;
}

constexpr fem::Parameter density_of_mass = {"density", "density", "kg/m3", 0, std::numeric_limits<double>::infinity()};

std::string range(const fem::Parameter& p) {
  return std::isfinite(p.below) ? "above " + shown(p.above) + " and below " + shown(p.below) : "positive";
}

void check(const fem::Material& material, const std::string& region) {
  auto all = fem::parameters(material.law);
  all.push_back({density_of_mass, material.density});
  for (const auto& given : all)
    if (!given.possible())
      throw InputError("the " + std::string(given.parameter.words) + " of region '" + region + "' is " +
                       shown(given.value) + "; it must be " + range(given.parameter));
}

struct Place {
  Constant option;
  std::optional<double> mesh::FileMaterial::*of_file;
  double factor;  ///< to SI
};

/// Where the value of a parameter is said.
Place place(const fem::Parameter& parameter, const mesh::Units& units) {
  const std::string_view name = parameter.name;
  if (name == "young") return {&MaterialOptions::young, &mesh::FileMaterial::young, units.pressure()};
  if (name == "poisson") return {&MaterialOptions::poisson, &mesh::FileMaterial::poisson, 1};
  if (name == "density") return {&MaterialOptions::density, &mesh::FileMaterial::density, units.density()};
  throw std::logic_error("no option states the parameter '" + std::string(name) + "' of a law");
}

}  // namespace

fem::Materials region_materials(const Config& config, const std::vector<mesh::Region>& regions) {
  const auto options = named_options(config, regions);
  const auto& units = config.source.units;
  fem::Materials materials;
  for (const auto& region : regions) {
    const auto value = [&](const fem::Parameter& parameter) {
      const std::string word = parameter.name;
      const auto [member, of_file, factor] = place(parameter, units);
      if (const auto own = own_value(options, region, member, word)) return *own * factor;
      if (config.material.*member) return *(config.material.*member) * factor;
      if (region.material.*of_file) return *(region.material.*of_file);
      const auto options = "-material_" + word + " or -material_" + underscored(region.name) + "_" + word;
      const auto& unread = word == "density" ? region.material.unread_density : region.material.unread_law;
      if (!unread.empty()) throw InputError(unread + "; another can be put in its place by " + options);
      const bool bare = !region.material.young && !region.material.poisson && !region.material.density;
      throw InputError("region '" + region.name + "' has no " + (bare ? "material" : parameter.words) + ": give " +
                       options);
    };
    const auto name = own_value(options, region, &MaterialOptions::law, "law");
    const auto law = fem::make_law(name ? *name : config.material.law.value_or(fem::default_law), value);
    materials.push_back({*law, value(density_of_mass)});
    check(materials.back(), region.name);
  }
  return materials;
}

}  // namespace ritz::config
