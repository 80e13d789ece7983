// Reduced polynomials that come from a positive energy, as those of elastic bodies do.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "ritz/model/model.hpp"

namespace ritz::test {

/// Ẽ = ½ Σ_m e_m², e_m = a_m·z + ½ zᵀQ_m z: as many "strains" as there are rows of a. Ẽ ≥ 0.
struct StrainEnergy {
  Eigen::MatrixXd a;               ///< strains x r
  std::vector<Eigen::MatrixXd> Q;  ///< symmetric, r x r, one a strain

  double energy(const Eigen::VectorXd& z) const;
  double strain(Eigen::Index m, const Eigen::VectorXd& z) const;  ///< e_m
};

/// The derivatives of Ẽ at rest, by i ≤ j ≤ k ≤ l.
model::Polynomial polynomial_of(const StrainEnergy& e);

/// Random strains; K̃(0) is diagonal with ω from 1 to `stiffest`, and amplitudes near 1 are large.
StrainEnergy random_strains(Eigen::Index r, double stiffest, unsigned seed = 7);

model::Polynomial random_polynomial(Eigen::Index r, double stiffest = 10, unsigned seed = 7);

/// z'' + λ z + γ z³ = 0: Ẽ = ½ λ z² + ¼ γ z⁴.
model::Polynomial duffing(double lambda, double gamma);

/// The same polynomial without its cubic and quartic parts.
model::Polynomial linear_part(model::Polynomial p);

}  // namespace ritz::test
