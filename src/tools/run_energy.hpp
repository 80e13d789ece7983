// Whether a motion gains energy that no load put in.
#pragma once
#include <string>

namespace ritz::tools {

/// Compares the energy of a motion with what it began with, the loads' work W and what damping took, Q.
class EnergyWatch {
 public:
  explicit EnergyWatch(double energy) : begin_(energy), scale_(energy) {}

  /// Of the loads over a step, less what damping took, J.
  void add_work(double work);
  /// The energy at time t, J.
  void look(double t, double energy);

  /// A line: the most that was gained and lost without work, and what there was to gain or lose, J.
  std::string balance() const;

  /// A sentence that names integrators which hold the energy, if it grew by more than a tenth; else nothing.
  std::string warning(const std::string& integrator) const;

 private:
  double begin_, scale_, work_ = 0;
  double gained_ = 0, lost_ = 0;
  double worst_ = 0, time_ = 0;  ///< the largest gain as a fraction, and when it was first above the gate
};

}  // namespace ritz::tools
