// The nonlinear stages of the pipeline, where they are asked for, each with its witness.
#pragma once
#include <optional>
#include <string>

#include "ritz/app/progress.hpp"
#include "ritz/config/config.hpp"
#include "ritz/stages/accurate_basis.hpp"
#include "ritz/stages/witness.hpp"

namespace ritz::app {

/// The target for a basis's error that was given, and the basis that reaches it.
struct Accuracy {
  double target = 0;
  stages::SizedError reached;
};

/// What a basis cost and how far it can be trusted; absent what was not asked for.
struct BasisFigures {
  std::optional<double> orthonormality;  ///< max |UᵀMU − I|
  std::optional<stages::DerivativeCounts> derivatives;
  std::optional<double> taylor_slope;  ///< of the derivatives' witness
  std::optional<Accuracy> accuracy;
};

/// The basis U, rows of free degrees of freedom: the modes themselves where no basis was asked for.
struct ReducedBasis {
  mesh::FreeRows U;
  std::optional<model::Reduction> reduction;
  BasisFigures figures;
};

struct ReducedPolynomial {
  model::Polynomial value;
  stages::PolynomialErrors errors;
};

/// `path`: what a target for the error is measured on. Throws InputError for snapshots or sizes that do not fit, and
/// NumericalError when the target is out of reach. *Collective*.
ReducedBasis reduce_basis(const config::Config& config, const stages::Problem& problem,
                          const stages::ModesResult& modes, const std::optional<stages::StaticPath>& path,
                          Progress& progress);

/// Nothing where no polynomial was asked for. `u`: the basis over owned vertices. Throws NumericalError when the
/// witness fails. *Collective*.
std::optional<ReducedPolynomial> reduce_forces(const config::Config& config, const stages::Problem& problem,
                                               const mesh::VertexRows& u, Progress& progress);

/// What they came to, for people; empty for a linear model.
std::string basis_lines(const ReducedBasis& basis, const std::optional<ReducedPolynomial>& polynomial,
                        const model::Inertia& inertia);

}  // namespace ritz::app
