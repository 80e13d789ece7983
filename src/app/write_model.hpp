// The pipeline's results as one file.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "ritz/app/file_geometry.hpp"
#include "ritz/app/progress.hpp"
#include "ritz/app/reduced_parts.hpp"
#include "ritz/stages/linear_modes.hpp"

namespace ritz::app {

/// What the pipeline came to.
struct Results {
  const stages::ModesResult& modes;
  const petsc::Tall& u;  ///< the basis over owned vertices
  const ReducedBasis& basis;
  const std::optional<ReducedPolynomial>& polynomial;
  const model::Inertia& inertia;
  const std::vector<model::SetLoad>& loads;
};

/// A model and the table of its frequencies beside it, written and not yet named.
class WrittenModel {
 public:
  /// Writes them. *Collective*.
  WrittenModel(const config::Config& config, const stages::Problem& problem, const FileGeometry& order,
               const Results& results, const Progress& progress);
  ~WrittenModel();
  WrittenModel(WrittenModel&&) noexcept;

  void publish();  ///< Gives them their names. *Collective*.

 private:
  struct Files;
  std::unique_ptr<Files> files_;
};

}  // namespace ritz::app
