#include "ritz/stages/linear_cells.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "ritz/base/shown.hpp"
#include "ritz/fem/dispatch.hpp"
#include "ritz/fem/geometry.hpp"
#include "ritz/mesh/halo.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/vertex_graph.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;

constexpr int most_modes = 6;
constexpr double highest_frequency = 4;  ///< relative to the first flexible one
constexpr double bending_gate = .1, any_gate = .25, few_layers = 2.6;

using Strain = fem::Vector<6>;  // xx yy zz, then xy yz zx of the tensor

double twice_energy(const fem::StVK& m, const Strain& e) {
  const double trace = e.head<3>().sum();
  return m.lambda() * trace * trace + 2 * m.mu() * (e.head<3>().squaredNorm() + 2 * e.tail<3>().squaredNorm());
}

template <class E>
Strain strain(const fem::Coordinates<E>& u, const fem::Matrix<E::vertices, 3>& gradients) {
  const fem::Matrix<3, 3> G = fem::relative<E>(u) * gradients;
  Strain e;
  e << G(0, 0), G(1, 1), G(2, 2), (G(0, 1) + G(1, 0)) / 2, (G(1, 2) + G(2, 1)) / 2, (G(2, 0) + G(0, 2)) / 2;
  return e;
}

template <class E>
fem::Coordinates<E> moved(const mesh::Mesh& mesh, int cell, const Eigen::Ref<const Eigen::VectorXd>& local) {
  const auto vertices = mesh.cells.of(cell);
  fem::Coordinates<E> u;
  for (int a = 0; a < E::vertices; ++a) u.col(a) = local.segment<3>(3 * vertices[static_cast<std::size_t>(a)]);
  return u;
}

bool is_linear(fem::CellType type) { return type != fem::CellType::tet10; }

const fem::StVK& material_of(const mesh::Mesh& mesh, const std::vector<fem::StVK>& materials, int cell) {
  return materials[static_cast<std::size_t>(mesh.cells.regions[static_cast<std::size_t>(cell)])];
}

int octave(const fem::StVK& material) { return std::ilogb(material.young); }

/// Strains at local vertices, k columns a mode: xx yy zz in `normal`, xy yz zx in `shear`.
struct Recovered {
  petsc::Tall normal, shear;
  Strain at(int vertex, Index mode) const {
    Strain e;
    e << normal.col(mode).segment<3>(3 * vertex), shear.col(mode).segment<3>(3 * vertex);
    return e;
  }
};

/// Adds volume times strain of one cell, as it is at each of its vertices.
template <class E>
void add_strains(const mesh::Mesh& mesh, int cell, const petsc::Tall& local, Recovered& sums,
                 Eigen::VectorXd& volumes) {
  const fem::Coordinates<E> x = fem::relative<E>(fem::Coordinates<E>(mesh.corners(cell)));
  const double volume = fem::volume<E>(x);
  const auto vertices = mesh.cells.of(cell);
  for (int a = 0; a < E::vertices; ++a) {
    const int v = vertices[static_cast<std::size_t>(a)];
    if (v >= mesh.owned) continue;
    volumes[v] += volume;
    const auto gradients = fem::physical_gradients<E>(x, {E::reference[static_cast<std::size_t>(a)], 1}).gradients;
    for (Index j = 0; j < local.cols(); ++j) {
      const Strain e = volume * strain<E>(moved<E>(mesh, cell, local.col(j)), gradients);
      sums.normal.col(j).segment<3>(3 * v) += e.head<3>();
      sums.shear.col(j).segment<3>(3 * v) += e.tail<3>();
    }
  }
}

template <class Work>
void visit_linear(const mesh::Mesh& mesh, int cell, Work work) {
  if (mesh.cells.types[static_cast<std::size_t>(cell)] == fem::CellType::hex8) work(fem::Hex8{});
  else work(fem::Tet4{});
}

/// ε* over the cells of one octave of stiffness. *Collective*.
Recovered recover(const mesh::Mesh& mesh, const std::vector<int>& cells, const petsc::Tall& local) {
  Eigen::VectorXd volumes = Eigen::VectorXd::Zero(mesh.owned);
  Recovered sums{petsc::Tall::Zero(3 * mesh.owned, local.cols()), petsc::Tall::Zero(3 * mesh.owned, local.cols())};
  for (const int c : cells) visit_linear(mesh, c, [&]<class E>(E) { add_strains<E>(mesh, c, local, sums, volumes); });
  for (int v = 0; v < mesh.owned; ++v) {
    if (volumes[v] <= 0) continue;
    sums.normal.middleRows<3>(3 * v) /= volumes[v];
    sums.shear.middleRows<3>(3 * v) /= volumes[v];
  }
  return {mesh::with_ghosts(mesh, sums.normal), mesh::with_ghosts(mesh, sums.shear)};
}

/// By mode: twice the energies of ε* − ε, of what varies of ε* within cells, and of its means over cells.
using ModeSums = Eigen::Array3Xd;

template <class E>
void add_errors(const mesh::Mesh& mesh, int cell, const fem::StVK& material, const petsc::Tall& local,
                const Recovered& recovered, ModeSums& sums) {
  constexpr bool tetrahedron = E::type == fem::CellType::tet4;
  constexpr auto& rule = []() -> auto& {
    if constexpr (tetrahedron) return E::mass_rule;  // its one point of stiffness sees nothing of ε* − ε
    else return E::rule;
  }
  ();
  const fem::Coordinates<E> x = fem::relative<E>(fem::Coordinates<E>(mesh.corners(cell)));
  const auto vertices = mesh.cells.of(cell);
  for (Index j = 0; j < local.cols(); ++j) {
    const fem::Coordinates<E> u = moved<E>(mesh, cell, local.col(j));
    fem::Matrix<6, E::vertices> corners;
    for (int a = 0; a < E::vertices; ++a) corners.col(a) = recovered.at(vertices[static_cast<std::size_t>(a)], j);
    const Strain mean = corners.rowwise().mean();
    double volume = 0, varying = 0;
    for (const auto& point : rule) {
      const auto [gradients, weight] = fem::physical_gradients<E>(x, point);
      const Strain smooth = corners * E::shape(point.xi);
      volume += weight;
      varying += weight * twice_energy(material, smooth - mean);
      sums(0, j) += weight * twice_energy(material, smooth - strain<E>(u, gradients));
    }
    // A mean over a vertex's tetrahedra has lost as much of a strain that changes sign as makes this a fifth.
    sums(1, j) += (tetrahedron ? 5 : 1) * varying;
    sums(2, j) += volume * twice_energy(material, mean);
  }
}

std::string names_of(const mesh::Mesh& mesh) {
  std::int32_t tet4 = 0, hex8 = 0;
  for (int c = 0; c < mesh.cells.owned; ++c) {
    const auto type = mesh.cells.types[static_cast<std::size_t>(c)];
    tet4 |= type == fem::CellType::tet4;
    hex8 |= type == fem::CellType::hex8;
  }
  tet4 = parallel::max(mesh.comm, tet4);
  hex8 = parallel::max(mesh.comm, hex8);
  return tet4 && hex8 ? "tet4, hex8" : tet4 ? "tet4" : hex8 ? "hex8" : "";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " and ") + words[i];
  return text;
}

/// "83 % or more": large errors are estimated too low.
std::string percent(double error) { return shown(std::round(100 * error)) + (error > .5 ? " % or more" : " %"); }

}  // namespace

std::vector<LinearCellsError> linear_cells_errors(const mesh::Mesh& mesh, const std::vector<fem::StVK>& materials,
                                                  const Eigen::VectorXd& lambda, const petsc::ConstTallRef& u) {
  std::map<int, std::vector<int>> cells;  // by octave of stiffness, in the file's order
  for (const auto& material : materials) cells[octave(material)];
  for (const int c : file_order(mesh.cells))
    if (is_linear(mesh.cells.types[static_cast<std::size_t>(c)]))
      cells[octave(material_of(mesh, materials, c))].push_back(c);
  const petsc::Tall local = mesh::with_ghosts(mesh, u);
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(3, u.cols());
  for (const auto& [key, alike] : cells) {
    const Recovered recovered = recover(mesh, alike, local);
    ModeSums of_alike = ModeSums::Zero(3, u.cols());
    for (const int c : alike)
      if (c < mesh.cells.owned)
        visit_linear(mesh, c, [&]<class E>(E) {
          add_errors<E>(mesh, c, material_of(mesh, materials, c), local, recovered, of_alike);
        });
    sums += of_alike.matrix();
  }
  parallel::sum_in_place(mesh.comm, sums);
  std::vector<LinearCellsError> errors;
  for (Index j = 0; j < u.cols(); ++j) {
    const double share = std::min(sums(0, j) / lambda[j], .99), varying = sums(1, j), mean = sums(2, j);
    errors.push_back({1 / std::sqrt(1 - share) - 1, varying > 0 ? std::sqrt((varying + mean) / varying) : 1e9});
  }
  return errors;
}

std::vector<std::string> linear_cells_warning(const mesh::Mesh& mesh, const mesh::Dofs& dofs,
                                              const std::vector<fem::StVK>& materials, const ModesResult& modes) {
  const auto names = names_of(mesh);
  const Index rigid = rigid_modes(modes).cols(), flexible = modes.vectors.cols() - rigid;
  if (names.empty() || flexible == 0) return {};
  const Eigen::VectorXd lambda = modes.modes.eigenvalues.tail(flexible);
  const auto low = std::count_if(lambda.begin(), lambda.begin() + std::min<Index>(most_modes, flexible),
                                 [&](double l) { return l <= highest_frequency * highest_frequency * lambda[0]; });
  const auto errors = linear_cells_errors(mesh, materials, lambda.head(low),
                                          mesh::to_vertices(mesh, dofs, flexible_modes(modes).leftCols(low)));
  std::vector<std::string> numbers, sizes;
  for (Index j = 0; j < low; ++j) {
    const auto& [frequency, layers] = errors[static_cast<std::size_t>(j)];
    if (frequency < (layers < few_layers ? bending_gate : any_gate)) continue;
    numbers.push_back(std::to_string(rigid + j + 1));
    sizes.push_back(percent(frequency));
  }
  if (numbers.empty()) return {};
  return {std::string(numbers.size() == 1 ? "mode " : "modes ") + joined(numbers) + " come" +
          (numbers.size() == 1 ? "s" : "") + " out too high, by an estimated " + joined(sizes) +
          " of the frequency: linear cells (" + names +
          ") are too stiff where a body bends or twists; use quadratic ones (tet10), or many more cells"};
}

}  // namespace ritz::stages
