#include "run_energy.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ritz::tools {
namespace {

constexpr double gate = 0.1;

}  // namespace

void EnergyWatch::add_work(double work) {
  work_ += work;
  scale_ = std::max({scale_, std::abs(work_), begin_ + work_});
}

void EnergyWatch::look(double t, double energy) {
  const double more = energy - begin_ - work_;
  gained_ = std::max(gained_, more);
  lost_ = std::max(lost_, -more);
  if (scale_ <= 0) return;
  const double gain = more / scale_;
  if (worst_ <= gate && gain > gate) time_ = t;
  worst_ = std::max(worst_, gain);
}

std::string EnergyWatch::balance() const {
  std::ostringstream text;
  text.precision(3);
  text << "energy balance of E - E0 - W + Q: at most " << gained_ << " J gained and " << lost_
       << " J lost; E0 + W - Q at most " << scale_ << " J";
  return text.str();
}

std::string EnergyWatch::warning(const std::string& integrator) const {
  if (worst_ <= gate) return {};
  std::ostringstream text;
  text.precision(3);
  text << "from t = " << time_ << " s on the motion gained energy without work, up to " << 100 * worst_
       << " %: " << integrator
       << " does not hold the energy of nonlinear motions at this step; say integrator = \"avf\" or "
          "\"implicit-euler\", or take shorter steps";
  return text.str();
}

}  // namespace ritz::tools
