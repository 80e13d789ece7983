// The files of motions: numbers that come in pieces stand where they belong, and another run reads them again.
#include "ritz/format/motion_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "format/temporary.hpp"
#include "ritz/base/error.hpp"
#include "ritz/format/xdmf.hpp"
#include "support/sample_model.hpp"

namespace ritz::format {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

std::vector<double> dataset_of(const std::filesystem::path& path, const char* name) {
  const File file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
  const Dataset dataset(H5Dopen2(file.get(), name, H5P_DEFAULT));
  const Space space(H5Dget_space(dataset.get()));
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get())));
  EXPECT_GE(H5Dread(dataset.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0) << name;
  return values;
}

std::vector<double> counted(std::size_t count) {
  std::vector<double> values(count);
  std::iota(values.begin(), values.end(), 1);
  return values;
}

TEST(Motion, OfAReducedBodyHoldsItsStatesAndFrames) {
  const test::Folder folder;
  const auto path = folder / "motion.h5";
  constexpr std::int64_t states = 9000;  // more than wait to be written
  ReducedMotion motion(
      path, test::sample_geometry(),
      {.states = states, .columns = 2, .frame_times = {0, 1}, .time_units = "s", .model_checksum = "ab"});
  for (std::int64_t i = 0; i < states; ++i)
    motion.state(double(i), Eigen::Vector2d(2 * double(i), 2 * double(i) + 1), Eigen::Vector2d(-double(i), 0));
  model::Points u = model::Points::Constant(4, 3, 1);
  motion.frame(u);
  motion.frame(2 * u);
  const ReducedState end{.integrator = "newmark",
                         .scene_checksum = "cd",
                         .steps = states - 1,
                         .last_step = .5,
                         .history = Eigen::MatrixXd::Random(2, 3),
                         .numbers = {}};
  motion.keep(end);
  motion.finish();
  EXPECT_FALSE(std::filesystem::exists(path));
  motion.publish();
  const ReducedMotionReader in(path, "the motion");
  EXPECT_EQ(in.model_checksum(), "ab");
  EXPECT_EQ(in.times().size(), std::size_t{states});
  EXPECT_EQ(in.state(in.index_at(8000)), (Eigen::Matrix2d() << 16000, -8000, 16001, 0).finished());
  EXPECT_EQ(in.index_at({}), std::size_t{states - 1});
  EXPECT_THAT([&] { in.index_at(7.5); },
              ThrowsMessage<InputError>(HasSubstr("the motion: it has no state at t = 7.5")));
  const auto read = in.end();
  EXPECT_EQ(read.history, end.history);
  EXPECT_EQ(read.steps, states - 1);
  EXPECT_EQ(read.scene_checksum, "cd");
  EXPECT_THAT([&] { LastStateReader(path, "restart"); }, ThrowsMessage<InputError>(HasSubstr("of a reduced model")));

  const auto z = dataset_of(path, "z"), times = dataset_of(path, "times");
  ASSERT_EQ(z.size(), 2U * states);
  for (std::size_t i = 0; i < z.size(); ++i) ASSERT_EQ(z[i], double(i));
  EXPECT_EQ(times.back(), double(states - 1));
  EXPECT_EQ(dataset_of(path, "displacement").back(), 2);
  EXPECT_EQ(dataset_of(path, "frames/0"), std::vector<double>(12, 1));
  EXPECT_EQ(dataset_of(path, "frames/1"), std::vector<double>(12, 2));
  EXPECT_TRUE(std::filesystem::exists(folder / "motion.xdmf"));
}

/// full.h5 of two frames and a last state, of as many vertices, whose vectors come in pieces of uneven length.
void write_full(const std::filesystem::path& path, std::int64_t vertices) {
  const FullPlan plan{{0, 1}, {0, 1}, "s"};
  FullMotion motion(path, vertices, plan);
  const auto append = [](NumberStream& stream, std::span<const double> values) {
    for (std::size_t size = 3; !values.empty(); size = 5 * size % 8193) {
      const auto piece = values.first(std::min(size - size % 3, values.size()));
      stream.append(piece);
      values = values.subspan(piece.size());
    }
  };
  const auto values = counted(static_cast<std::size_t>(6 * vertices));
  const auto vector = std::span(values).first(values.size() / 2);
  auto points = motion.array(VertexArray::points);
  append(points, vector);
  points.close();
  const std::vector<std::int64_t> topology = {6, 0, 1, 2, 3};
  const std::vector<std::int64_t> ids(static_cast<std::size_t>(vertices), 7);
  motion.begin_frames({vertices, 1, topology, ids}, plan);
  append(motion.frames(), values);
  motion.keep({StateKind::moving,
               "avf",
               "0123456789abcdef",
               {{"t", 1}, {"kinetic", 2}, {"elastic", 3}, {"work", 4}, {"dissipated", 5}, {"start", 6}}});
  for (const auto which : {VertexArray::displacement, VertexArray::velocity, VertexArray::acceleration}) {
    auto stream = motion.array(which);
    append(stream, vector);
    stream.close();
  }
  motion.finish();
  motion.publish();
}

TEST(Motion, OfAnUnreducedBodyIsReadAsSnapshots) {
  const test::Folder folder;
  const auto path = folder / "full.h5";
  for (const std::int64_t n : {4, 2500}) {
    write_full(path, n);
    SnapshotReader in(path, "snapshots");
    ASSERT_EQ(in.count(), 2);
    ASSERT_EQ(in.length(), 3 * n);
    const auto all = counted(static_cast<std::size_t>(6 * n));
    std::vector<double> row(static_cast<std::size_t>(3 * n));
    for (std::int64_t i = 0; i < 2; ++i) {
      in.read(i, row);
      EXPECT_TRUE(std::equal(row.begin(), row.end(), all.begin() + 3 * n * i)) << i;
    }
    EXPECT_EQ(dataset_of(path, "displacement"), all);
    EXPECT_EQ(dataset_of(path, "frames/1"), row);
    EXPECT_EQ(dataset_of(path, "points"), std::vector<double>(all.begin(), all.begin() + 3 * n));
  }
}

TEST(Motion, OfAnUnreducedBodyEndsInAStateThatIsReadAgain) {
  const test::Folder folder;
  write_full(folder / "full.h5", 4);
  const LastStateReader in(folder / "full.h5", "restart");
  const auto state = in.record();
  EXPECT_EQ(state.kind, StateKind::moving);
  EXPECT_EQ(state.integrator, "avf");
  EXPECT_EQ(state.problem_checksum, "0123456789abcdef");
  EXPECT_EQ(state.numbers.at("start"), 6);
  EXPECT_TRUE(in.verify());
  const auto rows = in.rows(1, 2, 4);
  const Eigen::RowVector3d second(4, 5, 6), third(7, 8, 9);
  for (Eigen::Index vector = 0; vector < 3; ++vector) {
    EXPECT_EQ(rows.block(0, 3 * vector, 1, 3), second);
    EXPECT_EQ(rows.block(1, 3 * vector, 1, 3), third);
  }
}

TEST(Motion, ThatIsDamagedOrOfAnotherKindIsRefused) {
  const test::Folder folder;
  const auto path = folder / "full.h5";
  write_full(path, 4);
  auto bytes = test::load(path);
  for (const char* name : {"/snapshots", "/state/velocity"}) {
    const File file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
    const Dataset dataset(H5Dopen2(file.get(), name, H5P_DEFAULT));
    bytes[H5Dget_offset(dataset.get()) + 4] ^= std::byte{0x10};
  }
  test::save(folder / "damaged.h5", bytes);
  EXPECT_THAT([&] { LastStateReader(folder / "damaged.h5", "restart").verify(); },
              ThrowsMessage<InputError>(HasSubstr("restart: /state/velocity does not have the checksum")));
  const auto read_all = [&] {
    SnapshotReader in(folder / "damaged.h5", "snapshots");
    std::vector<double> row(12);
    for (std::int64_t i = 0; i < 2; ++i) in.read(i, row);
  };
  EXPECT_THAT(read_all, ThrowsMessage<InputError>(HasSubstr("/snapshots does not have the checksum")));

  EXPECT_THAT([&] { ReducedMotionReader(path, "start"); },
              ThrowsMessage<InputError>(HasSubstr("start: it is not a motion of a reduced model")));
  ReducedMotion(folder / "motion.h5", {}, {.states = 0, .columns = 1, .frame_times = {}, .time_units = "s"});
  EXPECT_FALSE(std::filesystem::exists(folder / "motion.h5")) << "what is not published is removed";
  EXPECT_THAT([&] { xdmf_path("a.xdmf", "--output a.xdmf"); },
              ThrowsMessage<InputError>(HasSubstr("--output a.xdmf names the HDF5 file")));
}

}  // namespace
}  // namespace ritz::format
