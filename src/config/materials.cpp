#include <algorithm>
#include <cmath>

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
  if (blank.empty())
    throw InputError(option_of(name) + "the mesh has no region '" + name + "'; did you mean '" +
                     nearest(name, regions) + "'?");
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

/// What the options of a region's own name say of a constant, or else those of its parts: the smallest of nested ones,
/// all alike of others. `word` names the constant.
std::optional<double> own_value(const std::map<std::string, const MaterialOptions*>& options,
                                const mesh::Region& region, Constant constant, const std::string& word) {
  const auto stated = [&](const std::string& name) {
    const auto found = options.find(name);
    return found != options.end() ? found->second->*constant : std::nullopt;
  };
  const auto& parts = region.parts;
  const bool shared = region.overlap == mesh::Overlap::crossing;
  const bool own_name = std::find(parts.begin(), parts.end(), region.name) == parts.end();
  std::optional<double> value;
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

void check(const fem::StVK& m, const std::string& region) {
  const auto refuse = [&](const std::string& what, double value, const std::string& range) {
    throw InputError("the " + what + " of region '" + region + "' is " + shown(value) + "; it must be " + range);
  };
  if (!(m.young > 0) || !std::isfinite(m.young)) refuse("Young's modulus", m.young, "positive");
  if (!(m.poisson > -1 && m.poisson < 0.5)) refuse("Poisson's ratio", m.poisson, "above -1 and below 0.5");
  if (!(m.density > 0) || !std::isfinite(m.density)) refuse("density", m.density, "positive");
}

}  // namespace

std::vector<fem::StVK> region_materials(const Config& config, const std::vector<mesh::Region>& regions) {
  static const std::map<std::string, std::string> names = {
      {"young", "Young's modulus"}, {"poisson", "Poisson's ratio"}, {"density", "density"}};
  const auto options = named_options(config, regions);
  const auto& units = config.source.units;
  std::vector<fem::StVK> materials;
  for (const auto& region : regions) {
    const auto value = [&](Constant member, double factor, const std::optional<double>& of_file,
                           const std::string& word) {
      if (const auto own = own_value(options, region, member, word)) return *own * factor;
      if (config.material.*member) return *(config.material.*member) * factor;
      if (of_file) return *of_file;
      const auto options = "-material_" + word + " or -material_" + underscored(region.name) + "_" + word;
      const auto& unread = word == "density" ? region.material.unread_density : region.material.unread_law;
      if (!unread.empty()) throw InputError(unread + "; another can be put in its place by " + options);
      const bool bare = !region.material.young && !region.material.poisson && !region.material.density;
      throw InputError("region '" + region.name + "' has no " + (bare ? "material" : names.at(word)) + ": give " +
                       options);
    };
    materials.push_back({value(&MaterialOptions::young, units.pressure(), region.material.young, "young"),
                         value(&MaterialOptions::poisson, 1, region.material.poisson, "poisson"),
                         value(&MaterialOptions::density, units.density(), region.material.density, "density")});
    check(materials.back(), region.name);
  }
  return materials;
}

}  // namespace ritz::config
