#include "ritz/config/config.hpp"

#include <algorithm>
#include <sstream>

#include "ritz/base/error.hpp"
#include "ritz/config/solver_options.hpp"
#include "ritz/config/supports.hpp"
#include "ritz/stages/reduce_polynomial.hpp"

namespace ritz::config {
namespace {

constexpr double least_accuracy = 1e-6, most_accuracy = 0.5;

MaterialOptions read_material(Database& options, const std::string& prefix) {
  std::optional<std::string> law;
  if (options.has(prefix + "law")) {
    const auto known = fem::law_names();
    const std::vector<std::string> names(known.begin(), known.end());
    law = names[options.choice(prefix + "law", names, 0)];
  }
  return {law,
          options.real(prefix + "young"),
          options.real(prefix + "poisson"),
          options.real(prefix + "density"),
          options.reals(prefix + "constants"),
          options.reals(prefix + "axes")};
}

/// Regions that have options of their own: -material_REGION_young and so on.
std::map<std::string, MaterialOptions> read_regions(Database& options, const Given& given) {
  constexpr std::string_view start = "material_";
  std::map<std::string, MaterialOptions> regions;
  for (const auto& [name, value] : given.unread()) {
    if (!name.starts_with(start)) continue;
    for (const std::string_view end : {"_young", "_poisson", "_density", "_law", "_constants", "_axes"}) {
      if (!name.ends_with(end) || name.size() <= start.size() + end.size()) continue;
      const auto region = name.substr(start.size(), name.size() - start.size() - end.size());
      if (!regions.contains(region)) regions[region] = read_material(options, std::string(start) + region + "_");
    }
  }
  return regions;
}

/// "*Tie, rigid body".
mesh::Ignored read_ignored(Database& options) {
  mesh::Ignored ignored;
  const auto text = options.text("ignore");
  if (!text) return ignored;
  std::istringstream words(*text);
  for (std::string word; std::getline(words, word, ',');) {
    ignored.push_back(mesh::ignored_word(word));
    if (ignored.back().empty()) throw InputError("option -ignore " + *text + ": there is an empty word in the list");
  }
  return ignored;
}

mesh::Source read_source(Database& options) {
  mesh::Source source;
  source.units = mesh::parse_units(options.text("units", "m-kg-s"));
  source.partitioner = options.choice("partitioner", {"metis", "ptscotch"}, 0) == 0 ? mesh::Partitioner::metis
                                                                                    : mesh::Partitioner::ptscotch;
  source.ignored = read_ignored(options);
  const auto mesh = options.text("mesh");
  if (!mesh)
    throw InputError(
        "option -mesh is missing: give a mesh file or box:LX,LY,LZ/NX,NY,NZ/tet4 (-help lists all options)");
  if (mesh::names_box(*mesh)) source.mesh = mesh::parse_box(*mesh);
  else source.mesh = std::filesystem::path(*mesh);
  return source;
}

void read_supports(Database& options, Config& config) {
  const auto fix = options.text("fix");
  if (!fix) return;
  auto supports = parse_supports(*fix, config.source.units);
  config.supports = std::move(supports.fixed);
  config.source.vertex_lists = std::move(supports.vertex_lists);
  config.file_supports = mesh::FileSupports::ignored;
}

/// "4,9": ascending whole numbers from 1.
std::vector<int> read_mode_list(Database& options) {
  std::vector<int> modes;
  const auto text = options.text("basis_modes");
  if (!text) return modes;
  std::istringstream words(*text);
  for (std::string word; std::getline(words, word, ',');) {
    const bool digits = !word.empty() && word.size() < 7 && word.find_first_not_of("0123456789") == word.npos;
    const int mode = digits ? std::stoi(word) : 0;
    if (mode < 1 || (!modes.empty() && mode <= modes.back()))
      throw InputError("option -basis_modes " + *text +
                       ": write the numbers of flexible modes, from 1, ascending, such as 4,9");
    modes.push_back(mode);
  }
  return modes;
}

/// Any option of the cubature asks for one.
void read_forces(Database& options, Config& config) {
  const bool polynomial = options.flag("polynomial"), plain = options.flag("cubature_plain");
  const bool by_number = options.has("cubature"), by_tolerance = options.has("cubature_tolerance");
  const bool trained = options.has("cubature_poses") || options.has("cubature_amplitude");
  if (by_number && by_tolerance)
    throw InputError(
        "options -cubature and -cubature_tolerance say how many cells there are in two ways: leave out one or the "
        "other");
  if (polynomial && plain)
    throw InputError("options -polynomial and -cubature_plain contradict each other: leave out one or the other");
  auto& cubature = config.cubature;
  if (by_number) cubature.cells = options.integer("cubature", 1, 1);
  cubature.tolerance = options.real("cubature_tolerance", cubature.tolerance, 1e-8, 0.5);
  cubature.poses = options.integer("cubature_poses", cubature.poses, 2, 10000);
  cubature.amplitude = options.real("cubature_amplitude", cubature.amplitude, 1e-6, 10);
  cubature.integrand = plain ? model::Integrand::energy : model::Integrand::beyond_polynomial;
  if (by_number || by_tolerance || plain || trained) config.forces = ReducedForces::cubature;
  else if (polynomial) config.forces = ReducedForces::by_laws;
}

/// The options of the basis; any of them asks for one.
void read_basis(Database& options, Config& config) {
  stages::BasisOptions basis;
  basis.modes = read_mode_list(options);
  basis.derivatives = options.integer("derivatives", 0, 0);
  const bool by_size = options.has("basis");
  const bool by_tolerance = options.has("basis_tolerance");
  if (by_size && by_tolerance)
    throw InputError("options -basis and -basis_tolerance cut the basis in two ways: leave out one or the other");
  if (by_size) basis.cut.size = options.integer("basis", 0, 1);
  else basis.cut.tolerance = options.real("basis_tolerance", basis.cut.tolerance, 1e-12, 0.999);
  config.snapshots = options.text("snapshots");
  read_forces(options, config);
  if (config.forces != ReducedForces::none && basis.cut.size > stages::most_coordinates)
    throw InputError("option -basis " + std::to_string(basis.cut.size) +
                     " is too large for -polynomial and -cubature, which have at most " +
                     std::to_string(stages::most_coordinates) + " coordinates; lower it");
  if (basis.derivatives > config.modes.count)
    throw InputError("option -derivatives " + std::to_string(basis.derivatives) + " asks for more modes than -modes " +
                     std::to_string(config.modes.count) + "; raise -modes");
  if (basis.derivatives > 0 || by_size || by_tolerance || !basis.modes.empty() || config.snapshots ||
      config.forces != ReducedForces::none)
    config.basis = basis;
}

void read_static_loads(Database& options, Config& config) {
  config.static_errors = options.flag("static_error") ? StaticErrors::always : StaticErrors::where_cheap;
  const auto text = options.text("residual_vectors");
  if (!text) return;
  ResidualLoads loads;
  for (const auto& [name, quoted] : parse_names("residual_vectors", *text)) {
    if (!quoted && name == "all") loads.which = LoadedSets::all;
    if (!quoted && (name == "gravity" || name == "all")) loads.gravity = GravityLoad::included;
    else loads.sets.push_back(name);
  }
  config.residual_vectors = loads;
}

/// A target for the error asks for a basis and its reduced forces, and leaves nothing else to say of the basis.
void read_accuracy(Database& options, Config& config) {
  const auto target = options.real("accuracy");
  const auto scene = options.text("accuracy_scene");
  if (!target && !scene) return;
  if (!target || !scene)
    throw InputError(
        "options -accuracy and -accuracy_scene go together: a target, such as 1e-2, and the scene on which "
        "the error is measured");
  if (!(*target >= least_accuracy && *target <= most_accuracy))
    throw InputError("option -accuracy must be between 1e-6 and 0.5");
  for (const std::string other :
       {"basis", "basis_tolerance", "basis_modes", "derivatives", "snapshots", "residual_vectors", "cubature"})
    if (options.has(other)) throw InputError("option -accuracy chooses the basis by itself: leave out -" + other);
  config.accuracy = {*target, *scene};
  config.basis.emplace();
  if (config.forces == ReducedForces::none) config.forces = ReducedForces::by_laws;
  if (!options.has("cubature_tolerance")) config.cubature.tolerance = std::min(config.cubature.tolerance, *target / 4);
}

std::optional<std::int64_t> read_count(Database& options, const std::string& name) {
  if (!options.has(name)) return std::nullopt;
  return options.integer(name, 1, name == "every" ? 1 : 0);
}

FullOptions read_full(Database& options, Program program) {
  FullOptions full;
  const auto scene = options.text("scene");
  if (program == Program::full && !scene)
    throw InputError("option -scene is missing: give the scene file, which says what is done to the body");
  full.scene = scene.value_or("");
  full.restart = options.text("restart");
  full.frames = read_count(options, "frames");
  full.every = read_count(options, "every");
  full.timing = options.text("timing");
  if (program == Program::full && full.frames && full.every)
    throw InputError("options -frames and -every say the same thing in two ways: leave out one or the other");
  return full;
}

Voice read_voice(Database& options) {
  const bool quiet = options.flag("quiet"), verbose = options.flag("verbose");
  if (quiet && verbose)
    throw InputError("options -quiet and -verbose contradict each other: leave out one or the other");
  return quiet ? Voice::quiet : verbose ? Voice::verbose : Voice::normal;
}

}  // namespace

Config read_config(MPI_Comm comm, Given given, Program program) {
  Database options(given);
  Config config;
  if (options.has("units")) config.units = UnitsOf::user;
  config.source = read_source(options);
  read_supports(options, config);
  config.material = read_material(options, "material_");
  config.by_region = read_regions(options, given);
  config.modes.count = options.integer("modes", 20, 0);
  config.modes.block = options.integer("modes_block", 4, 1, 64);
  config.modes.tolerance = options.real("modes_tolerance", 1e-10, 1e-14, 1e-2);
  config.mesh_errors = options.flag("mesh_error") ? MeshErrors::estimated : MeshErrors::unknown;
  read_basis(options, config);
  read_accuracy(options, config);
  read_static_loads(options, config);
  if (program == Program::reduce && (config.accuracy || (config.basis && config.basis->derivatives > 0)))
    config.modes.inverse = stages::InverseUse::kept;
  const auto solvers = solver_options_given(given);
  config.modes.slepc = program == Program::reduce && std::ranges::any_of(solvers, is_slepc);
  config.solver = static_cast<Solver>(options.choice("solver", {"auto", "direct", "iterative"}, 0));
  if (config.modes.slepc && config.solver == Solver::iterative)
    throw InputError(
        "option -solver iterative: options under -modes_eps_ and -modes_st_ reach SLEPc under -solver direct; leave "
        "out one or the other");
  if (config.modes.slepc) config.solver = Solver::direct;
  config.reuse = options.text("reuse");
  config.rows = options.flag("surface_only") ? StoredRows::surface : StoredRows::all;
  config.goal = options.flag("plan") ? Goal::plan : Goal::model;
  if (program == Program::full && config.goal == Goal::plan)
    throw InputError("option -plan is ritz-reduce's: ritz-full has no plan to print; leave it out");
  config.voice = read_voice(options);
  config.exported = static_cast<Export>(options.choice("export", {"none", "matrixmarket", "petsc"}, 0));
  config.output = options.text("output", program == Program::full ? "full.h5" : "model.h5");
  config.summary = options.text("summary");
  config.full = read_full(options, program);
  config.reports = hand_to_solvers(comm, given);
  config.resolved = options.resolved();
  for (const auto& [name, value] : solvers) config.resolved.emplace_back(name, value);
  return config;
}

}  // namespace ritz::config
