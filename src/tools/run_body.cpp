#include "run_body.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "ritz/base/error.hpp"
#include "ritz/base/printable.hpp"
#include "ritz/fem/geometry.hpp"
#include "ritz/format/sound.hpp"
#include "ritz/world/rigid_motions.hpp"

namespace ritz::tools {
namespace {

/// Whether any load or probe acts on a single vertex (or, else, on a named set).
template <class Kind>
bool any_target(const scene::Scene& scene) {
  const auto is = [](const auto& item) { return std::holds_alternative<Kind>(item.target); };
  return std::ranges::any_of(scene.loads, is) || std::ranges::any_of(scene.probes, is);
}

}  // namespace

std::vector<RunBody> cast(const scene::Scene& scene, const std::filesystem::path& model) {
  if (scene.bodies.empty()) {
    if (model.empty()) throw InputError("there is no model: give MODEL.h5, or a scene whose [[body]] names one");
    return {{.name = {}, .model_file = model, .scene = scene, .model = {}, .coordinates = {}}};
  }
  std::vector<RunBody> bodies;
  bool taken = false;
  for (const auto& body : scene.bodies) {
    const auto& file = body.model.empty() ? model : body.model;
    taken = taken || body.model.empty();
    if (file.empty())
      throw InputError("body '" + printable(body.name) + "' has no model: give MODEL.h5, or 'model' of its [[body]]");
    bodies.push_back(
        {.name = body.name, .model_file = file, .scene = of_body(scene, body.name), .model = {}, .coordinates = {}});
  }
  if (!taken && !model.empty())
    throw InputError("each [[body]] of the scene names its 'model', so that " + model.string() +
                     " is not used: leave one of them out");
  return bodies;
}

model::Body read_body(const format::ModelReader& in, const std::string& name, const scene::Scene& scene, Frames frames,
                      Forces forces) {
  model::Body body;
  body.name = name;
  format::check_complete(in, body.name);
  body.reduction = format::read_reduction(in, body.name);
  body.modes = format::read_modes(in, body.name);
  const bool lacks_motions = world::lacks_motions(body);
  if (forces == Forces::stored) {
    body.polynomial = format::read_polynomial(in, body.name);
    body.cubature = format::read_cubature(in, body.name);
    if (body.cubature) body.geometry.materials = format::read_materials(in, body.name);
  }
  if (frames == Frames::some || any_target<std::int64_t>(scene) || lacks_motions) {
    body.geometry = format::read_geometry(in, body.name);
    body.basis = format::read_basis(in, {}, body.name);
  }
  if (any_target<std::string>(scene)) body.loads = format::read_loads(in, body.name);
  if (scene.gravity || scene.shake || lacks_motions) body.inertia = format::read_inertia(in, body.name);
  format::check_witnesses(in, body);
  return body;
}

void read_bodies(std::vector<RunBody>& bodies, const scene::Scene& scene, Frames frames, Forces forces) {
  struct Shared {
    scene::Scene scene;  ///< what is done to all bodies of this model
    std::vector<RunBody*> bodies;
  };
  std::map<std::filesystem::path, format::ModelReader> files;
  std::map<std::pair<std::filesystem::path, std::string>, Shared> models;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].model) continue;
    const auto& file = bodies[i].model_file;
    const auto& in = files.try_emplace(file, file).first->second;
    const auto asked = scene.bodies.empty() ? std::string() : scene.bodies[i].model_body;
    if (!asked.empty()) in.require_body(asked);
    const auto name = asked.empty() ? in.first_body() : asked;
    const auto [shared, is_new] = models.try_emplace({file, name}, Shared{bodies[i].scene, {}});
    auto& [all, made_from] = shared->second;
    made_from.push_back(&bodies[i]);
    if (is_new) continue;
    all.loads.insert(all.loads.end(), bodies[i].scene.loads.begin(), bodies[i].scene.loads.end());
    all.probes.insert(all.probes.end(), bodies[i].scene.probes.begin(), bodies[i].scene.probes.end());
  }
  for (auto& [key, shared] : models) {
    const auto& [file, name] = key;
    const auto model =
        std::make_shared<const model::Body>(read_body(files.at(file), name, shared.scene, frames, forces));
    const auto coordinates = format::coordinates_checksum(files.at(file), name);
    for (auto* body : shared.bodies) {
      body->model = model;
      body->coordinates = coordinates;
    }
  }
}

model::Body read_mode(const format::ModelReader& in, std::int64_t index) {
  model::Body body;
  body.name = in.first_body();
  if (in.has(format::schema::reduction, body.name))
    throw InputError(in.name() + " has a reduced basis whose columns are not modes: --animate-mode needs a model of " +
                     "modes alone, reduced without -derivatives, -snapshots and -basis");
  format::check_complete(in, body.name);
  body.modes = format::read_modes(in, body.name);
  const Eigen::Index r = body.modes->eigenvalues.size();
  if (index >= r)
    throw InputError("there is no mode " + std::to_string(index + 1) + " in " + in.name() +
                     ": --animate-mode is 1 to " + std::to_string(r));
  body.geometry = format::read_geometry(in, body.name);
  body.basis = format::read_basis(in, {.columns = {{index}}, .vertices = {}}, body.name);
  format::check_witnesses(in, body);
  return body;
}

namespace {

fem::CellVectors gathered(const model::Points& rows, std::span<const std::int64_t> vertices) {
  fem::CellVectors x(3, static_cast<int>(vertices.size()));
  for (int a = 0; a < x.cols(); ++a) x.col(a) = rows.row(vertices[static_cast<std::size_t>(a)]);
  return x;
}

}  // namespace

std::int64_t inside_out(const model::Geometry& geometry, const model::Points& displacement) {
  const auto& cells = geometry.cells;
  std::int64_t count = 0;
  for (std::size_t c = 0; c < cells.vtk_types.size(); ++c) {
    const auto type = fem::cell_of_vtk(cells.vtk_types[c]);
    if (!type) continue;
    const auto vertices =
        std::span(cells.vertices)
            .subspan(static_cast<std::size_t>(cells.offsets[c]), static_cast<std::size_t>(fem::shape(*type).vertices));
    count += fem::turned_inside_out(*type, gathered(geometry.points, vertices), gathered(displacement, vertices));
  }
  return count;
}

}  // namespace ritz::tools
