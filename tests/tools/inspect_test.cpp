#include "ritz/tools/inspect.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <functional>
#include <limits>
#include <sstream>

#include "format/temporary.hpp"
#include "ritz/base/error.hpp"
#include "ritz/format/parts.hpp"
#include "ritz/tools/inspect_text.hpp"
#include "support/nonlinear_sample_model.hpp"

namespace ritz::tools {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

class Inspect : public testing::Test {
 protected:
  std::string described(const model::Model& model, Voice voice = Voice::verbose) const {
    return printed(model, [voice](const auto& in, std::ostream& out) { describe(in, voice, out); });
  }
  std::string checked(const model::Model& model) const { return printed(model, check); }

  template <class Print>
  std::string printed(const model::Model& model, Print print) const {
    format::write(folder_ / "model.h5", model);
    std::ostringstream out;
    print(format::ModelReader(folder_ / "model.h5"), out);
    return out.str();
  }

  test::Folder folder_;
};

TEST_F(Inspect, TellsEveryPart) {
  const auto told = described(test::sample_model());
  for (const auto* figure : {"4 vertices",
                             "1 tet4 cells",
                             "rubber",
                             "ν 0.49",
                             "end/of 50% cells",
                             "0 rigid, 2 flexible",
                             "certified: no mode is missing; an independent count (inertia of K − σM, σ = 10",
                             "0.3183099",
                             "0.4774648",
                             "2.0e-12 *",
                             "mass    4 kg",
                             "0.5  0  0 m",
                             "50.0000",
                             "100.0000",
                             "participation factors",
                             "1.414",
                             "surface of 0.25 m²",
                             "sample 1.0 on 1 rank",
                             "OpenBLAS 0.3.21",
                             "two masses",
                             "0.25 s",
                             "größer als nötig",
                             "/bodies/body/geometry/points",
                             "kg^-1/2",
                             "columns/0001 … 0002"})
    EXPECT_THAT(told, HasSubstr(figure));
}

TEST_F(Inspect, KeepsDetailsForThoseWhoAsk) {
  auto model = test::nonlinear_sample_model();
  model.bodies[0].report.figures = {{"static_error_z end/of 50%", .25}, {"witness_force", 1e-15}, {"vertices", 4}};
  const auto told = described(model, Voice::normal);
  EXPECT_THAT(told, AllOf(HasSubstr("static answer along z on 'end/of 50%': missing 25 %"),
                          HasSubstr("forces off from the full model's by")));
  for (const auto* detail :
       {"static_error", "witness", "vertices  ", "residual", "participation", "datasets\n", "singular"})
    EXPECT_THAT(told, Not(HasSubstr(detail)));
}

TEST_F(Inspect, LeavesAbsentPartsOut) {
  auto model = test::sample_model();
  model.bodies[0].modes.reset();
  model.bodies[0].inertia.reset();
  model.bodies[0].loads.clear();
  model.bodies[0].report = {};
  const auto told = described(model);
  for (const auto* part : {"\n  modes", "inertia", "loads", "report"}) EXPECT_THAT(told, Not(HasSubstr(part)));
}

TEST_F(Inspect, ChecksASoundModel) {
  const auto lines = checked(test::sample_model());
  EXPECT_THAT(lines, AllOf(HasSubstr("ok  39 datasets"), HasSubstr("fit together"), HasSubstr("ok  UᵀMU = I")));
  EXPECT_EQ(std::ranges::count(lines, '\n'), 7);
}

TEST_F(Inspect, TellsAndChecksAReductionAndItsPolynomial) {
  EXPECT_THAT(
      described(test::nonlinear_sample_model()),
      AllOf(HasSubstr("2 columns of 3 that were found"), HasSubstr("singular values 2 … 1, of what is left out 0.25"),
            HasSubstr("3 quadratic, 4 cubic, 5 quartic coefficients, 96 B")));
  auto residual = test::nonlinear_sample_model();
  residual.bodies[0].reduction->residual_vectors = 1;
  EXPECT_THAT(described(residual), AllOf(HasSubstr("1 of them residual vectors"), HasSubstr("singular values 2 … 2")));
  EXPECT_THAT(checked(test::nonlinear_sample_model()), HasSubstr("ok  the polynomial's K̃(0) = UᵀKU to 0.0e+00"));
  const auto wrong = [&](const char* sentence, const std::function<void(model::Body&)>& change) {
    auto model = test::nonlinear_sample_model();
    change(model.bodies[0]);
    EXPECT_THAT([&] { checked(model); }, ThrowsMessage<InputError>(HasSubstr(sentence)));
  };
  wrong("K̃(0) differs from UᵀKU", [](auto& b) { b.polynomial->quadratic[1] = 1e-7; });
  wrong("K̃(0) differs from UᵀKU", [](auto& b) { b.reduction->stiffness[1] = 9.1; });
  wrong("not a finite", [](auto& b) { b.polynomial->quartic[3] = std::numeric_limits<double>::infinity(); });
  wrong("singular values do not descend", [](auto& b) { b.reduction->singular_values[2] = 1.5; });
  wrong("does not ascend", [](auto& b) { b.reduction->stiffness << 9, 4; });
}

TEST_F(Inspect, TellsTheErrorsOfACubature) {
  EXPECT_THAT(described(test::cubature_sample_model()),
              AllOf(HasSubstr("format 2.0"), HasSubstr("2 cells with 3 points, of what the polynomial lacks"),
                    HasSubstr("elastic energy of 40 J; weights 1.5 to 20"),
                    HasSubstr("      2         1         2         3         4         5         6\n")));
  EXPECT_THAT(checked(test::cubature_sample_model()), HasSubstr("ok  the polynomial's K̃(0) = UᵀKU"));
}

TEST_F(Inspect, TellsAndChecksEachOfTwoBodies) {
  const auto told = described(test::two_body_model());
  for (const auto* line :
       {"\nbody 'body'\n", "\nbody 'arm/upper'\n", "box  x 0 … 1", "box  x 5 … 6", "0123456789abcdef of 'body'\n",
        "00000000000000bb of 'arm/upper'\n", "\nreport of 'body'\n", "\nreport of 'arm/upper'\n",
        "note: the arm's springs harden", "/bodies/arm%2Fupper/geometry/points", "/bodies/arm%2Fupper/report/notes"})
    EXPECT_THAT(told, HasSubstr(line));
  const auto lines = checked(test::two_body_model());
  EXPECT_THAT(lines, AllOf(HasSubstr("ok  body 'body': UᵀMU = I"), HasSubstr("ok  body 'arm/upper': UᵀMU = I"),
                           HasSubstr("ok  body 'arm/upper': the polynomial's K̃(0) = UᵀKU")));
  auto model = test::two_body_model();
  model.bodies[1].modes->eigenvalues << 9, 4;
  EXPECT_THAT([&] { checked(model); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("/bodies/arm%2Fupper/modes"), HasSubstr("do not ascend"))));
}

TEST_F(Inspect, FindsWhatIsWrong) {
  const auto wrong = [&](const char* sentence, const std::function<void(model::Body&)>& change) {
    auto model = test::sample_model();
    change(model.bodies[0]);
    EXPECT_THAT([&] { checked(model); }, ThrowsMessage<InputError>(HasSubstr(sentence)));
  };
  wrong("do not ascend", [](auto& b) { b.modes->eigenvalues << 9, 4; });
  wrong("rigid mode stands after", [](auto& b) { b.modes->kinds[1] = model::ModeKind::rigid; });
  wrong("mode 1 is flexible with the eigenvalue 0", [](auto& b) { b.modes->eigenvalues[0] = 0; });
  wrong("not a finite", [](auto& b) { b.geometry.points(1, 1) = std::numeric_limits<double>::quiet_NaN(); });
  wrong("not a finite", [](auto& b) { b.basis.U(0, 0) = std::numeric_limits<double>::infinity(); });
  wrong("not a finite", [](auto& b) { b.modes->residuals[0] = std::numeric_limits<double>::quiet_NaN(); });
  wrong("3 eigenvalues lie below the shift, but 2", [](auto& b) { b.modes->certificate.counted = 3; });
  wrong("UᵀMU differs from I by 2e-12", [](auto& b) { b.inertia->gram(8, 8) += 2e-12; });
  wrong("not symmetric", [](auto& b) { b.inertia->gram(0, 8) += 1; });
  wrong("mass is not", [](auto& b) { b.inertia->gram(0, 0) = -1; });
  wrong("the materials are missing", [](auto& b) { b.geometry.materials.clear(); });
  wrong("the inertia is missing", [](auto& b) { b.inertia.reset(); });
  wrong("the modes are missing", [](auto& b) { b.modes.reset(); });
  wrong("2 modes for 1 columns of U", [](auto& b) {
    b.basis.U = model::RowMatrix(b.basis.U.leftCols(1));
    b.inertia->gram = Eigen::MatrixXd(b.inertia->gram.topLeftCorner(7, 7));
    b.loads.clear();
  });
  wrong("the load on the set 'tip' is missing", [](auto& b) { b.loads.erase(b.loads.begin()); });
  wrong("the set 'tip' is missing", [](auto& b) { b.geometry.sets.erase(b.geometry.sets.begin()); });
  wrong("columns of the basis", [](auto& b) { b.basis.U = model::RowMatrix::Zero(12, 3); });
}

TEST_F(Inspect, ShowsNamesWithoutEffectOnATerminal) {
  auto model = test::sample_model();
  model.bodies[0].name = "a\x1b[2Jbody";
  model.bodies[0].geometry.sets[0].name = model.bodies[0].loads[0].set = "\x1b]0;title\x07";
  model.bodies[0].geometry.materials[0].region = "red\x1b[31m";
  model.provenance.program =
      "\xc2\x9b"
      "31m";
  model.provenance.options[0] = {"-mesh\x1b", "two\rmasses"};
  model.bodies[0].report.notes[0] = "a\nline";
  const auto told = described(model);
  for (const auto* shown : {"a\\x1b[2Jbody", "\\x1b]0;title\\x07", "red\\x1b[31m", "\\xc2\\x9b31m", "two\\x0dmasses",
                            "-mesh\\x1b", "a\\x0aline", "größer als nötig"})
    EXPECT_THAT(told, HasSubstr(shown));
  for (const auto* never : {"\x1b", "\x07", "\r", "\xc2\x9b"}) EXPECT_THAT(told, Not(HasSubstr(never)));
}

TEST_F(Inspect, SaysThatItsOutputWasNotWritten) {
  const auto model = folder_ / "model.h5", log = folder_ / "log";
  format::write(model, test::sample_model());
  const auto name = model.string();
  for (const auto& arguments :
       {name + " >/dev/full", name + " --check >/dev/full", name + " >&-", std::string("--help >/dev/full")}) {
    const auto command = std::string(RITZ_BIN) + "/ritz-inspect " + arguments + " 2>" + log.string();
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), exit_numerical) << arguments;
    const auto bytes = test::load(log);
    const std::string said(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    EXPECT_THAT(said, HasSubstr("standard output could not be written"));
    EXPECT_EQ(std::ranges::count(said, '\n'), 1);
  }
}

TEST_F(Inspect, IsAProgramWithExitCodes) {
  const auto model = folder_ / "model.h5", log = folder_ / "log";
  const auto run = [&](const std::string& arguments) {
    const auto command = std::string(RITZ_BIN) + "/ritz-inspect " + arguments + " > /dev/null 2> " + log.string();
    return WEXITSTATUS(std::system(command.c_str()));
  };
  const auto complaint = [&] {
    const auto bytes = test::load(log);
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  };
  format::write(model, test::sample_model());
  EXPECT_EQ(run(model.string()), exit_done);
  EXPECT_EQ(run("--check " + model.string()), exit_done);
  EXPECT_EQ(run("--help"), exit_done);
  EXPECT_EQ(complaint(), "");
  for (const auto& bad : {std::string(), model.string() + " --chekc", std::string("/no/such/model.h5")}) {
    EXPECT_EQ(run(bad), exit_input) << bad;
    EXPECT_EQ(std::ranges::count(complaint(), '\n'), 1) << complaint();
  }
  auto bytes = test::load(model);
  bytes.resize(bytes.size() / 2);
  test::save(model, bytes);
  EXPECT_EQ(run("--check " + model.string()), exit_input);
  EXPECT_THAT(complaint(), HasSubstr("truncated"));
}

TEST_F(Inspect, IsSerial) {
  const auto list = folder_ / "libraries";
  const auto command = std::string("ldd ") + RITZ_BIN + "/ritz-inspect > " + list.string();
  if (std::system(command.c_str()) != 0) GTEST_SKIP() << "there is no ldd";
  std::ifstream file(list);
  const std::string libraries{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(libraries, HasSubstr("hdf5"));
  for (const auto* never : {"libmpi", "petsc", "slepc", "openmpi"}) EXPECT_THAT(libraries, Not(HasSubstr(never)));
}

TEST(InspectText, ReadsLikePeopleWrite) {
  EXPECT_EQ(grouped(1), "1");
  EXPECT_EQ(grouped(-1234567), "-1 234 567");
  EXPECT_EQ(grouped(276480), "276 480");
  EXPECT_EQ(byte_size(999), "999 B");
  EXPECT_EQ(byte_size(21618), "21.6 kB");
  EXPECT_EQ(byte_size(999'960), "1.0 MB");
  EXPECT_EQ(duration(0.25), "0.25 s");
  EXPECT_EQ(duration(250), "4 min 10 s");
  EXPECT_EQ(duration(7260), "2 h 1 min");
  EXPECT_EQ(shape_text({12, 2}), "12 x 2");
  EXPECT_EQ(padded("größe", 7), "größe  ");
}

}  // namespace
}  // namespace ritz::tools
