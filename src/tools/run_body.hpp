// The bodies that a run moves, with the parts of their models that it uses and no others; and whether a displaced mesh
// is still one that could be.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ritz/format/parts.hpp"
#include "ritz/model/model.hpp"
#include "ritz/scene/scene.hpp"
#include "run.hpp"

namespace ritz::tools {

enum class Frames : unsigned char { none, some };

/// A body as the scene has it. Those of one model share what was read of it.
struct RunBody {
  std::string name;  ///< empty in a scene that names no bodies
  std::filesystem::path model_file;
  scene::Scene scene;  ///< what is done to this body alone
  std::shared_ptr<const model::Body> model;
  std::string coordinates;  ///< format::coordinates_checksum of the model
};

/// The scene's bodies without their models, in its order; of a scene that names none the one of `model`. Throws
/// InputError for a body without a model file, and for a model on the command line that no body takes.
std::vector<RunBody> cast(const scene::Scene& scene, const std::filesystem::path& model);

/// Reads what a run uses of a body in a model file: its reduction or, where U is the modes, these; the polynomial if
/// there is one and `forces` wants it; points, cells and U for frames or single vertices; loads for named sets; inertia
/// for gravity and shaking; modes, geometry and inertia also where a reduction may leave out rigid motions.
/// Throws InputError when a part is missing or does not fit the others.
model::Body read_body(const format::ModelReader& in, const std::string& name, const scene::Scene& scene, Frames frames,
                      Forces forces);

/// Reads the models of all bodies that have none yet, each once. Throws as read_body, and for a body that its file does
/// not have.
void read_bodies(std::vector<RunBody>& bodies, const scene::Scene& scene, Frames frames, Forces forces);

/// What it takes to draw mode `index` (from 0): geometry, modes, and U with that column alone.
model::Body read_mode(const format::ModelReader& in, std::int64_t index);

/// How many cells the displacements (n x 3, m) turn inside out: det(I + ∇u) <= 0 at a point of the element's rule.
/// Faces, which stand for cells where only the surface is stored, are not counted.
std::int64_t inside_out(const model::Geometry& geometry, const model::Points& displacement);

}  // namespace ritz::tools
