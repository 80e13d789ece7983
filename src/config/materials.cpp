#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
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
  auto wrong = fem::impossible(material.law);
  const fem::ParameterValue density{density_of_mass, material.density};
  if (!wrong && !density.possible()) wrong = density;
  if (wrong)
    throw InputError("the " + std::string(wrong->parameter.words) + " of region '" + region + "' is " +
                     shown(wrong->value) + "; it must be " + range(wrong->parameter));
}

/// A member of the options of materials, and the word that ends its name.
template <class Value>
struct Member {
  std::optional<Value> MaterialOptions::*member;
  const char* word;
};

constexpr Member<std::string> law_member = {&MaterialOptions::law, "law"};
constexpr Member<std::vector<double>> constants_member = {&MaterialOptions::constants, "constants"};
constexpr Member<std::vector<double>> axes_member = {&MaterialOptions::axes, "axes"};

struct Place {
  Member<double> option;
  std::optional<double> mesh::FileMaterial::*of_file;
  double factor;  ///< to SI
};

/// Where the value of a parameter is said.
Place place(const fem::Parameter& parameter, const mesh::Units& units) {
  const std::string_view name = parameter.name;
  if (name == "young") return {{&MaterialOptions::young, "young"}, &mesh::FileMaterial::young, units.pressure()};
  if (name == "poisson") return {{&MaterialOptions::poisson, "poisson"}, &mesh::FileMaterial::poisson, 1};
  if (name == "density") return {{&MaterialOptions::density, "density"}, &mesh::FileMaterial::density, units.density()};
  throw std::logic_error("no option states the parameter '" + std::string(name) + "' of a law");
}

/// What options and the mesh file say of the materials. Options that no region's law takes are an error: they would be
/// passed over in silence.
class Sources {
 public:
  Sources(const Config& config, const std::vector<mesh::Region>& regions)
      : config_(config), own_(named_options(config, regions)) {}

  /// The value of a region's own option, else of the general one.
  template <class Value>
  std::optional<Value> option(const mesh::Region& region, const Member<Value>& of) {
    used_.insert(of.word);
    if (const auto own = own_value(own_, region, of.member, of.word)) return own;
    return config_.material.*of.member;
  }

  const mesh::Units& units() const { return config_.source.units; }

  /// After all regions: every kind of option that was given must have been asked for by one of them.
  void require_used(const fem::Materials& materials) const {
    const auto given = [&](auto member) {
      const auto has = [&](const auto& entry) { return (entry.second.*member).has_value(); };
      return (config_.material.*member).has_value() || std::ranges::any_of(config_.by_region, has);
    };
    const auto require = [&](const auto& of) {
      if (used_.contains(of.word) || !given(of.member)) return;
      std::string laws;
      for (const auto& material : materials)
        if (const std::string law = fem::name(material.law); laws.find(law) == laws.npos)
          laws += (laws.empty() ? "" : ", ") + law;
      throw InputError(std::string("option -material_") + of.word +
                       " does nothing: no region has a law that takes it (" + laws +
                       "); leave it out, or name the law with -material_law");
    };
    require(Member<double>{&MaterialOptions::young, "young"});
    require(Member<double>{&MaterialOptions::poisson, "poisson"});
    require(constants_member);
    require(axes_member);
  }

 private:
  const Config& config_;
  std::map<std::string, const MaterialOptions*> own_;
  std::set<std::string_view> used_;
};

std::string options_for(const mesh::Region& region, const std::string& word) {
  return "-material_" + word + " or -material_" + underscored(region.name) + "_" + word;
}

/// A parameter that has an option of its own, in SI.
double parameter_value(Sources& sources, const mesh::Region& region, const fem::Parameter& parameter) {
  const auto [option, of_file, factor] = place(parameter, sources.units());
  if (const auto given = sources.option(region, option)) return *given * factor;
  if (region.material.*of_file) return *(region.material.*of_file);
  const auto options = options_for(region, option.word);
  const auto& unread =
      parameter.name == std::string_view("density") ? region.material.unread_density : region.material.unread_law;
  if (!unread.empty()) throw InputError(unread + "; another can be put in its place by " + options);
  const auto& m = region.material;
  const bool bare = !m.young && !m.poisson && !m.density;
  throw InputError("region '" + region.name + "' has no " + (bare ? "material" : parameter.words) + ": give " +
                   options);
}

/// A law whose constants are listed, in SI.
fem::AnyLaw listed_law(Sources& sources, const mesh::Region& region, const std::string& name) {
  const std::string words(*fem::constants_of(name));
  const bool turns = name == fem::OrthotropicStVK::name;
  const auto given = sources.option(region, constants_member);
  const auto axes = turns ? sources.option(region, axes_member) : std::nullopt;
  auto law = region.material.law && fem::name(*region.material.law) == name ? region.material.law : std::nullopt;
  if (given) {
    law = fem::law_of_constants(name, *given);
    if (!law)
      throw InputError("the law " + name + " of region '" + region.name + "' takes the constants " + words + "; " +
                       std::to_string(given->size()) + " numbers are given");
    law = fem::to_si(*law, sources.units().pressure());
  }
  if (!law)
    throw InputError("the law " + name + " of region '" + region.name + "' has no constants: give " + words + " with " +
                     options_for(region, "constants"));
  if (!axes) return *law;
  if (axes->size() != 6)
    throw InputError("the axes of region '" + region.name + "' are six numbers, X1,Y1,Z1,X2,Y2,Z2; " +
                     std::to_string(axes->size()) + " are given");
  auto values = std::get<fem::OrthotropicStVK>(*law).values();
  std::ranges::copy(*axes, values.end() - 6);
  return fem::OrthotropicStVK(values);
}

}  // namespace

fem::Materials region_materials(const Config& config, const std::vector<mesh::Region>& regions) {
  Sources sources(config, regions);
  fem::Materials materials;
  for (const auto& region : regions) {
    const auto& of_file = region.material.law;
    const auto name = sources.option(region, law_member).value_or(of_file ? fem::name(*of_file) : fem::default_law);
    const auto value = [&](const fem::Parameter& p) { return parameter_value(sources, region, p); };
    const auto law = fem::constants_of(name) ? listed_law(sources, region, name) : *fem::make_law(name, value);
    materials.push_back({law, value(density_of_mass)});
    check(materials.back(), region.name);
  }
  sources.require_used(materials);
  return materials;
}

}  // namespace ritz::config
