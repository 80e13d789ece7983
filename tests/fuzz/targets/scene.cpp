// A scene, and what programs compute from it before they begin.
#include <cmath>

#include "fuzz/target.hpp"
#include "ritz/scene_file/read.hpp"

namespace ritz::fuzz {

void read_input(Bytes input) {
  const auto scene = scene::parse({input.begin(), input.end()}, "scene.toml");
  if (const auto* time = std::get_if<scene::Time>(&scene.analysis)) {
    if (!(time->step > 0 && std::isfinite(time->end))) finding("a time step that is none");
    if (scene::step_count(*time) < 1) finding("no steps");
  }
  for (const auto& load : scene.loads)
    if (!std::isfinite(scene::factor(scene, load.table, 0.5))) finding("a load's factor that is not finite");
}

}  // namespace ritz::fuzz
