#include "fuzz/models.hpp"

#include <functional>
#include <sstream>

#include "fuzz/target.hpp"
#include "ritz/base/error.hpp"
#include "ritz/format/parts.hpp"
#include "ritz/tools/inspect.hpp"
#include "ritz/tools/run_body.hpp"

namespace ritz::fuzz {
namespace {

/// A scene that needs every part of a model.
scene::Scene demanding_scene() {
  scene::Scene scene;
  scene.analysis = scene::Static{1};
  scene.gravity = scene::Vector3{0, 0, -9.81};
  scene.probes = {{"set", std::string("tip")}, {"vertex", std::int64_t{10}}};
  return scene;
}

/// What it said, where it refused.
std::string refusal(const std::function<void()>& use) {
  try {
    use();
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace

void read_as_all_programs(const format::ModelReader& in) {
  std::ostringstream printed;
  const auto described = refusal([&] { tools::describe(in, Voice::verbose, printed); });
  const auto checked = refusal([&] { tools::check(in, printed); });
  const auto run = refusal(
      [&] { tools::read_body(in, in.first_body(), demanding_scene(), tools::Frames::some, tools::Forces::stored); });
  refusal([&] { tools::read_mode(in, 0); });  // a sound model may have no modes to draw
  if (checked.empty() && !run.empty()) finding("ritz-inspect --check takes what ritz-run refuses: " + run);
  for (const auto& said : {described, checked, run})
    if (!said.empty()) throw InputError(said);
}

}  // namespace ritz::fuzz
