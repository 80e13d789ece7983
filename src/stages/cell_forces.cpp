#include "ritz/stages/cell_forces.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "ritz/algebra/dense.hpp"
#include "ritz/fem/element.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;
using Tensor = fem::Matrix<3, 3>;

constexpr Index batch_points = 64;  ///< quadrature points that one product of matrices serves
constexpr Index tensor_size = 9;

/// Writes the displacement gradients of the columns of U at one point, as CellPoints has them.
void fill_gradients(const CellBasis& basis, const Cell& cell, const fem::GradientsRef& shape,
                    Eigen::Ref<Eigen::MatrixXd> gradients) {
  gradients.setZero();
  for (int a = 1; a < cell.count(); ++a)
    for (int i = 0; i < mesh::components; ++i) {
      const auto at = basis.rows.row(mesh::components * cell.vertex(a) + i),
                 first = basis.rows.row(mesh::components * cell.vertex(0) + i);
      for (int j = 0; j < mesh::components; ++j)
        gradients.col(mesh::components * j + i) += shape(a, j) * (at - first).transpose();
    }
}

/// Quadrature points of cells of one region, and their stresses at all states.
class PointBatch {
 public:
  PointBatch(const CellBasis& basis, const Eigen::MatrixXd& z)
      : basis_(basis),
        z_(z),
        gradients_(basis.size(), tensor_size * batch_points),
        tensors_(tensor_size * batch_points, z.cols()),
        force_(basis.size(), z.cols()) {}

  bool takes(int region, int points) const {
    return count_ == 0 || (region == region_ && count_ + points <= batch_points);
  }

  void add(const Cell& cell, const fem::IntegrationPoints& points) {
    region_ = cell.region;
    for (int q = 0; q < points.count(); ++q, ++count_) {
      fill_gradients(basis_, cell, points.gradients(q), gradients_.middleCols(tensor_size * count_, tensor_size));
      volumes_[static_cast<std::size_t>(count_)] = points.weight(q);
    }
  }

  /// Calls visit(state, G, volume, response) for all points and states, which may change the stress; then the force of
  /// points can be asked for.
  template <class Visit>
  void respond(Visit&& visit) {
    const auto& material = basis_.problem.materials[static_cast<std::size_t>(region_)];
    algebra::gemm('T', 1, gradients_.leftCols(tensor_size * count_), z_, 0, tensors_.topRows(tensor_size * count_));
    const auto n = static_cast<std::size_t>(count_);
    for (Index s = 0; s < z_.cols(); ++s) {
      for (std::size_t p = 0; p < n; ++p) displacement_gradients_[p] = tensor(static_cast<Index>(p), s);
      fem::respond(material, std::span(displacement_gradients_).first(n), std::span(responses_).first(n));
      for (std::size_t p = 0; p < n; ++p) {
        visit(s, displacement_gradients_[p], volumes_[p], responses_[p]);
        tensor(static_cast<Index>(p), s) = volumes_[p] * responses_[p].stress;
      }
    }
  }

  /// Of points first ... first + points - 1, at all states.
  const Eigen::MatrixXd& force(Index first, Index points) {
    algebra::gemm('N', 1, gradients_.middleCols(tensor_size * first, tensor_size * points),
                  tensors_.middleRows(tensor_size * first, tensor_size * points), 0, force_);
    return force_;
  }

  Index count() const { return count_; }
  int region() const { return region_; }
  void clear() { count_ = 0; }

 private:
  Eigen::Map<Tensor> tensor(Index point, Index state) {
    return Eigen::Map<Tensor>(tensors_.col(state).data() + tensor_size * point);
  }

  const CellBasis& basis_;
  const Eigen::MatrixXd& z_;
  int region_ = 0;
  Index count_ = 0;
  Eigen::MatrixXd gradients_, tensors_, force_;  ///< tensors_: displacement gradients, then volume times stress
  std::array<double, batch_points> volumes_;
  std::array<Tensor, batch_points> displacement_gradients_;
  std::array<fem::Response, batch_points> responses_;
};

/// Fills `batch` with the points of these cells, and calls use() whenever it is full or another region begins.
/// `added` is told the number of points of each cell.
template <class Added, class Use>
void each_batch(const CellBasis& basis, std::span<const int> cells, PointBatch& batch, Added&& added, Use&& use) {
  for (const int c : cells) {
    const Cell cell = cell_of(basis.problem.mesh, basis.problem.materials, c);
    const fem::IntegrationPoints points(cell.type, cell.x);
    if (!batch.takes(cell.region, points.count())) {
      use();
      batch.clear();
    }
    batch.add(cell, points);
    added(points.count());
  }
  if (batch.count() > 0) use();
}

/// A sum whose rounding error does not grow with the number of terms [Knuth's two-sum].
class CompensatedSum {
 public:
  CompensatedSum(Index rows, Index columns)
      : sum_(Eigen::ArrayXXd::Zero(rows, columns)), error_(Eigen::ArrayXXd::Zero(rows, columns)) {}

  void add(const Eigen::MatrixXd& term) {
    for (Index i = 0; i < term.size(); ++i) {
      double& s = sum_.data()[i];
      const double x = term.data()[i], next = s + x, part = next - s;
      error_.data()[i] += (s - (next - part)) + (x - part);
      s = next;
    }
  }
  Eigen::MatrixXd total() const { return sum_ + error_; }

 private:
  Eigen::ArrayXXd sum_, error_;
};

}  // namespace

CellBasis cell_basis(const Problem& problem, mesh::VertexRef u) {
  return {problem, mesh::with_ghosts(problem.mesh, u, mesh::components)};
}

CellPoints cell_points(const CellBasis& basis, int number) {
  const Cell cell = cell_of(basis.problem.mesh, basis.problem.materials, number);
  const fem::IntegrationPoints points(cell.type, cell.x);
  CellPoints result{Eigen::MatrixXd(basis.size(), tensor_size * points.count()), Eigen::VectorXd(points.count())};
  for (int q = 0; q < points.count(); ++q) {
    fill_gradients(basis, cell, points.gradients(q), result.gradients.middleCols(tensor_size * q, tensor_size));
    result.volumes[q] = points.weight(q);
  }
  return result;
}

ProjectedForces projected_forces(const CellBasis& basis, const Eigen::MatrixXd& z) {
  const mesh::Mesh& mesh = basis.problem.mesh;
  std::vector<int> cells(static_cast<std::size_t>(mesh.cells.owned));
  std::iota(cells.begin(), cells.end(), 0);
  std::ranges::stable_sort(cells, {}, [&](int c) { return mesh.cells.regions[static_cast<std::size_t>(c)]; });
  PointBatch batch(basis, z);
  CompensatedSum forces(basis.size(), z.cols());
  Eigen::VectorXd energies = Eigen::VectorXd::Zero(z.cols());
  Eigen::VectorXd squeezed = Eigen::VectorXd::Constant(z.cols(), std::numeric_limits<double>::infinity());
  each_batch(
      basis, cells, batch, [](int) {},
      [&] {
        batch.respond([&](Index s, const Tensor& G, double volume, const fem::Response& response) {
          energies[s] += volume * response.energy;
          const double J = std::isfinite(response.energy) ? (Tensor::Identity() + G).determinant() : 0;
          squeezed[s] = std::min(squeezed[s], J);
        });
        forces.add(batch.force(0, batch.count()));
      });
  Eigen::MatrixXd total = forces.total();
  parallel::sum_in_place(mesh.comm, total);
  parallel::sum_in_place(mesh.comm, energies);
  MPI_Allreduce(MPI_IN_PLACE, squeezed.data(), static_cast<int>(squeezed.size()), MPI_DOUBLE, MPI_MIN, mesh.comm);
  return {std::move(total), std::move(energies), std::move(squeezed)};
}

void each_cell_force(const CellBasis& basis, model::Integrand integrand, std::span<const int> cells,
                     const Eigen::MatrixXd& z, const TakeForce& take) {
  PointBatch batch(basis, z);
  std::vector<int> points;  // of the cells in the batch
  Index place = 0;
  each_batch(
      basis, cells, batch, [&](int count) { points.push_back(count); },
      [&] {
        if (integrand == model::Integrand::beyond_polynomial) {
          const auto& material = basis.problem.materials[static_cast<std::size_t>(batch.region())];
          const auto rest = material.at_rest();
          const fem::Lame lame{rest.lambda, rest.mu};
          batch.respond([&](Index, const Tensor& G, double, fem::Response& response) {
            response.stress -= fem::stvk_response(lame, G).stress;
          });
        } else {
          batch.respond([](Index, const Tensor&, double, const fem::Response&) {});
        }
        Index first = 0;
        for (const int count : points) {
          take(place++, batch.force(first, count));
          first += count;
        }
        points.clear();
      });
}

}  // namespace ritz::stages
