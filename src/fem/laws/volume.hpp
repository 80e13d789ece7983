// The energy of a change of volume, which the laws of rubber add to that of a change of shape.
#pragma once
#include <initializer_list>

#include "ritz/fem/law.hpp"

namespace ritz::fem {

/// U(J) and its derivatives by J, Pa.
struct Volume {
  double energy = 0, first = 0, second = 0;
};

/// U = Σ_k (J − 1)^(2k) / D_k for k = 1, 2, …; a term whose D_k is zero is absent. `change` is J − 1.
inline Volume powers_of_volume(double change, std::initializer_list<double> D) {
  Volume U;
  double even = 1;  // (J − 1)^(2k−2)
  int k = 0;
  for (const double d : D) {
    const int power = 2 * ++k;
    if (d != 0) {
      U.energy += even * change * change / d;
      U.first += power * even * change / d;
      U.second += power * (power - 1) * even / d;
    }
    even *= change * change;
  }
  return U;
}

/// What (J − 1)²/D is near rest: t₁² − 2 t₁t₂ + t₁³ + … over D, with t_k = tr E^k.
inline ElasticConstants volume_at_rest(double D) { return {2 / D, 0, 0, -2 / D, 3 / D}; }

}  // namespace ritz::fem
