// The options of a run as they came out.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "ritz/config/config.hpp"
#include "ritz/stages/linear_modes.hpp"

namespace ritz::app {

using Options = std::vector<std::pair<std::string, std::string>>;

/// All options with what they came to: the solver that was chosen, what -fix stands for where it is left out, and the
/// checksums of the files of -snapshots and -accuracy_scene. *Collective*.
Options resolved(const config::Config& config, const mesh::Mesh& mesh, stages::Strategy strategy);

/// The value of an option among these; empty where it is none of them.
std::string value_of(const Options& options, const std::string& name);

}  // namespace ritz::app
