// Writes the results of the pipeline into one file.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "ritz/app/file_geometry.hpp"
#include "ritz/app/progress.hpp"
#include "ritz/app/reduced_parts.hpp"
#include "ritz/stages/linear_modes.hpp"

namespace ritz::app {

/// The results of the pipeline.
struct Results {
  const stages::ModesResult& modes;
  const Eigen::VectorXd& mesh_errors;  ///< by mode; empty if they were not asked for
  const algebra::Tall& u;              ///< the basis over owned vertices
  const ReducedBasis& basis;
  const ReducedForces& forces;
  const model::Inertia& inertia;
  const std::vector<model::SetLoad>& loads;
  const model::Inertia& of_modes;  ///< the inertia over the modes; over no columns if their vectors are not available
};

/// A model and its table of frequencies, written but not published.
class WrittenModel {
 public:
  /// *Collective*. Writes both files.
  WrittenModel(const config::Config& config, const stages::Problem& problem, const FileGeometry& order,
               const Results& results, const Progress& progress);
  ~WrittenModel();
  WrittenModel(WrittenModel&&) noexcept;

  void publish();  ///< *Collective*. Renames the files to their final names.

 private:
  struct Files;
  std::unique_ptr<Files> files_;
};

}  // namespace ritz::app
