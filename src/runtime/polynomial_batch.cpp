#include "ritz/runtime/polynomial_batch.hpp"

#include <algorithm>

#include "kernels.hpp"
#include "polynomial_point.hpp"
#include "ritz/base/simd.hpp"

namespace ritz::runtime {
namespace {

using Eigen::Index;

template <class Scalar>
using Lanes = Eigen::Map<Eigen::Matrix<Scalar, Eigen::Dynamic, static_cast<int>(lanes<Scalar>), Eigen::RowMajor>>;

}  // namespace

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
