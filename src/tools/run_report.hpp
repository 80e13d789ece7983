// What ritz-run says of a run: sentences for people, with what to do, and numbers (--summary FILE.json, described in
// docs/summary.md).
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ritz/files/json.hpp"
#include "ritz/scene/scene.hpp"
#include "ritz/world/rigid_motions.hpp"
#include "ritz/world/run.hpp"
#include "run.hpp"
#include "run_body.hpp"

namespace ritz::tools {

/// What a sentence about one of several bodies begins with; nothing in a scene that names no bodies.
std::string who(const RunBody& body);

/// Throws what ends a run early: NumericalError, or InputError where the scene is at fault.
[[noreturn]] void fail(const world::RunResult& result, const RunBody& body);

/// Throws InputError for loads that move a body as a whole though its basis leaves that out.
[[noreturn]] void refuse(const world::LeftOut& left_out, const std::string& model);

/// A line: the most that was gained and lost without work, and what there was to gain or lose, J.
std::string balance_line(const world::EnergyBalance& balance);

/// A warning of damping ratios of 1 and more, which are percents as a rule; empty if there are none.
std::string overdamped(const scene::Damping& damping);

/// A line: what the steps are wrong by, as estimated, in the largest step and in all.
std::string error_line(const world::StepErrors& errors);

/// A warning where one step's estimated error is more than a tenth of the largest displacement; empty if none is.
std::string too_long(const world::StepErrors& errors, const std::string& integrator);

/// A sentence that says when a cubature was taken beyond its training, and what helps.
std::string warning(const world::BeyondTraining& beyond, const scene::Scene& scene);
/// A sentence that names integrators which hold the energy.
std::string warning(const world::EnergyGain& gain, const std::string& integrator);

/// What came of a body.
struct BodyResult {
  RunBody body;
  world::RunResult result;
  std::filesystem::path output;     ///< its motion; empty if none is written
  std::int64_t inverted_cells = 0;  ///< at the end, of the cells that frames show
};

struct Summarised {
  const RunOptions& options;
  const scene::Scene& scene;
  std::span<const BodyResult> bodies;
  std::int64_t frames = 0;
  const std::vector<std::string>& warnings;
};

files::Json summary(const Summarised& run);

}  // namespace ritz::tools
