#include "ritz/world/energy_watch.hpp"

#include <algorithm>
#include <cmath>

namespace ritz::world {
namespace {

constexpr double gate = 0.1;

}  // namespace

void EnergyWatch::add(double work, double dissipated) {
  balance_.work += work;
  balance_.dissipated += dissipated;
  const double net = balance_.work - balance_.dissipated;
  balance_.available = std::max({balance_.available, std::abs(net), balance_.start + net});
}

void EnergyWatch::look(double t, double energy) {
  const double more = energy - balance_.start - (balance_.work - balance_.dissipated);
  balance_.gained = std::max(balance_.gained, more);
  balance_.lost = std::max(balance_.lost, -more);
  if (balance_.available <= 0) return;
  const double gain = more / balance_.available;
  if (worst_.largest <= gate && gain > gate) worst_.since = t;
  worst_.largest = std::max(worst_.largest, gain);
}

EnergyBalance EnergyWatch::balance() const {
  EnergyBalance balance = balance_;
  balance.largest_drift = std::max(balance.gained, balance.lost);
  return balance;
}

std::optional<EnergyGain> EnergyWatch::gain() const {
  if (worst_.largest <= gate) return std::nullopt;
  return worst_;
}

}  // namespace ritz::world
