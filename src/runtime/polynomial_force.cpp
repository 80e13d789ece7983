#include "ritz/runtime/polynomial_force.hpp"

#include <algorithm>

#include "kernels.hpp"

namespace ritz::runtime {
namespace {

using Eigen::Index;

/// An aligned array of `size` zeros.
template <class Scalar>
AlignedVector<Scalar> zeros(Eigen::Index size) {
  return AlignedVector<Scalar>(static_cast<std::size_t>(size), Scalar(0));
}

/// Energy, force and tangent with the quadratic part A added, from the sums of a pass: half of H3 + H4, the force and
/// the energy without A.
template <class Scalar>
void finish(const PolynomialForce<Scalar>& forces, const VectorRef<Scalar>& z, const Vector<Scalar>& sums,
            Scalar& energy, Eigen::Ref<Vector<std::type_identity_t<Scalar>>> force, Matrix<Scalar>& tangent) {
  const Eigen::Index r = forces.r;
  force.noalias() = forces.linear * z;
  energy = z.dot(force) / 2 + sums[sums.size() - 1];
  force += sums.segment(sums.size() - 1 - r, r);
  for (Eigen::Index i = 0, at = 0, n = r; i < r; ++i, at += n--) {
    tangent.col(i).tail(n) = forces.linear.col(i).tail(n) + sums.segment(at, n);
    tangent(i, i) += sums[at];
    tangent.row(i).tail(n) = tangent.col(i).tail(n);
  }
}

template <class Scalar>
using Lanes = Eigen::Map<Eigen::Matrix<Scalar, Eigen::Dynamic, static_cast<int>(lanes<Scalar>), Eigen::RowMajor>>;

}  // namespace

template <class Scalar>
Evaluation<Scalar> make_evaluation(const PolynomialForce<Scalar>& forces) {
  constexpr Index width = lanes<Scalar>;
  const Index r = forces.r;
  return {.force = Vector<Scalar>::Zero(r),
          .tangent = Matrix<Scalar>::Zero(r, r),
          .sums = Vector<Scalar>::Zero(result_size(r)),
          .point = zeros<Scalar>(r + width),
          .room = zeros<Scalar>(room_at_point(r) * width),
          .result = zeros<Scalar>(result_size(r) * width),
          .inner = {}};
}

template <class Scalar>
void evaluate(const PolynomialForce<Scalar>& forces, const VectorRef<Scalar>& z, Evaluation<Scalar>& evaluation) {
  auto& [energy, force, tangent, sums, point, room, result, inner] = evaluation;
  std::ranges::copy(z, point.begin());
  differentiate_at_point(forces.r, forces.cubic.data(), forces.quartic.data(), point.data(), room.data(),
                         result.data());
  using Registers = Eigen::Matrix<Scalar, static_cast<int>(lanes<Scalar>), Eigen::Dynamic>;
  sums = Eigen::Map<const Registers, Eigen::Aligned32>(result.data(), lanes<Scalar>, sums.size()).colwise().sum();
  finish<Scalar>(forces, z, sums, energy, force, tangent);
}

template Evaluation<double> make_evaluation(const PolynomialForce<double>&);
template Evaluation<float> make_evaluation(const PolynomialForce<float>&);
template void evaluate(const PolynomialForce<double>&, const VectorRef<double>&, Evaluation<double>&);
template void evaluate(const PolynomialForce<float>&, const VectorRef<float>&, Evaluation<float>&);

template <class Scalar>
BatchEvaluation<Scalar> make_batch_evaluation(const PolynomialForce<Scalar>& forces, Index instances) {
  constexpr Index width = lanes<Scalar>;
  const Index r = forces.r;
  return {.energy = Vector<Scalar>::Zero(instances),
          .force = Matrix<Scalar>::Zero(r, instances),
          .tangents = Matrix<Scalar>::Zero(r, r * instances),
          .tangent = Matrix<Scalar>::Zero(r, r),
          .sums = Vector<Scalar>::Zero(result_size(r)),
          .points = zeros<Scalar>((r + 1) * width),
          .room = zeros<Scalar>(room_in_lanes<Scalar>(r) * width),
          .result = zeros<Scalar>(result_size(r) * width)};
}

template <class Scalar>
void evaluate_batch(const PolynomialForce<Scalar>& forces,
                    const Eigen::Ref<const Matrix<std::type_identity_t<Scalar>>>& z,
                    BatchEvaluation<Scalar>& evaluation) {
  auto& [energy, force, tangents, tangent, sums, points, room, result] = evaluation;
  const Index r = forces.r;
  Lanes<Scalar> lane_points(points.data(), r, lanes<Scalar>);
  const Lanes<Scalar> lane_sums(result.data(), sums.size(), lanes<Scalar>);
  for (Index first = 0; first < z.cols(); first += lanes<Scalar>) {
    const Index count = std::min<Index>(lanes<Scalar>, z.cols() - first);
    for (Index lane = 0; lane < lanes<Scalar>; ++lane)  // the last lanes repeat an instance where there are none
      lane_points.col(lane) = z.col(first + std::min(lane, count - 1));
    differentiate_in_lanes(r, forces.cubic.data(), forces.quartic.data(), points.data(), room.data(), result.data());
    for (Index lane = 0; lane < count; ++lane) {
      const Index instance = first + lane;
      sums = lane_sums.col(lane);
      finish<Scalar>(forces, z.col(instance), sums, energy[instance], force.col(instance), tangent);
      tangents.middleCols(instance * r, r) = tangent;
    }
  }
}

template BatchEvaluation<double> make_batch_evaluation(const PolynomialForce<double>&, Index);
template BatchEvaluation<float> make_batch_evaluation(const PolynomialForce<float>&, Index);
template void evaluate_batch(const PolynomialForce<double>&, const Eigen::Ref<const Matrix<double>>&,
                             BatchEvaluation<double>&);
template void evaluate_batch(const PolynomialForce<float>&, const Eigen::Ref<const Matrix<float>>&,
                             BatchEvaluation<float>&);

}  // namespace ritz::runtime
