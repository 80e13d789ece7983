// Ranks that write one file together write what one rank alone writes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mpi.h>

#include "format/expect_same.hpp"
#include "format/temporary.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/random.hpp"
#include "ritz/format/parts.hpp"
#include "ritz/format/reader.hpp"
#include "ritz/format/writer.hpp"
#include "support/sample_model.hpp"

namespace ritz::format {
namespace {

int rank() {
  int value = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &value);
  return value;
}

int ranks() {
  int value = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &value);
  return value;
}

/// A name that all ranks agree on.
std::filesystem::path shared_path(const char* name) {
  int id = static_cast<int>(::getpid());
  MPI_Bcast(&id, 1, MPI_INT, 0, MPI_COMM_WORLD);
  return std::filesystem::temp_directory_path() / ("ritz-parallel-" + std::to_string(id) + "-" + name);
}

class ParallelWrite : public testing::TestWithParam<H5FD_mpio_xfer_t> {
 protected:
  ParallelWrite() { H5Pset_dxpl_mpio(lists_.transfer.get(), GetParam()); }
  ~ParallelWrite() override {
    MPI_Barrier(MPI_COMM_WORLD);
    if (rank() != 0) return;
    for (auto path : {together_, alone_}) {
      std::filesystem::remove(path);
      for (const auto* view : {".hdf", ".body.hdf", ".arm.hdf"})
        std::filesystem::remove(path.replace_extension().concat(view));
    }
  }

  Access access() const {
    const auto sum = [](std::uint64_t value) {
      MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
      return value;
    };
    const auto vote = [](bool yes) {
      int all = yes ? 1 : 0;
      MPI_Allreduce(MPI_IN_PLACE, &all, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
      return all == 1 ? Vote::all_yes : Vote::some_no;
    };
    return {lists_.file.get(), lists_.transfer.get(), rank() == ranks() - 1, sum, vote};
  }

  ParallelLists lists_{MPI_COMM_WORLD};
  std::filesystem::path together_ = shared_path("together.h5");
  std::filesystem::path alone_ = shared_path("alone.h5");
};

/// Two bodies of 101 vertices, 37 mixed cells and 5 columns; the rest is the sample's.
model::Model larger_model() {
  auto model = test::sample_model();
  auto& body = model.bodies[0];
  body.geometry.full_vertices = 101;
  body.geometry.points = model::Points::NullaryExpr(101, 3, [](auto i, auto j) { return double(i) + 0.1 * double(j); });
  body.geometry.vertex_ids.resize(101);
  for (std::size_t i = 0; i < 101; ++i) body.geometry.vertex_ids[i] = static_cast<Index>(3 * i + 7);
  body.geometry.cells = {{}, {0}, {}};
  for (Index c = 0; c < 37; ++c) {
    const Index size = c % 3 == 0 ? 8 : 4;
    body.geometry.cells.vtk_types.push_back(c % 3 == 0 ? 12 : 10);
    for (Index v = 0; v < size; ++v) body.geometry.cells.vertices.push_back((5 * c + v) % 101);
    body.geometry.cells.offsets.push_back(static_cast<Index>(body.geometry.cells.vertices.size()));
  }
  body.basis.U = model::RowMatrix::NullaryExpr(
      303, 5, [](auto i, auto j) { return uniform(static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(j)); });
  body.inertia.reset();
  body.loads.clear();
  model.bodies.push_back(body);
  model.bodies[1].name = "arm";
  model.bodies[1].basis.U *= 2;
  model.bodies[1].checksums.mesh = "of the arm";
  model.bodies[1].report.notes = {"the arm's own"};
  return model;
}

/// Where the part of rank `part` of `total` rows starts: uneven, and rank 1's is empty.
Index start(int part, Index total) {
  if (part >= ranks()) return total;
  return part == 0 ? 0 : total * (part == 1 ? 2 : part) / (ranks() + 1);
}

struct Mine {
  model::Geometry geometry;
  model::Basis basis;
  GeometrySlices slices;
};

Mine my_part(const model::Body& body) {
  const auto& all = body.geometry;
  const auto cut = [](const auto& v, Index from, Index to) {
    return std::decay_t<decltype(v)>(v.begin() + from, v.begin() + to);
  };
  Mine mine{all, {}, whole(all)};
  const Index v0 = start(rank(), 101), v1 = start(rank() + 1, 101);
  const Index c0 = start(rank(), 37), c1 = start(rank() + 1, 37);
  const Index e0 = all.cells.offsets[std::size_t(c0)], e1 = all.cells.offsets[std::size_t(c1)];
  mine.slices.vertices.first = v0;
  mine.slices.cells.first = c0;
  mine.slices.cell_vertices.first = e0;
  mine.geometry.points = all.points.middleRows(v0, v1 - v0);
  mine.geometry.vertex_ids = cut(all.vertex_ids, v0, v1);
  mine.geometry.cells = {cut(all.cells.vtk_types, c0, c1), cut(all.cells.offsets, c0, c1 + 1),
                         cut(all.cells.vertices, e0, e1)};
  for (auto& offset : mine.geometry.cells.offsets) offset -= e0;
  if (c0 == c1) mine.geometry.cells.offsets.clear();
  mine.basis.U = body.basis.U.middleRows(3 * v0, 3 * (v1 - v0));
  return mine;
}

TEST_P(ParallelWrite, GivesTheDatasetsOfOneRank) {
  const auto model = larger_model();
  {
    ModelWriter out(together_, access());
    auto provenance = model.provenance;
    if (!access().writes_small) provenance.program = "another rank's words are not written";
    write_provenance(out, provenance);
    for (const auto& body : model.bodies) {
      const auto mine = my_part(body);
      write_checksums(out, body.checksums, body.name);
      write_geometry(out, mine.geometry, mine.slices, body.name);
      write_basis(out, mine.basis, shown_columns(body), mine.slices.vertices, body.name);
      write_modes(out, *body.modes, body.name);
      auto report = body.report;
      if (!access().writes_small) report.notes = {"nor its number of notes"};
      write_report(out, report, body.name);
    }
    out.commit();
  }
  if (rank() != 0) return;
  write(alone_, model);
  test::expect_same(read(together_), model);

  const ModelReader a(together_), b(alone_);
  const auto in_a = contents(a), in_b = contents(b);
  ASSERT_EQ(in_a.size(), in_b.size());
  for (std::size_t i = 0; i < in_a.size(); ++i) {
    EXPECT_EQ(in_a[i].path, in_b[i].path);
    EXPECT_EQ(in_a[i].shape, in_b[i].shape);
    EXPECT_NO_THROW(verify(a, in_a[i])) << in_a[i].path;
  }
  EXPECT_TRUE(test::load(together_) == test::load(alone_)) << "the same bytes";
}

TEST_P(ParallelWrite, FailsOnAllRanksTogether) {
  EXPECT_THROW(ModelWriter(together_ / "in a file", access()), InputError);
  {
    ModelWriter out(together_, access());
    const Slice beyond{rank() == 0 ? 5 : 0, 2};  // rank 0's rows do not fit
    model::Basis basis{model::RowMatrix::Zero(rank() == 0 ? 3 : 0, 1)};
    EXPECT_THROW(write_basis(out, basis, {{"column 1", 1}}, beyond), std::logic_error);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_FALSE(std::filesystem::exists(together_));
  for (const auto& entry : std::filesystem::directory_iterator(together_.parent_path()))
    EXPECT_FALSE(entry.path().filename().string().starts_with(together_.filename().string())) << entry.path();
}

INSTANTIATE_TEST_SUITE_P(Transfer, ParallelWrite, testing::Values(H5FD_MPIO_INDEPENDENT, H5FD_MPIO_COLLECTIVE));

}  // namespace
}  // namespace ritz::format
