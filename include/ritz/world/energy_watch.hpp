// Whether a motion gains energy that the loads did not put in, and whether it has more than its model was made for.
#pragma once
#include <optional>

namespace ritz::world {

/// How the energy E of a motion compares with the energy E₀ at its start, the work W of the loads and the energy Q that
/// damping dissipated. The drift is E − E₀ − W + Q. All in J.
struct EnergyBalance {
  double start = 0;          ///< E₀
  double gained = 0;         ///< the largest drift above zero
  double lost = 0;           ///< the largest drift below zero, as a positive number
  double largest_drift = 0;  ///< the larger of the two
  double available = 0;      ///< the largest value so far of E₀ + W − Q and of |W − Q|
  double work = 0;           ///< W at the end
  double dissipated = 0;     ///< Q at the end
};

/// The drift exceeded a tenth of the energy that was available.
struct EnergyGain {
  double since = 0;    ///< when it first did, s
  double largest = 0;  ///< the largest ratio of the drift to the available energy
};

/// A motion went beyond the poses that its cubature was trained on: its elastic energy exceeded all of theirs.
struct BeyondTraining {
  double since = 0;    ///< when it first did: time, s, or load fraction
  double largest = 0;  ///< the largest ratio of its elastic energy to the largest of the training
};

/// Adds up the work of all steps, and compares the energy whenever it is given.
class EnergyWatch {
 public:
  /// `energy`: E₀, J.
  explicit EnergyWatch(double energy) : balance_{.start = energy, .available = energy} {}
  /// Goes on from what another watch found.
  EnergyWatch(const EnergyBalance& balance, const std::optional<EnergyGain>& gain)
      : balance_(balance), worst_(gain.value_or(EnergyGain{})) {}

  /// Adds the work of the loads and the energy dissipated by damping over one step, J.
  void add(double work, double dissipated);
  /// Compares the energy at time t (s), J.
  void look(double t, double energy);

  /// The balance of all steps and energies given so far.
  EnergyBalance balance() const;
  /// The gain, if the drift ever exceeded a tenth of the available energy.
  std::optional<EnergyGain> gain() const;

 private:
  EnergyBalance balance_;
  EnergyGain worst_;
};

}  // namespace ritz::world
