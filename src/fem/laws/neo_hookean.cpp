#include "ritz/fem/laws/neo_hookean.hpp"

#include <Eigen/LU>
#include <cmath>

namespace ritz::fem {

// Computed from G so that small strains keep their digits: P = (μ (FFᵀ − I) + λ ln J I) F⁻ᵀ and
// W = μ (½ G : G − (J − 1 − tr G) + (J − 1 − ln J)) + λ/2 ln²J.
Response NeoHookean::response(const Matrix<3, 3>& G) const {
  const double beyond = nonlinear_volume_change(G), change = G.trace() + beyond;
  if (!(change > -1)) return unknown();
  const double log = std::log1p(change);
  const Matrix<3, 3> F = Matrix<3, 3>::Identity() + G;
  Matrix<3, 3> stretch = mu() * (G + G.transpose() + G * G.transpose());
  stretch.diagonal().array() += lambda() * log;
  const double energy = mu() * (G.squaredNorm() / 2 - beyond + less_its_logarithm(change)) + lambda() / 2 * log * log;
  return {energy, stretch * F.inverse().transpose()};
}

Moduli NeoHookean::moduli(const Matrix<3, 3>& G) const {
  const double change = G.trace() + nonlinear_volume_change(G);
  if (!(change > -1)) return Moduli::unknown();
  const Matrix<3, 3> B = (Matrix<3, 3>::Identity() + G).inverse().transpose();
  Moduli A = Moduli::of_products(B, lambda(), mu() - lambda() * std::log1p(change));
  A.add_product(mu() * Matrix<3, 3>::Identity(), Matrix<3, 3>::Identity());
  return A;
}

}  // namespace ritz::fem
