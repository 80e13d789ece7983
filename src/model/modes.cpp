#include <algorithm>
#include <cmath>
#include <numbers>

#include "ritz/model/model.hpp"

namespace ritz::model {

double frequency(double eigenvalue) { return std::sqrt(std::max(0.0, eigenvalue)) / (2 * std::numbers::pi); }

}  // namespace ritz::model
