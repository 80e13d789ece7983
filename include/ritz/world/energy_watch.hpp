// Whether a motion gains energy that no load put in.
#pragma once
#include <optional>

namespace ritz::world {

/// How the energy E of a motion compares with what it began with, E₀, the loads' work W and what damping took, Q; in J.
struct EnergyBalance {
  double start = 0;          ///< E₀
  double gained = 0;         ///< the most of E − E₀ − W + Q
  double lost = 0;           ///< the least of it, as a positive number
  double largest_drift = 0;  ///< the larger of the two
  double available = 0;      ///< the most of E₀ + W − Q
  double work = 0;           ///< W at the end
  double dissipated = 0;     ///< Q at the end
};

/// Energy from nowhere: E − E₀ − W + Q passed a tenth of what there was.
struct EnergyGain {
  double since = 0;    ///< s, when it was first seen
  double largest = 0;  ///< of what there was
};

/// Takes the work of each step, and the energy now and then.
class EnergyWatch {
 public:
  explicit EnergyWatch(double energy) : balance_{.start = energy, .available = energy} {}

  /// Of the loads and of damping over a step, J.
  void add(double work, double dissipated);
  /// The energy at time t, J.
  void look(double t, double energy);

  EnergyBalance balance() const;
  std::optional<EnergyGain> gain() const;

 private:
  EnergyBalance balance_;
  EnergyGain worst_;
};

}  // namespace ritz::world
