// What of PETSc's options is let through, and that nothing of it can name a command, a library or a place of its own.
#include "ritz/config/solver_options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "config/configured.hpp"
#include "ritz/algebra/options.hpp"
#include "ritz/base/error.hpp"

namespace ritz::config {
namespace {

using config::testing::with_box;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const std::vector<std::string> formats = {"default", "ascii_info"};

/// Reading a command line must say no, before PETSc has met the option.
void refuses(const std::string& name, const std::string& value) {
  EXPECT_THROW(with_box({"-" + name, value}), InputError) << name << " " << value;
  EXPECT_TRUE(algebra::unread_options().empty()) << name << " " << value;
}

TEST(SolverOptions, LetNoOtherOptionThrough) {
  for (const char* name : {"dll_append",
                           "dll_prepend",
                           "on_error_attach_debugger",
                           "on_error_emacs",
                           "start_in_debugger",
                           "debugger_ranks",
                           "malloc_dump",
                           "malloc_view",
                           "info",
                           "log_trace",
                           "log",
                           "log_all",
                           "mat_view",
                           "vec_view",
                           "python",
                           "options_monitor",
                           "options_left",
                           "saws_port_auto_select",
                           "history",
                           "objects_dump",
                           "get_total_flops",
                           "display",
                           "viewer_binary_filename",
                           "shared_tmp",
                           "tmp",
                           "prefix_push",
                           "prefix_pop",
                           "options_file_yaml",
                           "options_string_yaml",
                           "mpidump",
                           "petsc_ci",
                           "use_gpu_aware_mpi",
                           "modes_eps_monitor_python",
                           "solve_mat_mumps_ooc_tmpdir",
                           "modes_st_pc_python_type",
                           "modes_eps_ciss_ksp_view",
                           "solve_mat_view",
                           "modes_st_ksp_monitor_python",
                           "solve_ksp_plot_eigenvalues",
                           "multigrid_pc_gamg_view",
                           "eps_type",
                           "ksp_view"})
    for (const std::string value : {"", "x", ":x;touch marker;.gz"}) {
      if (!value.empty()) refuses(name, value);
      EXPECT_THAT([&] { with_box({std::string("-") + name}); },
                  ThrowsMessage<InputError>(HasSubstr(std::string("no option -") + name)));
    }
}

TEST(SolverOptions, OfEveryNameTakeNoShell) {
  ASSERT_GT(solver_option_names().size(), 500);
  for (const auto& name : solver_option_names())
    for (const std::string value : {":x;touch marker;.gz", "x|y", "`touch marker`", "$(touch marker)", ":a.gz",
                                    "/etc/passwd", "socket:1", "binary:x", "http://x"}) {
      if (solver_option(name) == SolverOption::setting)
        EXPECT_THROW(check_setting({name, value}), InputError) << name << " " << value;
      else EXPECT_THROW(parse_report({name, value}, formats), InputError) << name << " " << value;
    }
}

TEST(SolverOptions, NameTheTypesThatThereAre) {
  for (const char* name : {"modes_eps_type", "modes_st_type", "modes_st_pc_type", "modes_st_ksp_type", "solve_pc_type",
                           "solve_pc_hypre_type", "solve_pc_factor_mat_solver_type", "newton_snes_type",
                           "newton_snes_linesearch_type", "multigrid_pc_type"})
    for (const char* value : {"python", "shell", "nonsense", "", "euclid"})
      EXPECT_THAT(
          [&] {
            check_setting({name, value});
          },
          ThrowsMessage<InputError>(AllOf(HasSubstr(name), HasSubstr("one of"))));
  EXPECT_NO_THROW(check_setting({"MODES_EPS_TYPE", "krylovschur"}));
  EXPECT_NO_THROW(check_setting({"solve_mat_mumps_icntl_2", "6"}));
  EXPECT_THROW(check_setting({"solve_mat_mumps_icntl_2", "7"}), InputError) << "that makes Fortran write to fort.7";
  EXPECT_THROW(check_setting({"modes_eps_tol", std::string(5000, '1')}), InputError) << "PETSc would cut it";
}

TEST(Reports, GoToStdoutOrAPlainFile) {
  for (const char* value : {"", "stdout", "ascii", ":stdout", "ascii:stdout"}) {
    const auto report = parse_report({"modes_eps_view", value}, formats);
    EXPECT_TRUE(report.file.empty() && report.viewer.empty()) << value;
  }
  EXPECT_EQ(parse_report({"modes_eps_view", ":a b/c-1.txt"}, formats).viewer, "ascii:a b/c-1.txt:");
  EXPECT_EQ(parse_report({"modes_eps_view", "::ascii_info"}, formats).viewer, "ascii::ascii_info");
  EXPECT_EQ(parse_report({"modes_eps_view", "ascii:x:ascii_info:append"}, formats).viewer, "ascii:x:ascii_info:append");
}

TEST(Reports, GoNowhereElse) {
  for (const char* value : {":a.gz",
                            ":a.GZ",
                            ":a.Z",
                            ":a.bz2",
                            ":a;b",
                            ":a|b",
                            ":|b",
                            ":a$b",
                            ":~/a",
                            ":a\nb",
                            ":a\\b",
                            ":'a'",
                            ":-a",
                            ":stderr",
                            "binary",
                            "binary:a",
                            "draw",
                            "socket:5005",
                            "hdf5:a.h5",
                            "vtk:a.vts",
                            "saws",
                            "http",
                            "a.txt",
                            ":a:ascii_xml",
                            ":a:ascii_matlab",
                            ":a:ascii_info:update",
                            ":a:ascii_info:append:b"})
    EXPECT_THROW(parse_report({"log_view", value}, formats), InputError) << value;
}

TEST(Reports, OfMonitorsHaveOneFormat) {
  EXPECT_NO_THROW(with_box({"-modes_eps_monitor"}));
  EXPECT_THROW(with_box({"-modes_st_ksp_monitor", "::ascii_info_detail"}), InputError);
  EXPECT_THROW(with_box({"-newton_snes_monitor", "::ascii_info"}), InputError);
}

TEST(Reports, AreKnownWithTheirFiles) {
  const auto reports =
      with_box({"-log_view", ":a.xml:ascii_xml", "-modes_eps_view", ":b.txt", "-solve_ksp_view"}).reports;
  ASSERT_EQ(reports.size(), 2);
  EXPECT_EQ(reports[0].value, "b.txt");
  EXPECT_EQ(reports[1].value, "a.xml");
}

}  // namespace
}  // namespace ritz::config
