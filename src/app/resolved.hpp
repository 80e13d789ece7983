// The options of a run with their final values.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "ritz/config/config.hpp"
#include "ritz/stages/linear_modes.hpp"

namespace ritz::app {

using Options = std::vector<std::pair<std::string, std::string>>;

/// *Collective*. All options with their final values: with the solver that was chosen, the supports that apply without
/// -fix, and the checksums of the files of -snapshots and -accuracy_scene.
Options resolved(const config::Config& config, const mesh::Mesh& mesh, stages::Strategy strategy);

/// The value of an option; empty if it is not among these.
std::string value_of(const Options& options, const std::string& name);

}  // namespace ritz::app
