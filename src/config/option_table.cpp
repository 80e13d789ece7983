#include "ritz/config/option_table.hpp"

#include <array>
#include <iomanip>
#include <sstream>

#include "ritz/fem/material.hpp"

namespace ritz::config {
namespace {

constexpr std::array entries = std::to_array<OptionEntry>({
    {"mesh", "FILE | box:LX,LY,LZ/NX,NY,NZ/TYPE", "", "required",
     "the mesh: .msh, .veg, .inp or .vtu, or a generated beam of tet4, tet10, hex8, hex20, wedge6 or wedge15"},
    {"units", "LENGTH-MASS-TIME", "", "m-kg-s",
     "the units of the mesh, its materials, -material_* and -fix box:, such as mm-t-s"},
    {"partitioner", "metis | ptscotch", "", "metis", "what cuts a mesh file into one part a rank"},
    {"fix", "SET[:xyz],... | FILE.bou | box:x0,x1,y0,y1,z0,z1[:xyz] | none", "", "the mesh file's own",
     "what is held, and which components; a SET with ',' in its name, or one that ends like ':x', stands in double "
     "quotes "
     "(in a shell and in an options file: -fix '\"side:x\":yz'), and nset:SET, elset:SET or surface:SET say which of "
     "several sets of one name"},
    {"ignore", "WORD,...", "", "none",
     "keywords and element types of the mesh file that change the physics, that ritz cannot do, and that are left out "
     "on your word, such as TIE,EQUATION; a warning stays in the model"},
    {"material_young", "E", "Pa, > 0", "the mesh file's",
     "Young's modulus; -material_REGION_young for one region, _ for a blank in its name"},
    {"material_poisson", "NU", "-1 < nu < 0.5", "the mesh file's", "Poisson's ratio; -material_REGION_poisson"},
    {"material_density", "RHO", "kg/m3, > 0", "the mesh file's", "density; -material_REGION_density"},
    {"material_law", "LAW", "", "the mesh file's, else stvk",
     "the law, one of those below; -material_REGION_law. Modes are the same for all that are alike at rest"},
    {"material_constants", "A,B,...", "", "the mesh file's",
     "the constants of a law that is not of E and nu, in the order and units of the list below; "
     "-material_REGION_constants"},
    {"material_axes", "X1,Y1,Z1,X2,Y2,Z2", "", "1,0,0,0,1,0",
     "where stvk-orthotropic's first axis points, and a second vector in the plane of its first and second; "
     "-material_REGION_axes"},
    {"modes", "K", "0 ... ", "20", "flexible modes wanted; a cluster at K is kept whole, rigid modes are extra"},
    {"modes_block", "P", "1 ... 64", "4", "block size of the Lanczos iteration"},
    {"modes_tolerance", "T", "1e-14 ... 1e-2", "1e-10", "relative residual at which Lanczos stops"},
    {"derivatives", "K'", "0 ... modes", "0", "modal derivatives of the first so many modes; a cluster is kept whole"},
    {"basis_modes", "I,J,...", "1 ... modes", "all", "the flexible modes that enter the basis and the derivatives"},
    {"basis", "R", "1 ... ", "all",
     "columns of U: the principal directions, by mass, of modes, derivatives and snapshots, scaled by frequency"},
    {"basis_tolerance", "T", "1e-12 ... 0.999", "1e-12",
     "in place of -basis: the smallest singular value kept, relative"},
    {"snapshots", "FILE", "", "none",
     "displacements for proper orthogonal decomposition (POD): .npy, or HDF5 with /snapshots; a row of 3n numbers "
     "each"},
    {"residual_vectors", "SET,...,gravity | all", "", "none",
     "the static answers to a unit load on these sets along x, y and z, shared by the vertices as a scene's total, and "
     "to "
     "gravity join the basis (all: every set and gravity), beside what -basis counts: with them these loads are exact "
     "in "
     "statics as long as displacements are small; a free body answers by inertia relief"},
    {"static_error", "", "", "off",
     "say how much of the static answer to a load on each set and to gravity the basis misses also where that takes "
     "more "
     "than a few solves: with -solver iterative, for a free body, and for more than 15 sets"},
    {"polynomial", "", "", "off",
     "reduce the forces of stvk (St. Venant-Kirchhoff) materials to their exact polynomial, for large displacements"},
    {"accuracy", "E", "1e-6 ... 0.5", "none",
     "choose modes, derivatives and columns by themselves: the smallest basis whose error on the static load path of "
     "-accuracy_scene, relative and in the M-norm, is below E; with its polynomial"},
    {"accuracy_scene", "FILE.toml", "", "none", "the scene for -accuracy: its loads, grown from nothing to their most"},
    {"solver", "direct | iterative | auto", "", "auto",
     "direct: MUMPS, certified; iterative: multigrid, less memory, not certified"},
    {"reuse", "FILE.h5", "", "none",
     "take the modes, or the whole basis, from an earlier model of the same mesh, materials and supports"},
    {"surface_only", "", "", "off", "store only the rows of U on the surface"},
    {"export", "matrixmarket | petsc", "", "none", "write K, M and the modes beside the model, in the file's order"},
    {"output", "FILE.h5", "", "model.h5",
     "the model (ritz-full: the motion, by default full.h5); its tables stand beside it and are named after it"},
    {"summary", "FILE.json", "", "none", "write everything that is printed as numbers, to a file that scripts read"},
    {"plan", "", "", "off", "print the stages, their memory and time, and stop"},
    {"quiet", "", "", "off", "print only warnings and errors"},
    {"options_file", "FILE", "", "none",
     "options from a file, one a line, quotes as on a command line (.yml or .yaml: YAML); the command line wins"},
    {"help", "", "", "", "this text"},
    {"version", "", "", "", "the versions of this program and of its libraries"},
    {"log_view", "stdout | :FILE | :FILE:FORMAT", "", "off",
     "PETSc's own timing table, by named stages; FORMAT is ascii_info_detail, ascii_csv, ascii_xml or "
     "ascii_flamegraph"},
    {"scene", "FILE.toml", "", "", "ritz-full, required: what is done to the body, as for ritz-run --scene"},
    {"restart", "FULL.h5", "", "none", "ritz-full: go on from the last state of an earlier run of the same problem"},
    {"frames", "N", "0 ... ", "all states, at most 201", "ritz-full: displacement frames, evenly spread"},
    {"every", "N", "1 ... ", "none", "ritz-full: a displacement frame every so many steps, in place of -frames"},
    {"timing", "FILE.csv", "", "none", "ritz-full: a table of what each step cost, without recording"},
});

constexpr std::string_view reduce_text =
    "Turns a finite element mesh into a reduced model: reads it, assembles K and M, solves for the lowest\n"
    "vibration modes, and writes one HDF5 file that ritz-run moves and ritz-inspect prints. Options marked ritz-full\n"
    "are that program's and have no effect here.\n";
constexpr std::string_view full_text =
    "Moves a finite element mesh as a scene says, unreduced: statics, or the integrators avf (average vector field, "
    "the\n"
    "default), newmark and implicit-euler. Writes one HDF5 file of frames, snapshots and the last state, an .xdmf for\n"
    "ParaView, and tables of probes and energy. Of the options below it looks at those for the mesh, units, supports, "
    "materials, "
    "the\n"
    "solver, the output and those marked ritz-full; the others are ritz-reduce's and have no effect here.\n";

}  // namespace

std::span<const OptionEntry> option_table() { return entries; }

std::string help_text(std::string_view program) {
  std::ostringstream out;
  out << "usage: mpirun -n RANKS " << program << " -mesh FILE [-option [value]]...\n\n"
      << (program == "ritz-full" ? full_text : reduce_text) << "\noptions:\n";
  for (const auto& e : entries) {
    out << "  -" << e.name << (e.argument.empty() ? "" : " ") << e.argument << "\n      " << e.text << '\n';
    if (e.unit.empty() && e.fallback.empty()) continue;
    out << "      " << (e.unit.empty() ? "" : "[") << e.unit << (e.unit.empty() ? "" : "] ")
        << (e.fallback.empty() ? "" : "default: ") << e.fallback << '\n';
  }
  out << "\nlaws, and what they are made of:\n";
  for (const auto name : fem::law_names())
    out << "  " << name << std::string(24 - name.size(), ' ')
        << fem::constants_of(name).value_or("-material_young, -material_poisson") << '\n';
  out << "  (C, mu, E, G in Pa, D in 1/Pa: the volumetric energy is (J-1)^2/D; alpha, lambda_m, nu without units)\n"
         "\nsolvers: options under -solve_ksp_, -solve_pc_ and -solve_mat_mumps_ reach the factorization, those under\n"
         "-multigrid_pc_ the levels of the multigrid, those under -newton_snes_ the Newton iterations of ritz-full; "
         "any option under -modes_eps_ or -modes_st_ hands the modes of "
         "the\n"
         "direct strategy to SLEPc (Krylov-Schur, or the solver that it names).\n"
         "exit codes: 0 done; 1 the numerics failed; 2 the input is wrong.\n";
  return out.str();
}

}  // namespace ritz::config
