#include "ritz/stages/linear_cells.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "ritz/base/shown.hpp"
#include "ritz/fem/element.hpp"
#include "ritz/fem/geometry.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/each_cell.hpp"
#include "ritz/stages/strain.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;

constexpr int most_modes = 6;
constexpr double highest_frequency = 4;  ///< relative to the first flexible one
constexpr double bending_gate = .1, any_gate = .25, few_layers = 2.6;

constexpr bool is_linear(fem::CellType type) { return !fem::shape(type).quadratic(); }

const fem::Material& material_of(const mesh::Mesh& mesh, const fem::Materials& materials, int cell) {
  return materials[static_cast<std::size_t>(mesh.cells.regions[static_cast<std::size_t>(cell)])];
}

/// Strains at vertices, a column a mode: xx yy zz in `normal`, xy yz zx in `shear`.
template <class Rows>
struct Strains {
  Rows normal, shear;
  Strain at(int vertex, Index mode) const {
    Strain e;
    e << normal.col(mode).template segment<3>(3 * vertex), shear.col(mode).template segment<3>(3 * vertex);
    return e;
  }
};

/// Adds volume times strain of one cell, as it is at each of its vertices.
void add_strains(const mesh::Mesh& mesh, const Cell& cell, const mesh::LocalRows& local,
                 Strains<mesh::VertexRows>& sums, Eigen::VectorXd& volumes) {
  const double volume = fem::volume(cell.type, cell.x);
  const fem::IntegrationPoints at_vertices(fem::element(cell.type).at_vertices, cell.x);
  for (int a = 0; a < cell.count(); ++a) {
    const int v = cell.vertex(a);
    if (v >= mesh.owned) continue;
    volumes[v] += volume;
    for (Index j = 0; j < local.cols(); ++j) {
      const Strain e = volume * strain(cell.gather(local, j), at_vertices.gradients(a));
      mesh::at_vertex(sums.normal.col(j), v) += e.head<3>();
      mesh::at_vertex(sums.shear.col(j), v) += e.tail<3>();
    }
  }
}

using Recovered = Strains<mesh::LocalRows>;

/// ε* over the cells of one octave of stiffness. *Collective*.
Recovered recover(const mesh::Mesh& mesh, const fem::Materials& materials, const std::vector<int>& cells,
                  const mesh::LocalRows& local) {
  Eigen::VectorXd volumes = Eigen::VectorXd::Zero(mesh.owned);
  const algebra::Tall zeros = algebra::Tall::Zero(mesh::components * mesh.owned, local.cols());
  Strains<mesh::VertexRows> sums{zeros, zeros};
  for (const int c : cells) add_strains(mesh, cell_of(mesh, materials, c), local, sums, volumes);
  for (int v = 0; v < mesh.owned; ++v) {
    if (volumes[v] <= 0) continue;
    mesh::at_vertex(sums.normal, v) /= volumes[v];
    mesh::at_vertex(sums.shear, v) /= volumes[v];
  }
  return {mesh::with_ghosts(mesh, sums.normal, 3), mesh::with_ghosts(mesh, sums.shear, 3)};
}

/// By mode: twice the energies of ε* − ε, of what varies of ε* within cells, and of its means over cells.
using ModeSums = Eigen::Array3Xd;

void add_errors(const Cell& cell, const mesh::LocalRows& local, const Recovered& recovered, ModeSums& sums) {
  const bool tetrahedron = cell.type == fem::CellType::tet4;
  // The few points of stiffness of other cells than hexahedra see nothing of ε* − ε.
  const auto& element = fem::element(cell.type);
  const auto& rule = cell.type == fem::CellType::hex8 ? element.rule : element.mass_rule;
  const fem::IntegrationPoints points(rule, cell.x);
  const fem::Matrix<6, 6> C = cell.material.at_rest().hooke();
  for (Index j = 0; j < local.cols(); ++j) {
    const fem::CellVectors u = cell.gather(local, j);
    fem::UpTo<6, fem::max_cell_vertices> corners(6, cell.count());
    for (int a = 0; a < cell.count(); ++a) corners.col(a) = recovered.at(cell.vertex(a), j);
    const Strain mean = corners.rowwise().mean();
    double volume = 0, varying = 0;
    for (int q = 0; q < points.count(); ++q) {
      const Eigen::Map<const Eigen::VectorXd> N(rule.values.data() + cell.count() * q, cell.count());
      const double weight = points.weight(q);
      const Strain smooth = corners.lazyProduct(N);
      volume += weight;
      varying += weight * twice_energy(C, smooth - mean);
      sums(0, j) += weight * twice_energy(C, smooth - strain(u, points.gradients(q)));
    }
    // A mean over a vertex's tetrahedra has lost as much of a strain that changes sign as makes this a fifth.
    sums(1, j) += (tetrahedron ? 5 : 1) * varying;
    sums(2, j) += volume * twice_energy(C, mean);
  }
}

/// The names of the linear cells in the mesh, "tet4, hex8".
std::string names_of(const mesh::Mesh& mesh) {
  std::string names;
  for (const auto type : fem::cell_types) {
    const auto first = mesh.cells.types.begin(), last = first + mesh.cells.owned;
    const bool here = is_linear(type) && std::find(first, last, type) != last;
    if (parallel::max(mesh.comm, static_cast<std::int32_t>(here)) != 0)
      names += (names.empty() ? "" : ", ") + std::string(fem::shape(type).name);
  }
  return names;
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

std::vector<LinearCellsError> linear_cells_errors(const Problem& problem, const Eigen::VectorXd& lambda,
                                                  mesh::VertexRef u) {
  const mesh::Mesh& mesh = problem.mesh;
  const auto& materials = problem.materials;
  std::map<int, std::vector<int>> cells;  // by octave of stiffness, in the file's order
  for (const auto& material : materials) cells[octave(material)];
  for (const int c : mesh.cells.file_order)
    if (is_linear(mesh.cells.types[static_cast<std::size_t>(c)]))
      cells[octave(material_of(mesh, materials, c))].push_back(c);
  const mesh::LocalRows local = mesh::with_ghosts(mesh, u, mesh::components);
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(3, u.cols());
  for (const auto& [key, alike] : cells) {
    const Recovered recovered = recover(mesh, materials, alike, local);
    ModeSums of_alike = ModeSums::Zero(3, u.cols());
    for (const int c : alike)
      if (c < mesh.cells.owned) add_errors(cell_of(mesh, materials, c), local, recovered, of_alike);
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

std::vector<std::string> linear_cells_warning(const Problem& problem, const ModesResult& modes) {
  const auto names = names_of(problem.mesh);
  const Index rigid = rigid_modes(modes).cols(), flexible = modes.vectors.cols() - rigid;
  if (names.empty() || flexible == 0) return {};
  const Eigen::VectorXd lambda = modes.modes.eigenvalues.tail(flexible);
  const auto low = std::count_if(lambda.begin(), lambda.begin() + std::min<Index>(most_modes, flexible),
                                 [&](double l) { return l <= highest_frequency * highest_frequency * lambda[0]; });
  const auto errors = linear_cells_errors(
      problem, lambda.head(low), mesh::to_vertices(problem.mesh, problem.dofs, flexible_modes(modes).leftCols(low)));
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
          ") are too stiff where a body bends or twists; use quadratic ones (tet10, hex20), or many more cells"};
}

}  // namespace ritz::stages
