#include "ritz/model/model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ritz::model {

namespace {

Eigen::Vector3d offset(const Inertia& inertia) {
  return inertia.gram.block<3, 1>(1, 0) / inertia.mass();  // the centre of mass seen from `origin`
}

}  // namespace

double frequency(double eigenvalue) { return std::sqrt(std::max(0.0, eigenvalue)) / (2 * std::numbers::pi); }

Eigen::Index Reduction::kept() const { return std::min(singular_values.size(), stiffness.size() - residual_vectors); }

double Inertia::mass() const { return gram(0, 0); }

Eigen::Vector3d Inertia::centre_of_mass() const { return origin + offset(*this); }

Eigen::Matrix3d Inertia::tensor() const {
  const Eigen::Vector3d c = offset(*this);
  const Eigen::Matrix3d second_moments = gram.block<3, 3>(1, 1) - mass() * c * c.transpose();
  return second_moments.trace() * Eigen::Matrix3d::Identity() - second_moments;
}

Eigen::MatrixXd Inertia::rigid_coupling() const {
  const Eigen::Index r = (gram.rows() - 4) / 3;
  const Eigen::Vector3d c = offset(*this);
  // U_aᵀ M_s (X_b - c_b)
  const auto moment = [&](Eigen::Index a, Eigen::Index b) -> Eigen::VectorXd {
    return gram.block(4 + a * r, 1 + b, r, 1) - c(b) * gram.block(4 + a * r, 0, r, 1);
  };
  Eigen::MatrixXd coupling(r, 6);
  for (Eigen::Index d = 0; d < 3; ++d) {
    const Eigen::Index e = (d + 1) % 3, f = (d + 2) % 3;
    coupling.col(d) = gram.block(4 + d * r, 0, r, 1);
    coupling.col(3 + d) = moment(f, e) - moment(e, f);  // a turn about d moves e by -x_f and f by x_e
  }
  return coupling;
}

Eigen::MatrixXd Inertia::participation_factors() const {
  Eigen::MatrixXd factors = rigid_coupling();
  const double most[] = {std::sqrt(mass()), std::sqrt(tensor().trace())};
  for (Eigen::Index d = 0; d < 6; ++d)
    for (double& factor : factors.col(d))
      if (std::abs(factor) < 1e-9 * most[d / 3]) factor = 0;
  return factors;
}

Eigen::MatrixXd Inertia::effective_masses() const { return rigid_coupling().leftCols<3>().cwiseAbs2(); }

}  // namespace ritz::model
