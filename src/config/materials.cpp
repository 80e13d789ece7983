#include <algorithm>
#include <cmath>

#include "ritz/base/error.hpp"
#include "ritz/base/nearest.hpp"
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

/// By region: the options of its own, or none.
std::vector<const MaterialOptions*> own_options(const Config& config, const std::vector<mesh::Region>& regions) {
  std::vector<std::string> names;
  for (const auto& region : regions) names.push_back(region.name);
  std::vector<const MaterialOptions*> own(regions.size(), nullptr);
  for (const auto& [name, material] : config.by_region) {
    auto& place = own[named_region(name, names)];
    if (place)
      throw InputError(option_of(name) + "another option writes the same region with its blanks; write it one way");
    place = &material;
  }
  return own;
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
  const auto options = own_options(config, regions);
  const auto& units = config.source.units;
  std::vector<fem::StVK> materials;
  for (const auto& region : regions) {
    const MaterialOptions* own = options[materials.size()];
    const auto value = [&](std::optional<double> MaterialOptions::*member, double factor,
                           const std::optional<double>& of_file, const std::string& word) {
      if (own && own->*member) return *(own->*member) * factor;
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
