#include <gtest/gtest.h>

#include "format/temporary.hpp"
#include "ritz/base/error.hpp"
#include "ritz/format/parts.hpp"
#include "support/sample_model.hpp"

namespace ritz::format {
namespace {

/// Ten vertices, twelve columns, U(row, column) = 100 row + column.
class Selection : public testing::Test {
 protected:
  Selection() {
    auto model = test::sample_model();
    auto& body = model.bodies[0];
    body.geometry.points = model::Points::Zero(10, 3);
    body.geometry.vertex_ids.assign(10, 0);
    body.basis.U = model::RowMatrix::NullaryExpr(30, 12, [](auto i, auto j) { return 100.0 * double(i) + double(j); });
    body.inertia.reset();
    body.loads.clear();
    U_ = body.basis.U;
    write(folder_ / "model.h5", model);
  }

  model::RowMatrix read(std::optional<std::vector<Index>> columns, std::optional<std::vector<Index>> vertices) const {
    return read_basis(ModelReader(folder_ / "model.h5"), {std::move(columns), std::move(vertices)}).U;
  }

  test::Folder folder_;
  model::RowMatrix U_;
};

TEST_F(Selection, DefaultsToEverything) {
  EXPECT_EQ(read({}, {}), U_);
  const auto size = basis_size(ModelReader(folder_ / "model.h5"));
  EXPECT_EQ(size.vertices, 10);
  EXPECT_EQ(size.columns, 12);
}

TEST_F(Selection, TakesColumnsInAnyOrder) {
  const auto U = read(std::vector<Index>{11, 0, 3}, {});
  ASSERT_EQ(U.rows(), 30);
  ASSERT_EQ(U.cols(), 3);
  EXPECT_EQ(U.col(0), U_.col(11));
  EXPECT_EQ(U.col(1), U_.col(0));
  EXPECT_EQ(U.col(2), U_.col(3));
}

TEST_F(Selection, TakesVerticesInAnyOrder) {
  const auto U = read({}, std::vector<Index>{7, 2, 2});
  ASSERT_EQ(U.rows(), 9);
  EXPECT_EQ(U.middleRows(0, 3), U_.middleRows(21, 3));
  EXPECT_EQ(U.middleRows(3, 3), U_.middleRows(6, 3));
  EXPECT_EQ(U.middleRows(6, 3), U_.middleRows(6, 3));
}

TEST_F(Selection, MayBeEmpty) {
  EXPECT_EQ(read(std::vector<Index>{}, {}).cols(), 0);
  EXPECT_EQ(read({}, std::vector<Index>{}).rows(), 0);
}

TEST_F(Selection, RefusesWhatIsNotThere) {
  EXPECT_THROW(read(std::vector<Index>{12}, {}), InputError);
  EXPECT_THROW(read({}, std::vector<Index>{-1}), InputError);
  EXPECT_THROW(read({}, std::vector<Index>{0, 10}), InputError);
}

}  // namespace
}  // namespace ritz::format
