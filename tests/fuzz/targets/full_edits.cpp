// The motion of a cube as ritz-full writes it, changed in as many ways as the input has bytes for, and read as
// snapshots and as a restart; or a reduced motion as ritz-run writes it, read as a start and as a restart. Its HDF5 is
// of the old layout, without checksums: what bytes are damaged in it comes far.
#include <fstream>
#include <iterator>

#include "fuzz/edits.hpp"
#include "fuzz/parallel_setting.hpp"
#include "fuzz/target.hpp"
#include "ritz/app/full_file.hpp"
#include "ritz/app/snapshots.hpp"
#include "ritz/base/error.hpp"
#include "ritz/format/motion_reader.hpp"
#include "ritz/format/schema.hpp"

namespace ritz::fuzz {
namespace {

constexpr const char* problem = "0123456789abcdef";

/// A whole file, and the paths in it.
struct Whole {
  std::vector<std::byte> image;
  std::vector<std::string> paths;

  void load(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    const auto all = std::as_bytes(std::span(bytes));
    image.assign(all.begin(), all.end());
    paths = paths_in(path);
  }
};

struct Sample : Cube {
  Whole full, reduced;
  Sample() {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    const auto path = as_file({}, "full.h5");
    app::FullFile file(path, mesh, {{fem::StVK{1e6, 0.3}, 1000}}, {{0, 1}, {0, 1}, "s"});
    const algebra::Tall u = Eigen::VectorXd::LinSpaced(mesh::components * mesh.owned, 0, 1);
    file.frame(u);
    file.frame(2 * u);
    app::LastState last{app::StateKind::moving, "avf", {}, u, u, u};
    for (const auto* name : {"t", "kinetic", "elastic", "work", "dissipated", "start"}) last.numbers[name] = 1;
    file.keep(last, problem);
    file.finish();
    file.publish();
    full.load(path);
    write_reduced(as_file({}, "motion.h5"));
  }

 private:
  void write_reduced(const std::filesystem::path& path) {
    format::ReducedMotion file(
        path, {}, {.states = 3, .columns = 2, .frame_times = {}, .time_units = "s", .model_checksum = problem});
    for (const double t : {0., 1., 2.}) file.state(t, Eigen::Vector2d(t, 1), Eigen::Vector2d(1, t));
    format::ReducedState end{.integrator = "newmark",
                             .scene_checksum = problem,
                             .steps = 2,
                             .last_step = 1,
                             .history = Eigen::MatrixXd::Ones(2, 3),
                             .numbers = {}};
    for (const auto* name : format::schema::motion::energies) end.numbers[name] = 1;
    file.keep(end);
    file.finish();
    file.publish();
    reduced.load(path);
  }
};

void read_as_restart(const std::filesystem::path& path, const mesh::Mesh& mesh) {
  app::verify_last_state(mesh.comm, path, "-restart");
  const auto state = app::read_last_state(path, "-restart", mesh, problem);
  if (!state.u.allFinite() || !state.v.allFinite() || !state.a.allFinite()) finding("a state that is not finite");
  for (const auto& [name, value] : state.numbers)
    if (!std::isfinite(value)) finding("a number of the state that is not finite: " + name);
}

void read_as_snapshots(const std::filesystem::path& path, const Sample& sample) {
  if (!app::read_snapshots(path, sample.mesh, sample.dofs).allFinite()) finding("a snapshot that is not finite");
}

void read_as_start(const std::filesystem::path& path) {
  const format::ReducedMotionReader in(path, "motion");
  in.model_checksum();
  if (!in.state(in.index_at({})).allFinite()) finding("a start that is not finite");
  const auto end = in.end();
  if (!end.history.allFinite()) finding("an end that is not finite");
  for (const auto& [name, value] : end.numbers)
    if (!std::isfinite(value)) finding("a number of the end that is not finite: " + name);
}

}  // namespace

void read_input(Bytes input) {
  static const Sample sample;
  Choices choices(input);
  const bool of_full = choices.below(2) == 0;
  const auto& whole = of_full ? sample.full : sample.reduced;
  auto image = whole.image;
  if (choices.below(2) == 0) image = edited(whole.image, whole.paths, choices);
  else damage(image, choices);
  const auto path = as_file({reinterpret_cast<const std::uint8_t*>(image.data()), image.size()}, "full.h5");
  if (!of_full) return read_as_start(path);
  try {
    read_as_restart(path, sample.mesh);
  } catch (const InputError&) {
    read_as_snapshots(path, sample);
    throw;
  }
  read_as_snapshots(path, sample);
}

}  // namespace ritz::fuzz
