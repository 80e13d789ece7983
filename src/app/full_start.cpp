#include "ritz/app/full_start.hpp"

#include <algorithm>
#include <cmath>

#include "ritz/app/full_file.hpp"
#include "ritz/app/plan.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/format/motion_reader.hpp"
#include "ritz/format/parts.hpp"
#include "ritz/format/sound.hpp"
#include "ritz/parallel/guard.hpp"
#include "ritz/scene_file/read.hpp"

namespace ritz::app {
namespace {

std::string name_of(scene::Integrator integrator) {
  return std::string(scene::integrator_names[static_cast<std::size_t>(integrator)]);
}

/// u = U z and v = U z' of this rank's vertices: of the motion of a reduced model.
LastState read_reduced_start(const scene::StoredStart& start, const mesh::Mesh& mesh,
                             const std::string& problem_checksum) {
  const format::ReducedMotionReader motion(start.motion, "[initial] motion " + start.motion.string());
  const format::ModelReader model(start.model);
  const auto refuse = [&](const std::string& why) { throw InputError(motion.name() + ": " + why); };
  const auto bodies = model.bodies();
  const auto body = std::ranges::find_if(bodies, [&](const std::string& name) {
    return format::coordinates_checksum(model, name) == motion.model_checksum();
  });
  if (body == bodies.end()) refuse("it is the motion of another model than " + start.model.string());
  if (format::read_checksums(model, *body).problem != problem_checksum)
    refuse("its model was made for another mesh, material or support");
  if (format::basis_size(model, *body).vertices != mesh.vertices_total)
    refuse("its model stores the surface alone, and the full model needs the displacements of all vertices");
  format::BasisSelection mine;
  mine.vertices.emplace(mesh.file_positions.begin(), mesh.file_positions.begin() + mesh.owned);
  const Eigen::MatrixXd z = motion.state(motion.index_at(start.time));
  const algebra::Tall moves = format::read_basis(model, mine, *body).U * z;
  return {.integrator = {}, .numbers = {}, .u = moves.col(0), .v = moves.col(1), .a = {}};
}

LastState read_full_start(const scene::StoredStart& start, const mesh::Mesh& mesh,
                          const std::string& problem_checksum) {
  const std::string name = "[initial] motion " + start.motion.string();
  verify_last_state(mesh.comm, start.motion, name);
  auto last = read_last_state(start.motion, name, mesh, problem_checksum);
  const double t = last.numbers.at("t");
  constexpr double rounding = 1e-9;
  if (start.time && std::abs(*start.time - t) > rounding * t)
    throw InputError(name + ": it holds the velocities of its last state alone, at t = " + shown(t, 12) +
                     " s: leave 'time' out");
  return last;
}

/// u and v of the motion that the scene starts from.
stages::DynamicState stored_start(const scene::StoredStart& start, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
                                  const std::string& problem_checksum) {
  LastState first;
  if (start.model.empty()) {
    first = read_full_start(start, mesh, problem_checksum);
  } else {
    // Checksums are of whole datasets, so one rank looks at all of it before all read their shares.
    parallel::on_root(mesh.comm, [&] { format::check(format::ModelReader(start.model)); });
    parallel::together(mesh.comm, [&] { first = read_reduced_start(start, mesh, problem_checksum); });
  }
  return {0,
          mesh::from_vertices(mesh, dofs, first.u),
          mesh::from_vertices(mesh, dofs, first.v),
          algebra::Tall::Zero(dofs.owned, 1),
          {}};
}

}  // namespace

stages::FullIntegrator integrator_of(const scene::Time& time) {
  switch (time.integrator.value_or(scene::Integrator::avf)) {
    case scene::Integrator::avf: return stages::FullIntegrator::avf;
    case scene::Integrator::newmark: return stages::FullIntegrator::newmark;
    case scene::Integrator::implicit_euler: return stages::FullIntegrator::implicit_euler;
    default: break;
  }
  throw InputError("[time] integrator = \"" + name_of(*time.integrator) +
                   "\": the full model has avf, newmark and implicit-euler");
}

std::string integrator_name(const scene::Scene& scene) {
  const auto* time = std::get_if<scene::Time>(&scene.analysis);
  return time ? name_of(time->integrator.value_or(scene::Integrator::avf)) : "none";
}

algebra::LinearSolver linear_solver(const config::Config& config, const mesh::Dofs& dofs) {
  return choose_strategy(config, dofs).strategy == stages::Strategy::direct ? algebra::LinearSolver::direct
                                                                            : algebra::LinearSolver::iterative;
}

scene::Scene read_scene(MPI_Comm comm, const std::filesystem::path& path) {
  scene::Scene scene;
  parallel::together(comm, [&] {
    scene = scene::read(path);
    if (scene.bodies.size() > 1)
      throw InputError(path.string() + ": the scene has " + std::to_string(scene.bodies.size()) +
                       " bodies, and the full model is of one: give a scene of one [[body]], or ritz-run");
  });
  return scene;
}

scene::Scene read_full_scene(MPI_Comm comm, const std::filesystem::path& path) {
  auto scene = read_scene(comm, path);
  parallel::together(comm, [&] {
    if (const auto* time = std::get_if<scene::Time>(&scene.analysis)) integrator_of(*time);
    if (!scene.damping.ratio.empty())
      throw InputError(path.string() + ": [damping] ratio is for modes; the full model has alpha and beta");
    if (!scene.bodies.empty()) scene = scene::of_body(scene, scene.bodies.front().name);
    if (scene.initial && std::holds_alternative<scene::CoordinateStart>(*scene.initial))
      throw InputError(path.string() +
                       ": z and velocity of [initial] are coordinates of a reduced model; the full model starts from "
                       "'static' or a 'motion'");
  });
  return scene;
}

stages::DynamicState first_state(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
                                 const scene::Scene& scene, const std::string& problem_checksum) {
  const algebra::Tall zeros = algebra::Tall::Zero(dofs.owned, 1);
  const auto* stored = scene.initial ? std::get_if<scene::StoredStart>(&*scene.initial) : nullptr;
  if (!config.full.restart)
    return stored ? stored_start(*stored, mesh, dofs, problem_checksum)
                  : stages::DynamicState{0, zeros, zeros, zeros, {}};
  const LastState last =
      read_last_state(*config.full.restart, "-restart " + config.full.restart->string(), mesh, problem_checksum);
  const auto free = [&](const algebra::Tall& u) { return mesh::from_vertices(mesh, dofs, u); };
  const bool moves = std::holds_alternative<scene::Time>(scene.analysis);
  if (!moves && last.kind == StateKind::moving)
    throw InputError("-restart " + config.full.restart->string() +
                     ": its last state moves, and [static] cannot go on from there");
  if (moves && last.kind == StateKind::at_rest) {
    if (scene.initial)
      throw InputError("-restart " + config.full.restart->string() +
                       " lets a static state go, and the scene has an [initial]: keep one of them");
    return {0, free(last.u), zeros, zeros, {}};
  }
  const auto& n = last.numbers;
  return {n.at("t"),
          free(last.u),
          free(last.v),
          last.integrator == integrator_name(scene) ? free(last.a) : algebra::Tall(dofs.owned, 0),
          {n.at("kinetic"), n.at("elastic"), n.at("work"), n.at("dissipated"), n.at("start")}};
}

stages::DynamicState static_start(stages::FullModel& model, const stages::LoadAt& load) {
  const algebra::Tall full = load(0), none = algebra::Tall::Zero(full.rows(), 1);
  stages::DynamicState start{0, none, none, none, {}};
  const std::string what = "[initial] static: ";
  try {
    stages::full_statics(
        model, {.steps = 1}, {0, none, 0}, [&](double t) { return algebra::Tall(t * full); },
        [&](const stages::StaticState& now, const stages::StaticReport&) { start.u = now.u; });
  } catch (const InputError& error) {
    throw InputError(what + error.what(), error.reason);
  } catch (const NumericalError& error) {
    throw NumericalError(what + error.what());
  }
  return start;
}

std::int64_t step_count_from(const scene::Scene& scene, double from) {
  if (const auto* time = std::get_if<scene::Time>(&scene.analysis))
    return static_cast<std::int64_t>(std::ceil((time->end - from) / time->step - 1e-9));
  return std::get<scene::Static>(scene.analysis).steps;
}

std::vector<double> times_from(const scene::Scene& scene, double from) {
  std::vector<double> times = {from};
  if (const auto* time = std::get_if<scene::Time>(&scene.analysis)) {
    const auto steps = step_count_from(scene, from);
    for (std::int64_t n = 1; n <= steps; ++n) times.push_back(from + static_cast<double>(n) * time->step);
  } else {
    const int steps = std::get<scene::Static>(scene.analysis).steps;
    for (int n = 1; n <= steps; ++n)
      if (const double t = static_cast<double>(n) / steps; t > from * (1 + 1e-9)) times.push_back(t);
  }
  if (times.size() == 1)
    throw InputError("nothing is left to do: the state to start from, at " + shown(from, 3) +
                     ", is the scene's end or later");
  return times;
}

}  // namespace ritz::app
