// The nonlinear stages of the pipeline, each with its witness, if they are asked for.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ritz/app/progress.hpp"
#include "ritz/config/config.hpp"
#include "ritz/scene/scene.hpp"
#include "ritz/stages/accurate_basis.hpp"
#include "ritz/stages/static_answers.hpp"
#include "ritz/stages/witness.hpp"

namespace ritz::app {

/// *Collective*. Equilibria of the full model under a quarter, a half, three quarters and all of the scene's loads;
/// nothing without a scene. Loads that vary in time are taken at their largest. Throws InputError, and NumericalError
/// when the full model has no equilibrium.
std::optional<stages::StaticPath> static_path(const config::Config& config, const std::optional<scene::Scene>& scene,
                                              const stages::Problem& problem, Progress& progress);

/// The requested error of a basis, and the basis that reaches it.
struct Accuracy {
  double target = 0;
  stages::SizedError reached;
};

/// The cost of a basis and how far it can be trusted. What was not asked for is absent.
struct BasisFigures {
  std::optional<double> orthonormality;  ///< max |UᵀMU − I|
  std::optional<stages::DerivativeCounts> derivatives;
  std::optional<double> taylor_slope;              ///< of the modal derivatives
  std::vector<stages::StaticError> static_errors;  ///< of the loads whose static answers were solved for
  std::optional<Accuracy> accuracy;
};

/// A cubature and the polynomial beside which it was trained.
struct TrainedForces {
  model::Polynomial polynomial;
  model::Cubature cubature;
};

/// The basis U, rows of free degrees of freedom: the modes themselves if no other basis was asked for.
struct ReducedBasis {
  mesh::FreeRows U;
  std::optional<model::Reduction> reduction;
  BasisFigures figures;
  std::optional<TrainedForces> trained = {};  ///< over U, where they were trained to find its size
};

struct ReducedPolynomial {
  model::Polynomial value;
  stages::PolynomialErrors errors;
};

/// The reduced forces of large displacements; what the laws do not need is absent.
struct ReducedForces {
  std::optional<ReducedPolynomial> polynomial;
  std::optional<model::Cubature> cubature;
};

/// The loads for whose static answers the modes' stage solved (ModesResult::answers), and which of them join the basis.
struct StaticLoads {
  stages::UnitLoads solved;
  std::vector<stages::LoadPlace> residual;
};

/// *Collective*. Computes the basis, and what it misses of static answers. `path` is the load path on which its error
/// is measured, if an error was requested. Throws InputError for snapshots or sizes that do not fit, and NumericalError
/// when the requested error cannot be reached.
ReducedBasis reduce_basis(const config::Config& config, const stages::Problem& problem,
                          const stages::ModesResult& modes, const StaticLoads& loads,
                          const std::optional<stages::StaticPath>& path, Progress& progress);

/// *Collective*. Computes the polynomial and trains the cubature; nothing if nothing was asked for. `u` is the basis
/// over owned vertices. Throws NumericalError when a witness fails or a cubature is not accurate enough, and InputError
/// for sizes that do not fit.
ReducedForces reduce_forces(const config::Config& config, const stages::Problem& problem, const ReducedBasis& basis,
                            const mesh::VertexRows& u, Progress& progress);

/// The results as text to be printed; empty for a linear model.
std::string basis_lines(const ReducedBasis& basis, const ReducedForces& forces, const model::Inertia& inertia,
                        Voice voice);

}  // namespace ritz::app
