// All settings of a run of ritz-reduce or ritz-full, as plain values.
#pragma once
#include <mpi.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ritz/base/program.hpp"
#include "ritz/config/options.hpp"
#include "ritz/fem/material.hpp"
#include "ritz/mesh/dofs.hpp"
#include "ritz/mesh/read.hpp"
#include "ritz/stages/basis.hpp"
#include "ritz/stages/linear_modes.hpp"
#include "ritz/stages/train_cubature.hpp"

namespace ritz::config {

/// The material that options give; the mesh file gives the rest.
struct MaterialOptions {
  std::optional<std::string> law;                 ///< one of fem::law_names()
  std::optional<double> young, poisson, density;  ///< in the units of -units
  std::optional<std::vector<double>> constants;   ///< of a law that is not of young and poisson, in those units
  std::optional<std::vector<double>> axes;        ///< six numbers: two axes of an orthotropic law
};

enum class Solver { automatic, direct, iterative };
enum class StoredRows { all, surface };
enum class Goal { model, plan };
/// Whether the user gave the units of the mesh; if nobody did, they are SI by default.
enum class UnitsOf { nobody, user };
enum class Export { nothing, matrixmarket, petsc };

/// Settings of ritz-full alone.
struct FullOptions {
  std::filesystem::path scene;
  std::optional<std::filesystem::path> restart;
  std::optional<std::int64_t> frames, every;
  std::optional<std::filesystem::path> timing;  ///< table of the cost of each step
};

/// The size of the basis is chosen by its error on the static load path of a scene.
struct AccuracyOptions {
  double target = 0;  ///< largest relative error, in the M-norm
  std::filesystem::path scene;
};

enum class LoadedSets { named, all };
enum class GravityLoad { left_out, included };

/// The loads whose static answers join the basis as residual vectors.
struct ResidualLoads {
  LoadedSets which = LoadedSets::named;
  GravityLoad gravity = GravityLoad::left_out;
  std::vector<std::string> sets;  ///< as the user wrote them
};

/// Whether the static errors of loads are worked out where that takes long.
enum class StaticErrors { where_cheap, always };

/// Whether the discretization error of each mode is estimated.
enum class MeshErrors { unknown, estimated };

/// Whether the nonlinear forces are reduced: exactly, to a polynomial, where the laws of all regions have one, else
/// with a cubature.
enum class ReducedForces { none, by_laws, cubature };

enum class Program { reduce, full };

struct Config {
  mesh::Source source;
  UnitsOf units = UnitsOf::nobody;
  std::vector<mesh::Fixed> supports;
  mesh::FileSupports file_supports = mesh::FileSupports::used;
  MaterialOptions material;                          ///< for every region
  std::map<std::string, MaterialOptions> by_region;  ///< takes precedence over `material`
  Solver solver = Solver::automatic;
  stages::ModesOptions modes;
  MeshErrors mesh_errors = MeshErrors::unknown;
  std::optional<stages::BasisOptions> basis;  ///< absent: U consists of the modes
  std::optional<AccuracyOptions> accuracy;    ///< chooses the size of the basis
  std::optional<std::filesystem::path> snapshots;
  std::optional<ResidualLoads> residual_vectors;
  StaticErrors static_errors = StaticErrors::where_cheap;
  ReducedForces forces = ReducedForces::none;
  stages::CubatureOptions cubature;  ///< if there is one
  std::optional<std::filesystem::path> reuse;
  StoredRows rows = StoredRows::all;
  Goal goal = Goal::model;
  Voice voice = Voice::normal;
  Export exported = Export::nothing;
  std::filesystem::path output = "model.h5";
  std::optional<std::filesystem::path> summary;     ///< file for the results as numbers (JSON)
  std::vector<std::filesystem::path> option_files;  ///< named on the command line
  FullOptions full;
  std::vector<Option> reports;        ///< options of solvers, and of the log, whose value is a file that they write
  std::vector<std::string> warnings;  ///< about settings that were given but are not read
  std::vector<std::pair<std::string, std::string>> resolved;  ///< name and value of every option, defaults included
};

/// *Collective*. Reads and checks the options of a program, passes the options of solvers on to them, and refuses all
/// others, including those of the other program. Throws InputError on all ranks.
Config read_config(MPI_Comm comm, Given given, Program program = Program::reduce);

/// The material of each region, in SI units: -material_REGION_* takes precedence over -material_*, and that over the
/// mesh file. In REGION '_' may stand for a blank, and REGION may also be the name of a larger volume that contains the
/// region. Throws InputError for a region whose material is incomplete or impossible, and for a region name that does
/// not exist or is ambiguous.
fem::Materials region_materials(const Config& config, const std::vector<mesh::Region>& regions);

}  // namespace ritz::config
