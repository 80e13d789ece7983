// Sixteen bodies of one model, each pulled by another force: prints the largest displacement that each reaches, m.
//   sixteen MODEL.h5 VERTEX
// What is constant is read and laid out once; an instance is r numbers of state and the room for a step.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "ritz/format/parts.hpp"
#include "ritz/world/body.hpp"
#include "ritz/world/loads.hpp"

int main(int argc, char** argv) try {
  if (argc != 3) return 2;
  const ritz::format::ModelReader file(argv[1]);
  const auto body = ritz::format::read_body(file, file.first_body());
  using namespace ritz::world;
  const auto model = share(make_model<double>(body, {.alpha = 0.5}));
  const Eigen::MatrixXd at_vertex = unit_force(body, std::atoll(argv[2]));
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(model->size());

  const std::vector<Instance<double>> start(16, make_instance<double>(model, choose({}, *model), 0.01, none));
  auto instances = start;
  std::vector<double> largest(instances.size(), 0.0);
  for (int n = 0; n < 100; ++n)
    for (std::size_t i = 0; i < instances.size(); ++i) {
      const Eigen::VectorXd pull = at_vertex * Eigen::Vector3d(0, 0, -1.0 - static_cast<double>(i));
      if (step<double>(instances[i], pull).status != ritz::runtime::Status::done) return 1;
      largest[i] = std::max(largest[i], (at_vertex.transpose() * instances[i].state.z()).norm());
    }
  for (std::size_t i = 0; i < largest.size(); ++i) std::printf("%zu N: %.9g m\n", i + 1, largest[i]);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
