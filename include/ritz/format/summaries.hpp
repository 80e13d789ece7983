// What summaries say of the parts of a model: docs/summary.md.
#pragma once
#include <vector>

#include "ritz/files/json.hpp"
#include "ritz/model/model.hpp"

namespace ritz::format {

/// A list of {"stage", "seconds"}.
files::Json::Array summary(const std::vector<model::StageTime>& stages);
/// How many modes there are, lists with an entry a mode, and the certificate. `over_modes`: the inertia whose columns
/// are these modes, from which their effective masses and participation factors are taken; none where their vectors are
/// not at hand.
files::Json::Object summary(const model::Modes& modes, const model::Inertia* over_modes);
/// Columns and singular values.
files::Json::Object summary(const model::Reduction& reduction);
/// Numbers of coordinates and of coefficients.
files::Json::Object summary(const model::Polynomial& polynomial);
/// Numbers of cells and points, and the errors of the training.
files::Json::Object summary(const model::Cubature& cubature);
/// Centre of mass and inertia tensor.
files::Json::Object summary(const model::Inertia& inertia);

}  // namespace ritz::format
