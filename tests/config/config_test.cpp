// Where an option's value comes from: the command line over a file over the default; and what is refused.
#include "ritz/config/config.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "config/configured.hpp"
#include "ritz/base/error.hpp"
#include "support/shared_folder.hpp"

namespace ritz::config {
namespace {

using config::testing::configured;
using config::testing::with_box;
using test::SharedFolder;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Pair;
using ::testing::ThrowsMessage;

TEST(Config, HasTheDefaultsThatHelpStates) {
  const Config c = with_box({});
  EXPECT_EQ(c.modes.count, 20);
  EXPECT_EQ(c.modes.block, 4);
  EXPECT_EQ(c.modes.tolerance, 1e-10);
  EXPECT_FALSE(c.modes.slepc);
  EXPECT_EQ(c.solver, Solver::automatic);
  EXPECT_EQ(c.rows, StoredRows::all);
  EXPECT_EQ(c.goal, Goal::model);
  EXPECT_EQ(c.voice, Voice::normal);
  EXPECT_EQ(c.exported, Export::nothing);
  EXPECT_EQ(c.output, "model.h5");
  EXPECT_EQ(c.file_supports, mesh::FileSupports::used);
  EXPECT_EQ(c.source.units.name, "m-kg-s");
  EXPECT_EQ(c.source.partitioner, mesh::Partitioner::metis);
  EXPECT_FALSE(c.reuse);
  EXPECT_FALSE(c.material.young);
  EXPECT_TRUE(std::holds_alternative<mesh::Box>(c.source.mesh));
}

TEST(Config, ReadsTheCommandLine) {
  const Config c =
      configured({"-mesh",  "a b.msh", "-modes",       "7",        "-solver", "iterative", "-surface_only",   "-plan",
                  "true",   "-quiet",  "-export",      "petsc",    "-reuse",  "old.h5",    "-output",         "x/y.h5",
                  "-units", "mm-t-s",  "-partitioner", "ptscotch", "-fix",    "none",      "-material_young", "+1e6"});
  EXPECT_EQ(std::get<std::filesystem::path>(c.source.mesh), "a b.msh");
  EXPECT_EQ(c.modes.count, 7);
  EXPECT_EQ(c.solver, Solver::iterative);
  EXPECT_EQ(c.rows, StoredRows::surface);
  EXPECT_EQ(c.goal, Goal::plan);
  EXPECT_EQ(c.voice, Voice::quiet);
  EXPECT_EQ(c.exported, Export::petsc);
  EXPECT_EQ(c.reuse, "old.h5");
  EXPECT_EQ(c.output, "x/y.h5");
  EXPECT_EQ(c.source.units.length, 1e-3);
  EXPECT_EQ(c.source.partitioner, mesh::Partitioner::ptscotch);
  EXPECT_EQ(c.file_supports, mesh::FileSupports::ignored);
  EXPECT_TRUE(c.supports.empty());
  EXPECT_EQ(c.material.young, 1e6);
}

TEST(Config, KeepsTheFactorForDerivatives) {
  EXPECT_EQ(with_box({}).modes.inverse, stages::InverseUse::spent);
  EXPECT_EQ(with_box({"-basis", "3"}).modes.inverse, stages::InverseUse::spent);
  EXPECT_EQ(with_box({"-derivatives", "3"}).modes.inverse, stages::InverseUse::kept);
}

TEST(Config, TakesFlagsOffAgain) {
  EXPECT_EQ(with_box({"-quiet", "no"}).voice, Voice::normal);
  EXPECT_EQ(with_box({"-surface_only", "0"}).rows, StoredRows::all);
}

TEST(Config, LetsTheCommandLineWinOverFilesOverDefaults) {
  const SharedFolder folder;
  const auto file = folder.file("a.opts", "# ours\n\n-modes 5\n-modes_block 3   # wide\n-quiet\n");
  const Config after = with_box({"-options_file", file, "-modes", "6"});
  EXPECT_EQ(after.modes.count, 6);
  EXPECT_EQ(after.modes.block, 3);
  EXPECT_EQ(after.modes.tolerance, 1e-10);
  EXPECT_EQ(after.voice, Voice::quiet);
  EXPECT_EQ(with_box({"-modes", "6", "-options_file", file}).modes.count, 6);
  EXPECT_EQ(with_box({"-options_file", file}).modes.count, 5);
}

TEST(Config, ReadsYamlFlatAndNested) {
  const SharedFolder folder;
  for (const char* name : {"a.yaml", "a.yml"}) {
    const auto file =
        folder.file(name, "# ours\nmodes: 5\nquiet: true\nmaterial:\n  young: 2.5e9\n  lid:\n    density: 10\n");
    const Config c = with_box({"-options_file", file, "-material_poisson", ".25"});
    EXPECT_EQ(c.modes.count, 5);
    EXPECT_EQ(c.voice, Voice::quiet);
    EXPECT_EQ(c.material.young, 2.5e9);
    EXPECT_EQ(c.material.poisson, .25);
    ASSERT_TRUE(c.by_region.contains("lid"));
    EXPECT_EQ(c.by_region.at("lid").density, 10);
  }
}

TEST(Config, ReadsQuotesInFilesAsAShellDoes) {
  const SharedFolder folder;
  const auto file = folder.file("a.opts",
                                "-fix \"left end\",'#2':xy  # held\n"
                                "-material_'left end'_young 2e6\n-output 'a#b \"c\".h5'\n-quiet # '\n");
  const Config c = with_box({"-options_file", file, "-scene", "my scene.toml", "-reuse", "old model.h5"});
  ASSERT_EQ(c.supports.size(), 2);
  EXPECT_EQ(std::get<std::string>(c.supports[0].where), "left end");
  EXPECT_EQ(std::get<std::string>(c.supports[1].where), "#2");
  EXPECT_FALSE(c.supports[1].fixed[2]);
  ASSERT_TRUE(c.by_region.contains("left end"));
  EXPECT_EQ(c.by_region.at("left end").young, 2e6);
  EXPECT_EQ(c.output, "a#b \"c\".h5");
  EXPECT_EQ(c.voice, Voice::quiet);
  EXPECT_EQ(c.full.scene, "my scene.toml");  // a file leaves blanks of the command line alone
  EXPECT_EQ(c.reuse, "old model.h5");
}

TEST(Config, KeepsBlanksOfAFirstFileUnderASecond) {
  const SharedFolder folder;
  const auto first = folder.file("a.yaml", "output: \"my model.h5\"\nmodes: 4\n");
  const auto second = folder.file("b.opts", "-output other.h5\n-MODES 5\n-modes_block 2\n-modes_block 3\n");
  const Config c = with_box({"-options_file", first, "-options_file", second});
  EXPECT_EQ(c.output, "my model.h5");
  EXPECT_EQ(c.modes.count, 4);
  EXPECT_EQ(c.modes.block, 3);
}

TEST(Config, ReadsFilesOfWindows) {
  const SharedFolder folder;
  const Config c = with_box({"-options_file", folder.file("a.opts", "# ours\r\n\r\n-modes 5\r\n-output b.h5\r\n")});
  EXPECT_EQ(c.modes.count, 5);
  EXPECT_EQ(c.output, "b.h5");
}

TEST(Config, HandsTheModesToSlepcWhenItsOptionsAreNamed) {
  EXPECT_TRUE(with_box({"-modes_eps_type", "lapack"}).modes.slepc);
  EXPECT_TRUE(with_box({"-modes_st_type", "sinvert"}).modes.slepc);
  EXPECT_EQ(with_box({"-modes_st_type", "sinvert"}).solver, Solver::direct);
  EXPECT_FALSE(with_box({"-modes_tolerance", "1e-9"}).modes.slepc);
  EXPECT_NO_THROW(with_box({"-modes", "4", "-frames", "3", "-every", "2"})) << "these say nothing to ritz-reduce";
}

TEST(Config, KeepsWhatEachOptionCameTo) {
  const SharedFolder folder;
  const auto file = folder.file("a.opts", "-modes 5\n");
  const auto resolved =
      with_box({"-options_file", file, "-material_young", "1e6", "-quiet", "-material_lid_young", "2e6"}).resolved;
  for (const auto& [name, value] : std::vector<std::pair<std::string, std::string>>{{"mesh", "box:1,1,1/2,2,2/tet4"},
                                                                                    {"modes", "5"},
                                                                                    {"modes_block", "4"},
                                                                                    {"modes_tolerance", "1e-10"},
                                                                                    {"units", "m-kg-s"},
                                                                                    {"solver", "auto"},
                                                                                    {"quiet", "true"},
                                                                                    {"surface_only", "false"},
                                                                                    {"output", "model.h5"},
                                                                                    {"material_young", "1e6"},
                                                                                    {"material_lid_young", "2e6"},
                                                                                    {"partitioner", "metis"}})
    EXPECT_THAT(resolved, Contains(Pair(name, value)));
  for (const auto& one : resolved)
    EXPECT_EQ(std::count_if(resolved.begin(), resolved.end(), [&](const auto& o) { return o.first == one.first; }), 1)
        << one.first;
}

TEST(Config, KeepsSolverOptionsToo) {
  EXPECT_THAT(with_box({"-modes_eps_tol", "1e-9", "-solve_mat_mumps_icntl_14", "30"}).resolved,
              AllOf(Contains(Pair("modes_eps_tol", "1e-9")), Contains(Pair("solve_mat_mumps_icntl_14", "30"))));
}

/// A command line on a box is refused with these words.
void refuses(std::vector<std::string> words, const std::string& first, const std::string& second = "") {
  EXPECT_THAT([&] { with_box(words); }, ThrowsMessage<InputError>(AllOf(HasSubstr(first), HasSubstr(second))));
}

TEST(Config, RefusesOptionsThatNobodyReads) {
  refuses({"-modees", "5"}, "-modees", "-modes?");
  refuses({"-options_fiel", "a.opts"}, "-options_fiel", "-options_file?");
  refuses({"-modes=5"}, "-modes=5", "-modes 5");
  refuses({"-fix", "xmin", "ymin"}, "'ymin'", "-fix xmin,ymin");
  refuses({"-modes_st_type", "sinvert", "-solver", "iterative"}, "-solver iterative", "-modes_st_");
  refuses({"-modes_eps_tolx", "5"}, "-modes_eps_tolx", "-modes_eps_tol?");
  refuses({"-modes_st_pc_typ", "lu"}, "-modes_st_pc_typ", "-modes_st_pc_type?");
  refuses({"-solve_ksp_typo", "cg"}, "-solve_ksp_typo", "-solve_ksp_type?");
  refuses({"-solve_mat_mumps_incntl_14", "5"}, "-solve_mat_mumps_incntl_14", "-solve_mat_mumps_icntl_14?");
  refuses({"-multigrid_mg_levels_ksp_type", "richardson"}, "-multigrid_mg_levels_ksp_type");
  refuses({"-multigrid_pc_gamg_treshold", "5"}, "-multigrid_pc_gamg_treshold", "-multigrid_pc_gamg_threshold?");
  refuses({"-material__young", "5"}, "-material__young");
  refuses({"-material_lid_yuong", "5"}, "-material_lid_yuong");
}

TEST(Config, AcceptsOptionsThatAreReadLater) {
  EXPECT_NO_THROW(
      with_box({"-scene", "scene.toml", "-modes_eps_view", "-solve_ksp_view", "-modes_eps_converged_reason",
                "-modes_st_mat_mumps_icntl_14", "30", "-solve_mat_mumps_icntl_7", "2", "-modes_st_mg_levels_ksp_type",
                "chebyshev", "-modes_eps_monitor", "-multigrid_pc_gamg_threshold", ".02"}));
}

TEST(Config, RefusesWhatSolversRefuse) {
  refuses({"-modes_eps_type", "foo"}, "foo");
  refuses({"-modes_eps_max_it", "many"}, "many");
  refuses({"-solve_pc_factor_mat_solver_type", "foo"}, "foo");
  refuses({"-solve_pc_type", "jacobi"}, "-solve_");
}

TEST(Config, RefusesValuesOfTheWrongKind) {
  refuses({"-modes", "2.5"}, "-modes 2.5", "whole number");
  refuses({"-modes", "-1"}, "-modes -1", "at least 0");
  refuses({"-modes"}, "-modes", "whole number");
  refuses({"-modes_block", "65"}, "-modes_block 65", "at most 64");
  refuses({"-modes_tolerance", "0"}, "-modes_tolerance 0");
  refuses({"-material_density", "nan"}, "-material_density nan", "finite");
  refuses({"-solver", "fast"}, "-solver fast", "direct");
  refuses({"-quiet", "maybe"}, "-quiet maybe");
  refuses({"-material_law", "hooke"}, "hooke", "stvk");
  refuses({"-units", "SI"}, "-units SI", "m-kg-s");
}

TEST(Config, RefusesOptionFilesThatItCannotFollow) {
  const SharedFolder folder;
  const auto one = [&](const std::string& name, const std::string& text) {
    return std::vector<std::string>{"-options_file", folder.file(name, text)};
  };
  refuses({"-options_file", "none.opts"}, "none.opts", "no such file");
  refuses(one("a.opts", "-modes 5\nmodes 5\n"), "a.opts:2", "'modes'");
  refuses(one("b.opts", "-modes 5 6\n"), "b.opts:1", "'6'");
  refuses(one("c.opts", "-options_file c.opts\n"), "c.opts:1", "another");
  refuses(one("f.opts", "-fix left end\n"), "f.opts:1", "quotes");
  refuses(one("g.opts", "\n-fix \"left end\n"), "g.opts:2", "not closed");
  refuses(one("h.opts", "-quiet -plan\n"), "h.opts:1", "'-plan'");
  refuses(one("d.yaml", "modes: [5\n"), "d.yaml");
  refuses(one("e.yaml", "options_file: a.opts\n"), "e.yaml", "another");
  refuses({"-options_file_yaml", "a.yaml"}, "-options_file_yaml");
  refuses({"-options_file"}, "-options_file needs");
}

TEST(Config, RefusesWordsThatAreNoOptions) {
  EXPECT_THAT([] { configured({"beam.msh"}); }, ThrowsMessage<InputError>(HasSubstr("'beam.msh'")));
  EXPECT_THAT([] { configured({}); }, ThrowsMessage<InputError>(HasSubstr("-mesh is missing")));
}

}  // namespace
}  // namespace ritz::config
