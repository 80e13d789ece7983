// St. Venant-Kirchhoff: S = λ tr(E) I + 2 μ E. Its small-strain limit is Hooke's law.
#pragma once

namespace ritz::fem {

/// Isotropic StVK material. Units: young Pa, poisson 1, density kg/m³.
/// Valid for young > 0, -1 < poisson < 1/2, density > 0; whoever reads one from outside checks that.
struct StVK {
  double young;
  double poisson;
  double density;

  /// Lamé's first parameter λ, Pa.
  double lambda() const { return young * poisson / ((1 + poisson) * (1 - 2 * poisson)); }
  /// Shear modulus μ, Pa.
  double mu() const { return young / (2 * (1 + poisson)); }
};

}  // namespace ritz::fem
