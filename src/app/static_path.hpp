// What a target for the error of a basis is measured on.
#pragma once
#include <optional>

#include "ritz/app/progress.hpp"
#include "ritz/config/config.hpp"
#include "ritz/scene/scene.hpp"
#include "ritz/stages/accurate_basis.hpp"

namespace ritz::app {

/// Full equilibria under a quarter, a half, three quarters and all of the scene's loads, where there is a scene; loads
/// that change in time count as they are when they are largest. Throws InputError, and NumericalError where the full
/// model has no equilibrium. *Collective*.
std::optional<stages::StaticPath> static_path(const config::Config& config, const std::optional<scene::Scene>& scene,
                                              const stages::Problem& problem, Progress& progress);

}  // namespace ritz::app
