// The least squares problem of a cubature: what cells have to sum up to, and the columns of those that can be chosen.
#pragma once
#include <unordered_map>
#include <utility>
#include <vector>

#include "ritz/model/model.hpp"
#include "ritz/stages/cell_forces.hpp"
#include "ritz/stages/nonnegative_least_squares.hpp"
#include "ritz/stages/training_poses.hpp"

namespace ritz::stages {

/// Poses, what the forces of weighted cells have to sum up to there, and the norm that errors are measured in.
struct CubatureTargets {
  Eigen::MatrixXd z;       ///< r x N
  Eigen::VectorXd roots;   ///< Λ^(−½), r
  Eigen::VectorXd scales;  ///< 1 / ‖Λ^(−½) f‖ of each pose, N
  Eigen::MatrixXd sums;    ///< r x N: the exact force f, or what it has beyond the polynomial's

  CubatureTargets of(Eigen::Index first, Eigen::Index count) const;  ///< of some of the poses
  /// Λ^(−½) force / ‖Λ^(−½) f‖ of each pose, r x N.
  Eigen::MatrixXd scaled(const Eigen::Ref<const Eigen::MatrixXd>& force) const;
};

CubatureTargets cubature_targets(const Poses& poses, const Eigen::VectorXd& stiffness,
                                 const model::Polynomial& polynomial, model::Integrand integrand);

/// The scaled forces of cells at the poses, as columns of r N numbers. They are held in single precision, and computed
/// anew in double precision for cells that are chosen.
class CubatureColumns {
 public:
  /// `cells` are local numbers. The arguments have to outlive the columns.
  CubatureColumns(const CellBasis& basis, model::Integrand integrand, const CubatureTargets& targets,
                  const std::vector<int>& cells);

  /// For nonnegative_least_squares; the numbers are the cells' positions in the file. Refers to this.
  DistributedColumns distributed() const;
  /// Those of the fit's cells that this rank holds, by their local numbers, and their weights.
  std::vector<std::pair<int, double>> chosen(const NonnegativeFit& fit) const;

 private:
  const CellBasis& basis_;
  model::Integrand integrand_;
  const CubatureTargets& targets_;
  const std::vector<int>& cells_;
  Eigen::MatrixXf values_;
  std::vector<std::int64_t> numbers_;
  std::unordered_map<std::int64_t, std::size_t> places_;
};

}  // namespace ritz::stages
