#include "ritz/format/motion_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "read.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/format/checksum.hpp"
#include "ritz/format/names.hpp"

namespace ritz::format {
namespace {

namespace names = schema::motion;

/// The three vectors of a state.
constexpr auto state_vectors = std::span(names::vertex_arrays).subspan(1);

[[noreturn]] void refuse_motion(const StoredFile& in, const std::string& why) {
  throw InputError(in.name() + ": " + why);
}

}  // namespace

SnapshotReader::SnapshotReader(const std::filesystem::path& path, std::string name)
    : StoredFile(path, std::move(name), {.kind = "file of snapshots", .writer = "ritz-full"}) {
  const auto objects = survey(*this, std::array<std::string_view, 1>{names::snapshots}, Storage::foreign);
  if (objects.empty() || objects.front().kind != StoredObject::Kind::dataset)
    refuse_motion(*this, "the file has no dataset /snapshots; ritz-full writes one when it writes frames");
  shape_ = objects.front().shape;
  if (shape_.size() != 2) refuse_motion(*this, "/snapshots must have two dimensions");
  dataset_ = Dataset(H5Dopen2(file(), names::snapshots, H5P_DEFAULT));
  if (has_attribute(*this, names::snapshots, schema::checksum))
    checksum_ = read_bits(*this, names::snapshots, schema::checksum);
}

void SnapshotReader::read(std::int64_t row, std::span<double> into) {
  const std::array<hsize_t, 2> start{static_cast<hsize_t>(row), 0}, counts{1, static_cast<hsize_t>(length())};
  const Space memory(H5Screate_simple(1, &counts[1], nullptr)), stored(H5Dget_space(dataset_.get()));
  H5Sselect_hyperslab(stored.get(), H5S_SELECT_SET, start.data(), nullptr, counts.data(), nullptr);
  if (H5Dread(dataset_.get(), H5T_NATIVE_DOUBLE, memory.get(), stored.get(), H5P_DEFAULT, into.data()) < 0)
    refuse_motion(*this, "/snapshots cannot be read as numbers");
  if (length() % 3 == 0) sum_ += checksum(std::as_bytes(into), 3 * sizeof(double), row * length() / 3);
  if (row + 1 == count() && checksum_ && *checksum_ != sum_)
    refuse_motion(*this,
                  "/snapshots does not have the checksum it was written with: the file is damaged; write it again");
}

ReducedMotionReader::ReducedMotionReader(const std::filesystem::path& path, std::string name)
    : StoredFile(path, std::move(name), {.kind = "motion", .writer = "ritz-run"}) {
  const auto objects =
      survey(*this, std::array<std::string_view, 4>{names::times, names::z, names::zdot, names::state});
  const auto has = [&](const char* path) {
    return std::ranges::find(objects, path, &StoredObject::path) != objects.end();
  };
  if (!has(names::z) || !has(names::times))
    refuse_motion(*this, "it is not a motion of a reduced model, as ritz-run writes it");
  if (!has(names::zdot)) refuse_motion(*this, "it holds no velocities: write it again with ritz-run");
  times_ = read_vector<double>(*this, names::times);
  shape_ = stored_shape(*this, names::z);
  if (times_.empty() || shape_.size() != 2 || shape_[0] != std::ssize(times_) ||
      stored_shape(*this, names::zdot) != shape_)
    refuse_motion(*this, "its times, coordinates and velocities are not of as many states");
}

std::string ReducedMotionReader::model_checksum() const {
  if (!has_attribute(*this, "/", names::model_checksum))
    refuse_motion(*this, "it shows a mode, and is not the motion of a scene");
  return read_text(*this, "/", names::model_checksum);
}

std::size_t ReducedMotionReader::index_at(std::optional<double> time) const {
  if (!time) return times_.size() - 1;
  const auto nearest = std::ranges::min_element(times_, {}, [&](double t) { return std::abs(t - *time); });
  constexpr double rounding = 1e-9;
  if (std::abs(*nearest - *time) > rounding * times_.back())
    refuse_motion(*this, "it has no state at t = " + shown(*time, 12) + " s; the nearest is at " + shown(*nearest, 12) +
                             " s, and the last at " + shown(times_.back(), 12) + " s");
  return static_cast<std::size_t>(nearest - times_.begin());
}

Eigen::MatrixXd ReducedMotionReader::state(std::size_t index) const {
  Eigen::MatrixXd state(shape_[1], 2);
  Eigen::Index column = 0;
  for (const auto* name : {names::z, names::zdot}) {
    verify_rows(*this, name);
    Eigen::VectorXd row(shape_[1]);
    read_rows(*this, name, shape_, static_cast<std::int64_t>(index), 1, row.data());
    state.col(column++) = row;
  }
  return state;
}

ReducedState ReducedMotionReader::end() const {
  if (!exists(*this, names::history))
    refuse_motion(*this, "it holds no last state to go on from: it is of statics, or shows a mode");
  ReducedState state;
  state.integrator = read_text(*this, names::state, names::integrator);
  state.scene_checksum = read_text(*this, names::state, names::scene_checksum);
  state.steps = read_index(*this, names::state, names::steps);
  state.last_step = read_double(*this, names::state, names::last_step);
  for (const auto& group : {std::span<const char* const>(names::energies), {names::energy_gain}})
    if (has_attribute(*this, names::state, group.front()))
      for (const auto* number : group) state.numbers[number] = read_double(*this, names::state, number);
  state.history = read_matrix(*this, names::history, shape_[1], any);
  if (state.steps < 1 || state.last_step <= 0) refuse_motion(*this, "its last state is one that no motion has");
  return state;
}

LastStateReader::LastStateReader(const std::filesystem::path& path, std::string name)
    : StoredFile(path, std::move(name), {.kind = "motion", .writer = "ritz-full"}) {
  if (survey(*this, std::array<std::string_view, 1>{names::state}).empty())
    refuse_motion(*this, "it holds no last state; name a file that ritz-full wrote");
  if (exists(*this, names::z)) refuse_motion(*this, "it is the motion of a reduced model, not of the full one");
}

StateRecord LastStateReader::record() const {
  StateRecord state;
  state.problem_checksum = read_text(*this, names::state, schema::problem_checksum);
  const auto kind = read_text(*this, names::state, names::kind);
  if (!parse(kind, state.kind)) refuse_motion(*this, "its last state is of the unknown kind '" + kind + "'");
  state.integrator = read_text(*this, names::state, names::integrator);
  for (const auto* number : names::state_numbers) state.numbers[number] = read_double(*this, names::state, number);
  for (const auto* number : {"t", "kinetic", "elastic"})
    if (state.numbers[number] < 0) refuse_motion(*this, std::string("its last state has a negative ") + number);
  return state;
}

bool LastStateReader::verify() const {
  bool all = true;
  for (const auto* vector : state_vectors) {
    if (!exists(*this, vector)) refuse_motion(*this, std::string(vector) + " is missing");
    if (has_attribute(*this, vector, schema::checksum)) verify_rows(*this, vector);
    else all = false;
  }
  return all;
}

model::RowMatrix LastStateReader::rows(std::int64_t first, std::int64_t count, std::int64_t vertices) const {
  model::RowMatrix rows(count, 3 * std::ssize(state_vectors));
  model::Points vector(count, 3);
  Eigen::Index column = 0;
  for (const auto* name : state_vectors) {
    read_rows(*this, name, {vertices, 3}, first, count, vector.data());
    rows.middleCols<3>(column) = vector;
    column += 3;
  }
  return rows;
}

}  // namespace ritz::format
