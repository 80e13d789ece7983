#include "ritz/mesh/halo.hpp"

#include <algorithm>

#include "ritz/parallel/comm.hpp"

namespace ritz::mesh {

petsc::Tall with_ghosts(const Mesh& mesh, const petsc::ConstTallRef& u) {
  const auto firsts = parallel::gather_all(mesh.comm, std::vector<Index>{mesh.first});
  const auto owner = [&](Index global) {
    return static_cast<std::size_t>(std::upper_bound(firsts.begin(), firsts.end(), global) - firsts.begin() - 1);
  };
  std::vector<std::vector<Index>> asked(firsts.size());
  for (auto v = static_cast<std::size_t>(mesh.owned); v < mesh.global.size(); ++v)
    asked[owner(mesh.global[v])].push_back(mesh.global[v]);
  const auto wanted = parallel::exchange(mesh.comm, asked);

  std::vector<std::vector<double>> answers(wanted.size());
  for (std::size_t p = 0; p < wanted.size(); ++p)
    for (const Index global : wanted[p])
      for (Eigen::Index j = 0; j < u.cols(); ++j)
        for (int c = 0; c < 3; ++c) answers[p].push_back(u(3 * (global - mesh.first) + c, j));
  const auto received = parallel::exchange(mesh.comm, answers);

  petsc::Tall local(3 * mesh.local_vertices(), u.cols());
  local.topRows(u.rows()) = u;
  std::vector<const double*> next;
  for (const auto& list : received) next.push_back(list.data());
  for (auto v = static_cast<std::size_t>(mesh.owned); v < mesh.global.size(); ++v) {
    const double*& values = next[owner(mesh.global[v])];
    for (Eigen::Index j = 0; j < u.cols(); ++j, values += 3)
      local.col(j).segment<3>(3 * static_cast<Eigen::Index>(v)) = Eigen::Map<const Eigen::Vector3d>(values);
  }
  return local;
}

}  // namespace ritz::mesh
