// The contents of ritz-reduce's summary.
#pragma once
#include "ritz/app/earlier.hpp"
#include "ritz/app/plan.hpp"
#include "ritz/app/summary.hpp"
#include "ritz/app/write_model.hpp"

namespace ritz::app {

/// *Collective*. Of a run that wrote a model.
files::Json::Object model_summary(const config::Config& config, const stages::Problem& problem, const Earlier& earlier,
                                  const Results& results, const Progress& progress);

/// *Collective*. Of a run that printed a plan.
files::Json::Object plan_summary(const config::Config& config, const stages::Problem& problem, const Earlier& earlier,
                                 const Plan& plan, const Progress& progress);

}  // namespace ritz::app
