// Everything a run of ritz-reduce or ritz-full is told, as plain values.
#pragma once
#include <mpi.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ritz/config/given.hpp"
#include "ritz/fem/material.hpp"
#include "ritz/mesh/dofs.hpp"
#include "ritz/mesh/read.hpp"
#include "ritz/stages/basis.hpp"
#include "ritz/stages/linear_modes.hpp"

namespace ritz::config {

/// What the options say of a material; what they leave open is the mesh file's.
struct MaterialOptions {
  std::optional<std::string> law;                 ///< one of fem::law_names()
  std::optional<double> young, poisson, density;  ///< in the units of -units
};

enum class Solver { automatic, direct, iterative };
enum class StoredRows { all, surface };
enum class Goal { model, plan };
enum class Voice { normal, quiet };
/// Who said what a mesh's units are: the user, or nobody, so that they are SI by default.
enum class UnitsOf { nobody, user };
enum class Export { nothing, matrixmarket, petsc };

/// What only ritz-full looks at.
struct FullOptions {
  std::filesystem::path scene;
  std::optional<std::filesystem::path> restart;
  std::optional<std::int64_t> frames, every;
  std::optional<std::filesystem::path> timing;  ///< a table of what each step cost
};

/// A basis chosen by its error on the static load path of a scene.
struct AccuracyOptions {
  double target = 0;  ///< relative, in the M-norm
  std::filesystem::path scene;
};

/// What becomes of the nonlinear forces.
enum class ReducedForces { none, polynomial };

enum class Program { reduce, full };

struct Config {
  mesh::Source source;
  UnitsOf units = UnitsOf::nobody;
  std::vector<mesh::Fixed> supports;
  mesh::FileSupports file_supports = mesh::FileSupports::used;
  MaterialOptions material;                          ///< for every region
  std::map<std::string, MaterialOptions> by_region;  ///< wins over `material`
  Solver solver = Solver::automatic;
  stages::ModesOptions modes;
  std::optional<stages::BasisOptions> basis;  ///< absent: U is the modes
  std::optional<AccuracyOptions> accuracy;    ///< chooses the basis's size
  std::optional<std::filesystem::path> snapshots;
  ReducedForces forces = ReducedForces::none;
  std::optional<std::filesystem::path> reuse;
  StoredRows rows = StoredRows::all;
  Goal goal = Goal::model;
  Voice voice = Voice::normal;
  Export exported = Export::nothing;
  std::filesystem::path output = "model.h5";
  std::optional<std::filesystem::path> summary;     ///< what is printed, as numbers
  std::vector<std::filesystem::path> option_files;  ///< that the command line names
  FullOptions full;
  std::vector<Option> reports;        ///< of solvers, and the log: options whose value is a file that they write
  std::vector<std::string> warnings;  ///< of what was given and left unread
  std::vector<std::pair<std::string, std::string>> resolved;  ///< every option as read or by default
};

/// Reads and cross-checks the options of a program, hands those of solvers to these, and refuses what nobody reads; its
/// sibling's are none of these. Throws InputError on all ranks alike. *Collective*.
Config read_config(MPI_Comm comm, Given given, Program program = Program::reduce);

/// The material of each region in SI: -material_REGION_* over -material_* over the mesh file's own; '_' may stand for a
/// blank in REGION, which may also name a larger volume that the region lies in. Throws InputError for a region without
/// a complete or with an impossible material, and for a region that does not exist or that cannot be told from another.
fem::Materials region_materials(const Config& config, const std::vector<mesh::Region>& regions);

}  // namespace ritz::config
