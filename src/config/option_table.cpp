#include "ritz/config/option_table.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <sstream>

#include "ritz/fem/material.hpp"

namespace ritz::config {
namespace {

constexpr auto mesh_options = std::to_array<OptionEntry>({
    {"mesh", "FILE | box:LX,LY,LZ/NX,NY,NZ/TYPE", "", "required",
     "the mesh: .msh, .veg, .inp or .vtu, or a generated beam of tet4, tet10, hex8, hex20, wedge6 or wedge15"},
    {"units", "LENGTH-MASS-TIME", "", "m-kg-s",
     "the units of the mesh, its materials, -material_* and -fix box:, such as mm-t-s"},
    {"fix", "SET[:xyz],... | FILE.bou | box:x0,x1,y0,y1,z0,z1[:xyz] | none", "", "the mesh file's own",
     "what is held, and which components. nset:SET, elset:SET or surface:SET say which of several sets of one name. A "
     "SET with ',' in its name, or one that ends like ':x', stands in double quotes, in a shell and in an options "
     "file: -fix '\"side:x\":yz'"},
    {"ignore", "WORD,...", "", "none",
     "keywords and element types of the mesh file that change the physics, that ritz cannot do, and that are left out "
     "on your word, such as TIE,EQUATION; a warning stays in the model"},
    {"partitioner", "metis | ptscotch", "", "metis", "what cuts a mesh file into one part a rank"},
});

constexpr auto material_options = std::to_array<OptionEntry>({
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
});

constexpr auto modes_options = std::to_array<OptionEntry>({
    {"modes", "K", "0 ...", "20", "flexible modes wanted; a cluster at K is kept whole, rigid modes are extra"},
    {"modes_block", "P", "1 ... 64", "4", "block size of the Lanczos iteration"},
    {"modes_tolerance", "T", "1e-14 ... 1e-2", "1e-10", "relative residual at which Lanczos stops"},
    {"mesh_error", "", "", "off",
     "estimate by how much the mesh makes each frequency too high, printed beside it; linear cells are compared with "
     "quadratic ones on the same mesh, which costs memory and time like theirs"},
    {"reuse", "FILE.h5", "", "none",
     "take the modes, or the whole basis, from an earlier model of the same mesh, materials and supports"},
});

constexpr auto basis_options = std::to_array<OptionEntry>({
    {"derivatives", "K'", "0 ... modes", "0", "modal derivatives of the first so many modes; a cluster is kept whole"},
    {"basis_modes", "I,J,...", "1 ... modes", "all", "the flexible modes that enter the basis and the derivatives"},
    {"basis", "R", "1 ...", "all",
     "columns of U: the principal directions, by mass, of modes, derivatives and snapshots, scaled by frequency"},
    {"basis_tolerance", "T", "1e-12 ... 0.999", "1e-12",
     "in place of -basis: the smallest singular value kept, relative"},
    {"snapshots", "FILE", "", "none",
     "displacements for proper orthogonal decomposition (POD): .npy, or HDF5 with /snapshots; rows of 3n numbers"},
    {"residual_vectors", "SET,...,gravity | all", "", "none",
     "the static answers to a unit load on these sets along x, y and z, shared by the vertices as a scene's total, and "
     "to gravity join the basis (all: every set and gravity), beside what -basis counts: with them these loads are "
     "exact in statics as long as displacements are small; a free body answers by inertia relief"},
    {"static_error", "", "", "off",
     "say how much of the static answer to a load on each set and to gravity the basis misses also where that takes "
     "more than a few solves: with -solver iterative, for a free body, and for more than 15 sets"},
    {"polynomial", "", "", "off",
     "reduce forces of large displacements: those of stvk and stvk-orthotropic materials to their exact polynomial; of "
     "other laws what that polynomial lacks by cubature, as -cubature_tolerance does"},
    {"cubature", "T", "1 ...", "by -cubature_tolerance",
     "reduce forces of large displacements of any law by cubature over so many cells, whose weights are trained"},
    {"cubature_tolerance", "E", "1e-8 ... 0.5", "0.001",
     "in place of -cubature: as many cells as bring the relative error of forces, in the energy norm and at poses that "
     "were not trained on, below E"},
    {"cubature_plain", "", "", "off",
     "cubature of the whole energy, not only of what the polynomial lacks of it; takes more cells for the same error"},
    {"cubature_poses", "N", "2 ...", "120", "poses to train on: half lifts of low modes, half statics"},
    {"cubature_amplitude", "A", "1e-6 ... 10", "0.5",
     "the largest displacement of these poses, as a part of the body's largest extent"},
    {"accuracy", "E", "1e-6 ... 0.5", "none",
     "choose modes, derivatives and columns by themselves: the smallest basis whose error on the static load path of "
     "-accuracy_scene, relative and in the M-norm, is below E; with its polynomial, or with a cubature to E/4"},
    {"accuracy_scene", "FILE.toml", "", "none", "the scene for -accuracy: its loads, grown from nothing to their most"},
});

constexpr auto model_options = std::to_array<OptionEntry>({
    {"output", "FILE.h5", "", "model.h5",
     "the model; tables, and the .hdf for ParaView, stand beside it and are named after it"},
    {"surface_only", "", "", "off", "store only the rows of U on the surface"},
    {"export", "matrixmarket | petsc", "", "none", "write K, M and the modes beside the model, in the file's order"},
    {"plan", "", "", "off", "print the stages, their memory and time, and stop"},
});

constexpr auto motion_options = std::to_array<OptionEntry>({
    {"scene", "FILE.toml", "", "required",
     "what is done to the body, as for ritz-run --scene; ritz-run --help-scene prints one with every key"},
    {"output", "FILE.h5", "", "full.h5",
     "the motion; tables, and the .xdmf for ParaView, stand beside it and are named after it"},
    {"frames", "N", "0 ...", "all states, at most 201", "displacement frames, evenly spread"},
    {"every", "N", "1 ...", "none", "a displacement frame every so many steps, in place of -frames"},
    {"timing", "FILE.csv", "", "none", "a table of what each step cost, without recording"},
    {"restart", "FULL.h5", "", "none", "go on from the last state of an earlier run of the same problem"},
});

constexpr auto solver_options = std::to_array<OptionEntry>({
    {"solver", "direct | iterative | auto", "", "auto",
     "direct: MUMPS, certified; iterative: multigrid, less memory, not certified"},
    {"log_view", "stdout | :FILE | :FILE:FORMAT", "", "off",
     "PETSc's own timing table, by named stages; FORMAT is ascii_info_detail, ascii_csv, ascii_xml or "
     "ascii_flamegraph"},
});

constexpr auto run_options = std::to_array<OptionEntry>({
    {"options_file", "FILE", "", "none",
     "options from a file, one a line, quotes as on a command line (.yml or .yaml: YAML); the command line wins"},
    {"summary", "FILE.json", "", "none", "write everything that is printed as numbers, to a file that scripts read"},
    {"quiet", "", "", "off", "print only warnings and errors"},
    {"verbose", "", "", "off",
     "print also how the numerics went: residuals, iterations, singular values, checks, participation factors"},
    {"help", "", "", "", "this text; -h and --help say the same"},
    {"version", "", "", "", "the versions of this program and of its libraries"},
});

enum class Reader { both, reduce, full };

/// Options of one topic, and what there is to say of all of them.
struct Topic {
  std::string_view title;
  Reader reader;
  std::span<const OptionEntry> options;
  std::string (*note)() = nullptr;
};

std::string laws_note() {
  std::string simple, listed;
  for (const auto name : fem::law_names()) {
    const auto constants = fem::constants_of(name);
    std::string& text = constants ? listed : simple;
    text += (text.empty() ? "" : "; ") + std::string(name);
    if (constants) text += " " + std::string(*constants);
  }
  return "Laws of -material_young and -material_poisson: " + simple + ". Laws of -material_constants: " + listed +
         ". There C, mu, E and G are in Pa, D in 1/Pa, alpha, lambda_m and nu without units, and the energy of "
         "a change of volume is (J-1)^2/D.";
}

std::string factorization_note() {
  return "Options of PETSc under -solve_ksp_, -solve_pc_ and -solve_mat_mumps_ reach the factorization, those under "
         "-multigrid_pc_ the levels of the multigrid.";
}

std::string modes_note() {
  return "Any option of SLEPc under -modes_eps_ or -modes_st_ hands the modes of the direct strategy to it: to "
         "Krylov-Schur, or the solver that it names.";
}

std::string motion_note() { return "Options of PETSc under -newton_snes_ reach the Newton iterations of a step."; }

constexpr std::array topics = {
    Topic{"The mesh and what holds it", Reader::both, mesh_options},
    Topic{"Materials", Reader::both, material_options, laws_note},
    Topic{"Vibration modes", Reader::reduce, modes_options, modes_note},
    Topic{"The basis and its forces, for large displacements", Reader::reduce, basis_options},
    Topic{"The model that is written", Reader::reduce, model_options},
    Topic{"The motion", Reader::full, motion_options, motion_note},
    Topic{"Solvers", Reader::both, solver_options, factorization_note},
    Topic{"The run", Reader::both, run_options},
};

bool reads(Program program, const Topic& topic) {
  return topic.reader == Reader::both || (topic.reader == Reader::full) == (program == Program::full);
}

constexpr std::string_view reduce_text = R"(usage: mpirun -n RANKS ritz-reduce -mesh FILE [-option [value]]...

Turns a finite element mesh into a reduced model: reads it, assembles K and M, solves for the
lowest vibration modes, and writes one HDF5 file that ritz-run moves and ritz-inspect prints. An
options file may hold options of ritz-full, which are read past.

Examples:
  ritz-reduce -mesh part.msh -fix bolts -material_young 2.06e11 -material_poisson 0.29 \
      -material_density 7850
          the 20 lowest modes of a steel part held by its set 'bolts'
  mpirun -n 2 ritz-reduce -mesh box:0.3,0.04,0.03/16,2,2/tet10 -fix xmin -material_young 1e6 \
      -material_poisson 0.3 -material_density 1000 -modes 8 -derivatives 8 -basis 20 -polynomial
          a generated beam of rubber that bends far, whose model.h5 ritz-run moves
  mpirun -n 2 ritz-reduce -options_file part.opts -plan
          what the work of an options file will cost, and nothing more
)";
constexpr std::string_view full_text =
    R"(usage: mpirun -n RANKS ritz-full -mesh FILE -scene FILE.toml [-option [value]]...

Moves a finite element mesh as a scene says, unreduced: statics, or the integrators avf
(average vector field, the default), newmark and implicit-euler. Writes one HDF5 file of frames,
snapshots and the last state, an .xdmf for ParaView, and tables of probes and energy. An options
file may hold options of ritz-reduce, which are read past.

Examples:
  mpirun -n 2 ritz-full -mesh box:0.3,0.04,0.03/16,2,2/tet10 -fix xmin -material_young 1e6 \
      -material_poisson 0.3 -material_density 1000 -scene pull.toml
          a generated beam of rubber, moved as pull.toml says
  mpirun -n 2 ritz-full -options_file part.opts -scene pull.toml -output full/full.h5
          a body that ritz-reduce has made a model of, to see how well that does
)";

constexpr std::size_t widest = 100;

/// The text in lines of at most 100 characters that begin with so many blanks. What stands in brackets stays together.
std::string wrapped(const std::string& text, std::size_t indent) {
  std::istringstream words(text);
  std::string lines, line;
  for (std::string word, rest; words >> word;) {
    if (word[0] == '[' && word.back() != ']' && std::getline(words, rest, ']')) word += rest + "]";
    if (!line.empty() && indent + line.size() + 1 + word.size() > widest) {
      lines += std::string(indent, ' ') + line + '\n';
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return lines + std::string(indent, ' ') + line + '\n';
}

std::string described(const OptionEntry& entry) {
  std::string limits(entry.unit);
  if (!entry.fallback.empty())
    limits += std::string(limits.empty() ? "" : "; ") + (entry.fallback == "required" ? "" : "default: ") +
              std::string(entry.fallback);
  return std::string(entry.text) + (limits.empty() ? "" : " [" + limits + "]");
}

}  // namespace

std::vector<OptionEntry> option_table(Program program) {
  std::vector<OptionEntry> all;
  for (const auto& topic : topics)
    if (reads(program, topic)) all.insert(all.end(), topic.options.begin(), topic.options.end());
  return all;
}

std::vector<std::string_view> option_names() {
  std::vector<std::string_view> names;
  for (const auto& topic : topics)
    for (const auto& entry : topic.options)
      if (std::ranges::find(names, entry.name) == names.end()) names.push_back(entry.name);
  return names;
}

std::string help_text(Program program) {
  std::string text(program == Program::full ? full_text : reduce_text);
  for (const auto& topic : topics) {
    if (!reads(program, topic)) continue;
    text += "\n" + std::string(topic.title) + ":\n";
    for (const auto& entry : topic.options) {
      text += "  -" + std::string(entry.name) + (entry.argument.empty() ? "" : " ") + std::string(entry.argument);
      text += "\n" + wrapped(described(entry), 6);
    }
    if (topic.note) text += wrapped(topic.note(), 2);
  }
  return text + "\nExit codes: 0 done; 1 the numerics failed; 2 the input is wrong.\n";
}

}  // namespace ritz::config
