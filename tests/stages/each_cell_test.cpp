#include "ritz/stages/each_cell.hpp"

#include <gtest/gtest.h>

#include "ritz/fem/response.hpp"
#include "ritz/parallel/comm.hpp"
#include "support/allocations.hpp"
#include "support/problem.hpp"

namespace ritz::stages {
namespace {

using test::allocations;

const fem::Materials materials = {test::soft};

/// A number of vertex, component and column that no other has.
double value(mesh::Index global, int number, Eigen::Index column) {
  return static_cast<double>(100 * global + 10 * number) + static_cast<double>(column);
}

algebra::Tall numbered(const mesh::Mesh& mesh, int numbers, Eigen::Index columns) {
  algebra::Tall u(static_cast<Eigen::Index>(numbers) * mesh.owned, columns);
  for (int v = 0; v < mesh.owned; ++v)
    for (int i = 0; i < numbers; ++i)
      for (Eigen::Index j = 0; j < columns; ++j)
        u(static_cast<Eigen::Index>(numbers) * v + i, j) = value(mesh.first + v, i, j);
  return u;
}

TEST(Halo, GhostsHaveTheNumbersOfTheirOwners) {
  const auto mesh = test::box("box:3,1,1/6,2,2/tet10");
  for (const int numbers : {1, 3, 6})
    for (const Eigen::Index columns : {1, 4}) {
      const auto local = mesh::with_ghosts(mesh, numbered(mesh, numbers, columns), numbers);
      ASSERT_EQ(local.rows(), static_cast<Eigen::Index>(numbers) * mesh.local_vertices());
      for (int v = 0; v < mesh.local_vertices(); ++v)
        for (int i = 0; i < numbers; ++i)
          for (Eigen::Index j = 0; j < columns; ++j)
            EXPECT_EQ(local(static_cast<Eigen::Index>(numbers) * v + i, j),
                      value(mesh.global[static_cast<std::size_t>(v)], i, j));
    }
}

TEST(Halo, AnExchangeAllocatesOnce) {
  if (!test::counts_allocations()) GTEST_SKIP() << "nothing is counted under this sanitizer";
  const auto mesh = test::box("box:3,1,1/6,2,2/hex8");
  auto local = mesh::with_ghosts(mesh, numbered(mesh, 3, 2), 3);
  // Open MPI itself allocates in its first exchanges
  for (int warm = 0; warm < 20; ++warm) mesh.halo.fill_ghosts(mesh.comm, local, 3);
  const auto before = allocations();
  mesh.halo.fill_ghosts(mesh.comm, local, 3);
  EXPECT_EQ(allocations(), before);
}

TEST(EachCell, ComesInTheFilesOrderAndOwnsEachCellOnce) {
  const auto mesh = test::box("box:3,1,1/6,2,2/tet4");
  mesh::Index last = -1;
  std::int64_t owned = 0;
  each_cell(mesh, materials, [&](const Cell& cell) {
    const auto position = mesh.cells.numbers[static_cast<std::size_t>(cell.number)];
    EXPECT_GT(position, last);
    last = position;
    owned += cell.owned;
    EXPECT_EQ(cell.x, fem::CellVectors(mesh.corners(cell.number)));
  });
  EXPECT_EQ(parallel::sum(mesh.comm, owned), mesh.cells_total);
  owned = 0;
  each_owned_cell(mesh, materials, [&](const auto& cell) { owned += cell.owned; });
  EXPECT_EQ(parallel::sum(mesh.comm, owned), mesh.cells_total);
}

TEST(EachCell, AllocatesNothing) {
  if (!test::counts_allocations()) GTEST_SKIP() << "nothing is counted under this sanitizer";
  for (const char* kind : {"tet4", "tet10", "hex8", "hex20", "wedge6", "wedge15"}) {
    const auto mesh = test::box(std::string("box:3,1,1/6,2,2/") + kind);
    const mesh::LocalRows local = algebra::Tall::Random(3 * mesh.local_vertices(), 1);
    double energy = 0;
    const auto before = allocations();
    each_cell(mesh, materials, [&](const Cell& cell) {
      const fem::IntegrationPoints points(cell.type, cell.x);
      energy += fem::energy_and_force(points, cell.gather(local, 0), cell.material).energy;
    });
    EXPECT_EQ(allocations(), before) << kind;
    EXPECT_TRUE(std::isfinite(energy));
  }
}

}  // namespace
}  // namespace ritz::stages
