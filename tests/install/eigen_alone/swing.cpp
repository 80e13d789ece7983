// A body as values, without a file: 1 kg on a spring of 4 N/m, upon which 4 N act from the start.
#include <cstdio>

#include "ritz/world/body.hpp"
#include "ritz/world/loads.hpp"

int main() {
  ritz::model::Body body;
  body.geometry.full_vertices = 1;
  body.geometry.points = ritz::model::Points::Zero(1, 3);
  body.geometry.vertex_ids = {7};
  body.basis.U = ritz::model::RowMatrix::Zero(3, 1);
  body.basis.U(2, 0) = 1;
  auto& modes = body.modes.emplace();
  modes.eigenvalues = Eigen::VectorXd::Constant(1, 4);
  modes.kinds = {ritz::model::ModeKind::flexible};

  using namespace ritz::world;
  const auto model = share(make_model<double>(body));
  const Eigen::VectorXd load = unit_force(body, 7) * Eigen::Vector3d(0, 0, 4);
  auto instance = make_instance<double>(model, choose({}, *model), 0.01, load);
  for (int n = 0; n < 100; ++n) step<double>(instance, load);
  std::printf("%.15g\n", instance.state.z()(0));
}
