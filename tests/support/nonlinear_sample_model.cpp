#include "support/nonlinear_sample_model.hpp"

namespace ritz::test {

model::Polynomial sample_polynomial() {
  constexpr double gamma = 2;
  model::Polynomial p{2, Eigen::Vector3d(4, 0, 9), Eigen::VectorXd::Zero(4), Eigen::VectorXd::Zero(5)};
  p.quartic << 6, 0, 2 * gamma, 0, 6 * gamma * gamma;  // 1111, 1112, 1122, 1222, 2222
  return p;
}

model::Model nonlinear_sample_model() {
  auto m = sample_model();
  m.bodies[0].reduction = model::Reduction{
      .stiffness = Eigen::Vector2d(4, 9), .singular_values = Eigen::Vector3d(2, 1, 0.25), .discarded = 0.25};
  m.bodies[0].polynomial = sample_polynomial();
  return m;
}

model::Model cubature_sample_model() {
  auto m = nonlinear_sample_model();
  auto& cubature = m.bodies[0].cubature.emplace();
  cubature.integrand = model::Integrand::beyond_polynomial;
  cubature.cells = {7, 12};
  cubature.weights = Eigen::Vector2d(1.5, 20);
  cubature.regions = {1, 1};
  cubature.starts = {0, 1, 3};
  cubature.volumes = Eigen::Vector3d(1e-6, 2e-6, 3e-6);
  cubature.gradients = Eigen::MatrixXd::Zero(27, 2);
  for (Eigen::Index p = 0; p < 3; ++p) cubature.gradients(9 * p + 8, 1) = .05;
  cubature.largest_energy = 40;
  cubature.errors = {{1, {.5, .75}, {.25, .5}, {.125, .25}}, {2, {.01, .02}, {.03, .04}, {.05, .06}}};
  return m;
}

model::Model two_body_model() {
  auto m = sample_model();
  auto& arm = m.bodies.emplace_back(nonlinear_sample_model().bodies[0]);
  arm.name = "arm/upper";
  arm.checksums = {"00000000000000aa", "00000000000000bb"};
  arm.geometry.points.col(0).array() += 5;
  arm.report = {{{"assemble", 2}}, {{"vertices", 4}}, {"the arm's springs harden"}, {}};
  return m;
}

}  // namespace ritz::test
