#include <cmath>

#include "ritz/base/error.hpp"
#include "ritz/base/nearest.hpp"
#include "ritz/config/config.hpp"

namespace ritz::config {
namespace {

std::string shown(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

void refuse_unknown_regions(const Config& config, const std::vector<mesh::Region>& regions) {
  std::vector<std::string> names;
  for (const auto& region : regions) names.push_back(region.name);
  for (const auto& [name, material] : config.by_region) {
    bool known = false;
    for (const auto& region : names) known = known || edit_distance(region, name) == 0;
    if (!known)
      throw InputError("option -material_" + name + "_...: the mesh has no region '" + name + "'; did you mean '" +
                       nearest(name, names) + "'?");
  }
}

const MaterialOptions* own_options(const Config& config, const std::string& region) {
  for (const auto& [name, material] : config.by_region)
    if (edit_distance(name, region) == 0) return &material;
  return nullptr;
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
  refuse_unknown_regions(config, regions);
  const auto& units = config.source.units;
  std::vector<fem::StVK> materials;
  for (const auto& region : regions) {
    const MaterialOptions* own = own_options(config, region.name);
    const auto value = [&](std::optional<double> MaterialOptions::*member, double factor, double fem::StVK::*from,
                           const std::string& word) {
      if (own && own->*member) return *(own->*member) * factor;
      if (config.material.*member) return *(config.material.*member) * factor;
      if (region.material) return *region.material.*from;
      throw InputError("region '" + region.name + "' has no material: give -material_" + word + " or -material_" +
                       region.name + "_" + word);
    };
    materials.push_back({value(&MaterialOptions::young, units.pressure(), &fem::StVK::young, "young"),
                         value(&MaterialOptions::poisson, 1, &fem::StVK::poisson, "poisson"),
                         value(&MaterialOptions::density, units.density(), &fem::StVK::density, "density")});
    check(materials.back(), region.name);
  }
  return materials;
}

}  // namespace ritz::config
