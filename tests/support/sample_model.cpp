#include "support/sample_model.hpp"

#include <cmath>

namespace ritz::test {

model::Geometry sample_geometry() {
  model::Geometry g;
  g.full_vertices = 4;
  g.points.resize(4, 3);
  g.points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  g.vertex_ids = {10, 20, 30, 41};
  g.cells = {{10}, {0, 4}, {0, 1, 2, 3}};
  g.sets = {{"tip", {1}, 1}, {"end/of 50% cells", {0, 1}, 2}, {"inner", {}, 3}};
  g.materials = {{"steel", {fem::StVK{200e9, 0.3}, 7800}}, {"rubber", {fem::NeoHookean{1e6, 0.49}, 1000}}};
  return g;
}

model::Basis sample_basis() {
  model::Basis b;
  b.U = model::RowMatrix::Zero(12, 2);
  b.U(2, 0) = b.U(5, 1) = 1 / std::sqrt(2.0);
  return b;
}

model::Modes sample_modes() {
  model::Modes m;
  m.eigenvalues = Eigen::Vector2d(4, 9);
  m.energies = Eigen::Vector2d(4, 9);
  m.residuals = Eigen::Vector2d(1e-12, 2e-12);
  m.floor_applies = {0, 1};
  m.kinds = {model::ModeKind::flexible, model::ModeKind::flexible};
  m.orthonormality = 3e-16;
  m.certificate = {model::Certified::inertia, 10.0, 2, 2};
  return m;
}

model::Inertia sample_inertia() {
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(2, 10);
  B.col(0).setOnes();
  B(1, 1) = 1;
  B(0, 8) = B(1, 9) = 1 / std::sqrt(2.0);
  return {Eigen::Vector3d::Zero(), B.transpose() * 2 * B};
}

std::vector<model::SetLoad> sample_loads() {
  model::SetLoad tip, end;
  tip.set = "tip";
  tip.vertices = 1;
  tip.total = Eigen::MatrixXd::Zero(2, 3);
  tip.total(1, 2) = 1 / std::sqrt(2.0);
  end.set = "end/of 50% cells";
  end.vertices = 2;
  end.total = Eigen::MatrixXd::Zero(2, 3);
  end.total.col(2).setConstant(0.5 / std::sqrt(2.0));
  end.has_surface = true;
  end.area = 0.25;
  end.pressure = Eigen::Vector2d(0.125, 0.0625);
  end.traction = Eigen::MatrixXd::Zero(2, 3);
  end.traction.col(2).setConstant(0.125);
  return {tip, end};
}

model::Provenance sample_provenance() {
  return {.program = "sample 1.0",
          .versions = {{"HDF5", "1.10.8"}, {"BLAS", "OpenBLAS 0.3.21"}},
          .options = {{"-mesh", "two masses"}, {"-modes", "2"}, {"-quiet", ""}},
          .ranks = 1};
}

model::Report sample_report() {
  return {.seconds = {{"assemble", 0.25}, {"modes", 1.5}},
          .figures = {{"eigensolver iterations", 3}, {"peak memory, bytes", 1048576}},
          .notes = {"the masses are points", "größer als nötig"},
          .mesh_errors = Eigen::VectorXd::LinSpaced(sample_modes().eigenvalues.size(), 0, 0.38)};
}

model::Model sample_model() {
  model::Model m;
  m.provenance = sample_provenance();
  auto& body = m.bodies.emplace_back();
  body.checksums = {"0123456789abcdef", "fedcba9876543210"};
  body.geometry = sample_geometry();
  body.basis = sample_basis();
  body.modes = sample_modes();
  body.inertia = sample_inertia();
  body.loads = sample_loads();
  body.report = sample_report();
  return m;
}

}  // namespace ritz::test
