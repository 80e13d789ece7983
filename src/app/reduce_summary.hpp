// What ritz-reduce says in its summary.
#pragma once
#include "ritz/app/earlier.hpp"
#include "ritz/app/plan.hpp"
#include "ritz/app/summary.hpp"
#include "ritz/app/write_model.hpp"

namespace ritz::app {

/// Of a run that wrote a model. `of_modes`: the inertia over the modes, or over no columns where their vectors are not
/// at hand. *Collective*.
files::Json::Object model_summary(const config::Config& config, const stages::Problem& problem, const Earlier& earlier,
                                  const Results& results, const model::Inertia& of_modes, const Progress& progress);

/// Of a run that printed a plan. *Collective*.
files::Json::Object plan_summary(const config::Config& config, const stages::Problem& problem, const Earlier& earlier,
                                 const Plan& plan, const Progress& progress);

}  // namespace ritz::app
