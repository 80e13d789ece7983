// Pulls one vertex of a reduced model down for a second, lets go, and prints where it goes: time, u_x, u_y, u_z.
//   push MODEL.h5 VERTEX      (by the mesh file's own number)
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

  // The constant part, which any number of instances may share, and one of them, at rest.
  const auto model = share(make_model<double>(body, {.alpha = 0.5}));
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(model->size());
  auto instance = make_instance<double>(model, choose({}, *model), 0.01, none);

  // r x 3: what a unit force along x, y, z at the vertex does to the reduced coordinates. Its transpose reads the
  // vertex.
  const Eigen::MatrixXd at_vertex = unit_force(body, std::atoll(argv[2]));
  const Eigen::VectorXd pull = at_vertex * Eigen::Vector3d(0, 0, -1);  // 1 N

  for (int n = 1; n <= 200; ++n) {
    if (step<double>(instance, n <= 100 ? pull : none).status != ritz::runtime::Status::done) return 1;
    const Eigen::Vector3d u = at_vertex.transpose() * instance.state.z();
    std::printf("%.2f %.9g %.9g %.9g\n", 0.01 * n, u.x(), u.y(), u.z());
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
