#include "newmark_family.hpp"

namespace ritz::runtime {

ModeStep family_step(const NewmarkFamily& method, double stiffness, double damping, double dt) {
  const auto [beta, gamma, alpha_m, alpha_f] = method;
  const double now = 1 - alpha_f;
  const double pivot = 1 - alpha_m + now * dt * (gamma * damping + beta * dt * stiffness);

  // The new z and z' without their share of z''_{n+1}, then that acceleration from the equation of motion.
  const Eigen::RowVector3d z(1, dt, dt * dt * (0.5 - beta)), velocity(0, 1, dt * (1 - gamma));
  Eigen::RowVector3d acceleration = -now * (stiffness * z + damping * velocity);
  acceleration -= Eigen::RowVector3d(alpha_f * stiffness, alpha_f * damping, alpha_m);
  acceleration /= pivot;

  ModeStep step;
  step.A.topLeftCorner<3, 3>() << z + dt * dt * beta * acceleration, velocity + dt * gamma * acceleration, acceleration;
  const Eigen::Vector3d share = Eigen::Vector3d(dt * dt * beta, dt * gamma, 1) / pivot;
  step.b.head<3>() = alpha_f * share;
  step.c.head<3>() = now * share;
  return step;
}

}  // namespace ritz::runtime
