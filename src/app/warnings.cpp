#include "ritz/app/warnings.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ritz/algebra/blas.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/fem/geometry.hpp"
#include "ritz/mesh/mesh.hpp"
#include "ritz/mesh/quality.hpp"
#include "ritz/mesh/read.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/each_cell.hpp"

namespace ritz::app {
namespace {

// From the softest gels to diamond, from aerogel to osmium.
constexpr double least_young = 10, most_young = 1.5e12, least_density = .5, most_density = 2.4e4;
constexpr double least_speed = .3, most_speed = 2.5e4;  ///< √(E/ρ), m/s
constexpr double dense = 2000, dense_speed = 12;  ///< filled elastomers and soils are faster; metals in MPa are not
constexpr double hard_speed = 300;                ///< of a guess: what is dense is a metal, a stone or a ceramic
constexpr double light = 10, light_speed = 2e3;   ///< of a guess: what is light is a foam
constexpr double smallest = 1e-8, largest = 2e3;  ///< of bodies that a guess of units may lead to, m
constexpr double most_mass = 1e6;                 ///< kg
constexpr double shortest_of_millimetres = 3e-4;  ///< m

bool within(double value, double least, double most) { return value >= least && value <= most; }

bool possible(double young, double density) {
  return within(young, least_young, most_young) && within(density, least_density, most_density) &&
         within(std::sqrt(young / density), density > dense ? dense_speed : least_speed, most_speed);
}

bool likely(double young, double density) {
  const double speed = std::sqrt(young / density);
  return possible(young, density) && (density < dense || speed > hard_speed) &&
         (density > light || speed < light_speed);
}

bool likely(double young, double density, const Extent& extent) {
  return likely(young, density) && within(extent.size.maxCoeff(), smallest, largest) && extent.mass <= most_mass;
}

/// The numbers of a file and its options, taken in another system than they were.
Extent reread(const Extent& extent, const mesh::Units& from, const mesh::Units& to) {
  return {extent.size * (to.length / from.length), extent.mass * (to.mass / from.mass)};
}

/// What of a material its size and its speed of sound depend on.
struct Solid {
  double young, density;
};

Solid solid(const fem::Material& material) { return {material.at_rest().young(), material.density}; }

/// Of some systems the first in which the constants of a region and the body's extent are all plausible.
std::optional<std::string> likely_units(std::initializer_list<const char*> systems, const Solid& m,
                                        const Extent& extent, const mesh::Units& from) {
  for (const char* name : systems) {
    const auto to = mesh::parse_units(name);
    if (likely(m.young * (to.pressure() / from.pressure()), m.density * (to.density() / from.density()),
               reread(extent, from, to)))
      return name;
  }
  return std::nullopt;
}

struct Unit {
  const char* name;
  double factor;  ///< to SI
};

/// The unit of `system` first, nameless, then the others.
std::vector<Unit> all_units(double system, std::initializer_list<Unit> others) {
  std::vector<Unit> units = {{"", system}};
  for (const Unit& unit : others)
    if (std::abs(unit.factor / system - 1) > 1e-9) units.push_back(unit);
  return units;
}

/// "a Young's modulus in MPa": the one unit, or two, that the numbers given would be in if lengths are right.
std::optional<std::string> likely_constants(const Solid& m, const mesh::Units& from) {
  for (const Unit& stress : all_units(from.pressure(), {{"Pa", 1}, {"MPa", 1e6}, {"GPa", 1e9}, {"psi", 6894.757}}))
    for (const Unit& density :
         all_units(from.density(),
                   {{"kg/m3", 1}, {"g/cm3", 1e3}, {"t/mm3", 1e12}, {"kg/mm3", 1e9}, {"lbf s2/in4", 1.06869e7}})) {
      if (!likely(m.young * (stress.factor / from.pressure()), m.density * (density.factor / from.density()))) continue;
      const std::string young = *stress.name ? std::string("a Young's modulus in ") + stress.name : "";
      const std::string rho = *density.name ? std::string("a density in ") + density.name : "";
      return young + (young.empty() || rho.empty() ? "" : " and ") + rho;
    }
  return std::nullopt;
}

std::string constants(const Solid& m) {
  return "E = " + shown(m.young, 3) + " Pa and a density of " + shown(m.density, 3) + " kg/m3";
}

std::string unlikely_material(const mesh::Region& region, const Solid& m, const Extent& extent,
                              const mesh::Units& units) {
  const std::string what = "no solid has the constants of region '" + region.name + "', " + constants(m) +
                           " (a wave speed of " + shown(std::sqrt(m.young / m.density), 3) + " m/s)";
  const std::string looks = ": the numbers look like those of -units ";
  if (const auto other = likely_units({"m-kg-s", "mm-t-s", "mm-kg-ms"}, m, extent, units)) return what + looks + *other;
  if (const auto other = likely_constants(m, units))
    return what + ": they look like " + *other + ", and must be in those of -units " + units.name;
  if (const auto other = likely_units({"cm-g-s", "mm-g-ms", "um-kg-s", "mm-kg-s", "um-g-us"}, m, extent, units))
    return what + looks + *other;
  return what + ": check their units against -units " + units.name;
}

}  // namespace

Extent extent(const mesh::Mesh& mesh, const fem::Materials& materials) {
  double mass = 0;
  stages::each_owned_cell(mesh, materials, [&](const stages::Cell& cell) {
    mass += cell.material.density * fem::volume(cell.type, cell.x);
  });
  return {mesh::bounding_box(mesh).size(), parallel::sum(mesh.comm, mass)};
}

std::string size_line(const Extent& extent, const model::Modes& modes) {
  const auto& s = extent.size;
  std::string text = "size " + shown(s.x(), 4) + " x " + shown(s.y(), 4) + " x " + shown(s.z(), 4) + " m, mass " +
                     shown(extent.mass, 4) + " kg";
  const auto first = std::ranges::find(modes.kinds, model::ModeKind::flexible) - modes.kinds.begin();
  if (first < modes.eigenvalues.size())
    text += ", first frequency " + shown(model::frequency(modes.eigenvalues[first]), 4) + " Hz";
  return text;
}

std::vector<std::string> unit_warnings(const Extent& extent, const std::vector<mesh::Region>& regions,
                                       const fem::Materials& materials, const config::Config& config) {
  const auto& units = config.source.units;
  const double length = extent.size.maxCoeff();
  for (std::size_t i = 0; i < materials.size(); ++i)
    if (const Solid m = solid(materials[i]); !possible(m.young, m.density))
      return {unlikely_material(regions[i], m, extent, units)};
  const std::string body = "the body is " + shown(length, 3) + " m long and weighs " + shown(extent.mass, 3) + " kg";
  if (config.units == config::UnitsOf::nobody && extent.mass > most_mass)
    return {body + ": if its lengths are in millimetres, say -units mm-t-s, and the material in MPa and t/mm3 (" +
            shown(solid(materials[0]).young * 1e-6, 3) + " and " + shown(materials[0].density * 1e-12, 3) +
            "); if it is as large as that, say -units " + units.name};
  if (units.length == 1e-3 && length < shortest_of_millimetres)
    return {body + " with -units " + units.name + ": if its lengths are in metres, say -units m-kg-s"};
  return {};
}

namespace {

/// Above these Poisson's ratios linear cells are visibly too stiff: tetrahedra cannot change shape at constant volume,
/// the others only in few ways.
constexpr double locking_tetrahedra = .45, locking_others = .49;

/// The types of linear cells that lock in a nearly incompressible material: "tet4, hex8"; empty if there are none.
std::string locking_cells(const mesh::Mesh& mesh, const fem::Materials& materials) {
  std::vector<std::int32_t> locks(fem::cell_types.size(), 0);
  for (int c = 0; c < mesh.cells.owned; ++c) {
    const auto i = static_cast<std::size_t>(c);
    const auto type = mesh.cells.types[i];
    if (fem::shape(type).quadratic()) continue;
    const double limit = type == fem::CellType::tet4 ? locking_tetrahedra : locking_others;
    if (materials[static_cast<std::size_t>(mesh.cells.regions[i])].at_rest().poisson() > limit)
      locks[static_cast<std::size_t>(type)] = 1;
  }
  std::string names;
  for (const auto type : fem::cell_types)
    if (parallel::max(mesh.comm, locks[static_cast<std::size_t>(type)]) > 0)
      names += (names.empty() ? "" : ", ") + std::string(fem::shape(type).name);
  return names;
}

bool free_by_default(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs) {
  return config.file_supports == mesh::FileSupports::used && dofs.total == mesh::components * mesh.vertices_total;
}

}  // namespace

std::vector<std::string> warnings(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
                                  const fem::Materials& materials) {
  auto notes = mesh::warnings(mesh);
  if (const auto names = locking_cells(mesh, materials); !names.empty())
    notes.push_back(
        "linear cells (" + names +
        ") lock in a nearly incompressible material: the body comes out too stiff, its frequencies too high; "
        "use quadratic cells (tet10, hex20)");
  const auto of_units = unit_warnings(extent(mesh, materials), mesh.regions, materials, config);
  notes.insert(notes.end(), of_units.begin(), of_units.end());
  if (free_by_default(config, mesh, dofs))
    notes.push_back(
        "nothing holds the body: there is no -fix, and the mesh states no supports; hold it with -fix SET, or say -fix "
        "none for a free body");
  if (!algebra::blas_is_openblas())
    notes.push_back(
        "the BLAS that is loaded is not OpenBLAS; with the reference BLAS factorizations take several times longer "
        "(Debian: libopenblas-dev)");
  return notes;
}

}  // namespace ritz::app
