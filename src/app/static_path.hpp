// The load path on which the error of a basis is measured.
#pragma once
#include <optional>

#include "ritz/app/progress.hpp"
#include "ritz/config/config.hpp"
#include "ritz/scene/scene.hpp"
#include "ritz/stages/accurate_basis.hpp"

namespace ritz::app {

/// *Collective*. Equilibria of the full model under a quarter, a half, three quarters and all of the scene's loads;
/// nothing without a scene. Loads that vary in time are taken at their largest. Throws InputError, and NumericalError
/// when the full model has no equilibrium.
std::optional<stages::StaticPath> static_path(const config::Config& config, const std::optional<scene::Scene>& scene,
                                              const stages::Problem& problem, Progress& progress);

}  // namespace ritz::app
