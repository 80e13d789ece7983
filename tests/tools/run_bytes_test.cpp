// What a run does not use is not read: counted in the bytes that the kernel handed over.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "format/temporary.hpp"
#include "ritz/format/writer.hpp"
#include "ritz/tools/run_body.hpp"
#include "support/sample_model.hpp"

namespace ritz::tools {
namespace {

constexpr Eigen::Index r = 40, coefficients = r * (r + 1) / 2 * (r + 2) / 3 * (r + 3) / 4;

/// Bytes that this process has read so far, from files or from what the system keeps of them.
std::int64_t bytes_read() {
  std::ifstream io("/proc/self/io");
  std::string word;
  std::int64_t count = 0;
  while (io >> word)
    if (word == "rchar:") io >> count;
  return count;
}

class BytesRead : public testing::Test {
 protected:
  BytesRead() {
    auto model = test::sample_model();
    auto& body = model.bodies[0];
    body.basis.U = model::RowMatrix::Identity(12, r);
    body.modes.reset();
    body.inertia->gram = Eigen::MatrixXd::Identity(4 + 3 * r, 4 + 3 * r);
    body.loads.clear();
    body.geometry.sets.clear();
    body.reduction = model::Reduction{
        .stiffness = Eigen::VectorXd::LinSpaced(r, 1, 2), .singular_values = Eigen::VectorXd::Ones(r), .discarded = 0};
    body.polynomial =
        model::Polynomial{r, Eigen::VectorXd::Ones(r * (r + 1) / 2),
                          Eigen::VectorXd::Ones(r * (r + 1) / 2 * (r + 2) / 3), Eigen::VectorXd::Random(coefficients)};
    for (Eigen::Index i = 0, at = 0; i < r; ++i)  // K̃(0) = UᵀKU
      for (Eigen::Index j = i; j < r; ++j) body.polynomial->quadratic[at++] = i == j ? body.reduction->stiffness[i] : 0;
    format::write(path_, model);
  }

  /// Opening the model counts too.
  std::int64_t cost_of(Forces forces) const {
    const auto before = bytes_read();
    scene::Scene scene;
    scene.analysis = scene::Static{1};
    const format::ModelReader in(path_);
    const auto body = read_body(in, in.first_body(), scene, Frames::none, forces);
    EXPECT_EQ(body.polynomial.has_value(), forces == Forces::stored);
    return bytes_read() - before;
  }

  test::Folder folder_;
  std::filesystem::path path_ = folder_ / "model.h5";
};

TEST_F(BytesRead, ALinearRunLeavesThePolynomialWhereItIs) {
  if (bytes_read() == 0) GTEST_SKIP() << "this system does not count what is read";
  const std::int64_t polynomial = 8 * coefficients;
  const auto linear = cost_of(Forces::linear), all = cost_of(Forces::stored);
  EXPECT_LT(linear, polynomial / 4);
  EXPECT_GE(all, polynomial);
}

}  // namespace
}  // namespace ritz::tools
