// Loads a model and lets it ring after a blow: prints u_z of its second vertex after one second.
#include <cstdio>

#include "ritz/format/parts.hpp"
#include "ritz/runtime/reconstruction.hpp"
#include "ritz/runtime/step.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const ritz::format::ModelReader file(argv[1]);
  const auto modes = ritz::format::read_modes(file);
  const auto basis = ritz::format::read_basis(file);

  using namespace ritz::runtime;
  const auto model = make_model(*modes, {});
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.size());
  const Eigen::VectorXd blow = basis.U.row(5).transpose();  // 1 kg m/s upon vertex 1, along z
  auto state = make_state<double>(model, exact(), rest, blow, rest);
  auto workspace = make_workspace<double>(model, exact(), 0.01);
  for (int n = 0; n < 100; ++n) step<double>(model, state, {rest, rest}, 0.01, workspace);

  ritz::model::Points u(basis.U.rows() / 3, 3);
  reconstruct(basis, state.z(), u);
  std::printf("%.15g\n", u(1, 2));
}
