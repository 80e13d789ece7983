#include "ritz/stages/training_poses.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "ritz/algebra/multivector.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/random.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/runtime/statics.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;

constexpr double least_volume = .2;  ///< det F of an admitted pose
constexpr int most_halvings = 20;
constexpr Index columns_at_once = 16;  ///< of full displacements

/// Number `index` of a sequence of normally distributed numbers [Box and Muller 1958].
double normal(std::uint64_t stream, std::uint64_t index) {
  const double radius = (1 - uniform(stream, 2 * index)) / 2, angle = std::numbers::pi * uniform(stream, 2 * index + 1);
  return std::sqrt(-2 * std::log(radius)) * std::cos(angle);
}

/// The largest displacement of a vertex for each column of p. *Collective*.
Eigen::VectorXd largest_displacements(const PoseSource& source, const Eigen::MatrixXd& p) {
  Eigen::VectorXd largest(p.cols());
  for (Index first = 0; first < p.cols(); first += columns_at_once) {
    const Index count = std::min(columns_at_once, p.cols() - first);
    const algebra::Tall displaced = algebra::combine(source.u, p.middleCols(first, count));
    for (Index s = 0; s < count; ++s) {
      double most = 0;
      for (Index v = 0; v < displaced.rows() / mesh::components; ++v)
        most = std::max(most, mesh::at_vertex(displaced.col(s), v).norm());
      largest[first + s] = most;
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, largest.data(), static_cast<int>(largest.size()), MPI_DOUBLE, MPI_MAX,
                source.basis.problem.mesh.comm);
  return largest;
}

/// p of all draws, at full size. *Collective*.
Eigen::MatrixXd random_directions(const PoseSource& source, const std::vector<PoseDraw>& draws) {
  const Eigen::VectorXd deviations = source.stiffness.minCoeff() * source.stiffness.cwiseInverse();
  Index total = 0, column = 0;
  for (const auto& draw : draws) total += draw.count;
  Eigen::MatrixXd p(source.stiffness.size(), total);
  for (const auto& draw : draws)
    for (int k = 0; k < draw.count; ++k, ++column)
      for (Index i = 0; i < p.rows(); ++i)
        p(i, column) = deviations[i] * normal(draw.stream, static_cast<std::uint64_t>(k * p.rows() + i));
  const double size = source.amplitude * mesh::bounding_box(source.basis.problem.mesh).size().maxCoeff();
  return p * (size * largest_displacements(source, p).cwiseInverse()).asDiagonal();
}

/// Makes poses of p by the polynomial.
class PoseMaker {
 public:
  explicit PoseMaker(const PoseSource& source)
      : stiffness_(source.stiffness),
        model_(runtime::make_model<double>(source.polynomial, {})),
        evaluation_(runtime::make_evaluation<double>(model_.force)),
        workspace_(runtime::make_static_workspace<double>(model_)) {}

  /// Nothing where no equilibrium is found.
  std::optional<Eigen::VectorXd> make(PoseKind kind, const Eigen::VectorXd& p) {
    return kind == PoseKind::lift ? lift(p) : equilibrium(p);
  }

 private:
  /// Λp and the cubic terms of the force are odd in p: B_ijk p_i p_j is what f̃(p) and f̃(−p) do not cancel.
  Eigen::VectorXd lift(const Eigen::VectorXd& p) {
    runtime::evaluate<double>(model_.force, p, evaluation_);
    Eigen::VectorXd even = evaluation_.force;
    runtime::evaluate<double>(model_.force, Eigen::VectorXd(-p), evaluation_);
    even += evaluation_.force;
    return p - (even.array() / (2 * stiffness_.array())).matrix();
  }

  std::optional<Eigen::VectorXd> equilibrium(const Eigen::VectorXd& p) {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(p.size()), load = stiffness_.cwiseProduct(p);
    runtime::Vector<double> z = none;
    if (runtime::solve_static<double>(model_, {none, load}, z, workspace_).failure) return std::nullopt;
    return z;
  }

  const Eigen::VectorXd& stiffness_;
  runtime::Model<double> model_;
  runtime::Evaluation<double> evaluation_;
  runtime::StaticWorkspace<double> workspace_;
};

/// What becomes of p and of its pose: halved until there is one.
Eigen::VectorXd made(PoseMaker& maker, PoseKind kind, Eigen::Ref<Eigen::VectorXd> p) {
  for (int halvings = 0; halvings <= most_halvings; ++halvings, p /= 2)
    if (const auto z = maker.make(kind, p)) return *z;
  throw NumericalError(
      "no pose to train the cubature on was found: the reduced model has no equilibrium under small loads");
}

}  // namespace

Poses training_poses(const PoseSource& source, const std::vector<PoseDraw>& draws) {
  Eigen::MatrixXd p = random_directions(source, draws);
  std::vector<PoseKind> kinds;
  for (const auto& draw : draws)
    for (int k = 0; k < draw.count; ++k) {
      p.col(static_cast<Index>(kinds.size())) *= static_cast<double>(k + 1) / draw.count;
      kinds.push_back(draw.kind);
    }
  const Index r = p.rows(), total = p.cols();
  Poses poses{Eigen::MatrixXd(r, total), {Eigen::MatrixXd(r, total), Eigen::VectorXd(total), Eigen::VectorXd(total)}};
  std::vector<Index> pending(static_cast<std::size_t>(total));
  std::iota(pending.begin(), pending.end(), Index{0});
  PoseMaker maker(source);
  for (int halvings = 0; !pending.empty(); ++halvings) {
    if (halvings > most_halvings)
      throw NumericalError(
          "no pose to train the cubature on was found: even small displacements squeeze some cell to a "
          "fifth of its volume, or are not admitted by its law");
    for (const Index s : pending) poses.z.col(s) = made(maker, kinds[static_cast<std::size_t>(s)], p.col(s));
    const auto exact = projected_forces(source.basis, poses.z(Eigen::all, pending));
    std::vector<Index> rejected;
    for (std::size_t i = 0; i < pending.size(); ++i) {
      const Index s = pending[i], from = static_cast<Index>(i);
      poses.exact.forces.col(s) = exact.forces.col(from);
      poses.exact.energies[s] = exact.energies[from];
      poses.exact.squeezed[s] = exact.squeezed[from];
      if (exact.squeezed[from] >= least_volume) continue;
      p.col(s) /= 2;
      rejected.push_back(s);
    }
    pending = std::move(rejected);
  }
  return poses;
}

}  // namespace ritz::stages
