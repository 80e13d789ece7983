#include "ritz/runtime/forces_batch.hpp"

#include <algorithm>

#include "forces_point.hpp"
#include "kernels.hpp"
#include "simd.hpp"

namespace ritz::runtime {
namespace {

using Eigen::Index;

template <class Scalar>
using Lanes = Eigen::Map<Eigen::Matrix<Scalar, Eigen::Dynamic, static_cast<int>(lanes<Scalar>), Eigen::RowMajor>>;

/// What is left to do for one instance once its H4 is known.
template <class Scalar>
void finish_instance(const Forces<Scalar>& forces, Index instance, BatchEvaluation<Scalar>& result) {
  const Index r = forces.r;
  std::ranges::fill(result.h3, Scalar(0));
  multiply_columns(forces.pairs, r, forces.cubic.data(), result.point.data(), result.h3.data());
  result.tangent.setZero();
  result.energy[instance] = energy_of(forces, result.products, result.h3, result.h4);
  auto to = result.force.col(instance);
  to.setZero();
  add_point(forces, result.point.data(), result.h3.data(), result.h4.data(), Scalar(1), Scalar(1), to, result.tangent);
  mirror(result.tangent);
  result.tangents.middleCols(instance * r, r) = result.tangent;
}

}  // namespace

template <class Scalar>
BatchEvaluation<Scalar> make_batch_evaluation(const Forces<Scalar>& forces, Index instances) {
  const Index r = forces.r, wide = forces.pairs * lanes<Scalar>;
  return {.energy = Vector<Scalar>::Zero(instances),
          .force = Matrix<Scalar>::Zero(r, instances),
          .tangents = Matrix<Scalar>::Zero(r, r * instances),
          .point = Vector<Scalar>::Zero(r),
          .tangent = Matrix<Scalar>::Zero(r, r),
          .products = zeros<Scalar>(forces.pairs),
          .h3 = zeros<Scalar>(forces.pairs),
          .h4 = zeros<Scalar>(forces.pairs),
          .lane_products = zeros<Scalar>(wide),
          .lane_h4 = zeros<Scalar>(wide)};
}

template <class Scalar>
void evaluate_batch(const Forces<Scalar>& forces, const Eigen::Ref<const Matrix<std::type_identity_t<Scalar>>>& z,
                    BatchEvaluation<Scalar>& result) {
  const Lanes<Scalar> products(result.lane_products.data(), forces.pairs, lanes<Scalar>);
  const Lanes<Scalar> h4(result.lane_h4.data(), forces.pairs, lanes<Scalar>);
  Lanes<Scalar> to(result.lane_products.data(), forces.pairs, lanes<Scalar>);
  Eigen::Map<Vector<Scalar>> own_products(result.products.data(), forces.pairs), own_h4(result.h4.data(), forces.pairs);
  for (Index first = 0; first < z.cols(); first += lanes<Scalar>) {
    const Index count = std::min<Index>(lanes<Scalar>, z.cols() - first);
    for (Index lane = 0; lane < lanes<Scalar>; ++lane) {  // the last lanes repeat an instance where there are none
      multiply_out(forces.r, z.col(first + std::min(lane, count - 1)).data(), result.products.data());
      to.col(lane) = own_products;
    }
    std::ranges::fill(result.lane_h4, Scalar(0));
    multiply_symmetric_lanes(forces.pairs, forces.quartic.data(), result.lane_products.data(), result.lane_h4.data());
    for (Index lane = 0; lane < count; ++lane) {
      result.point = z.col(first + lane);
      own_products = products.col(lane);
      own_h4 = h4.col(lane);
      finish_instance(forces, first + lane, result);
    }
  }
}

template BatchEvaluation<double> make_batch_evaluation(const Forces<double>&, Index);
template BatchEvaluation<float> make_batch_evaluation(const Forces<float>&, Index);
template void evaluate_batch(const Forces<double>&, const Eigen::Ref<const Matrix<double>>&, BatchEvaluation<double>&);
template void evaluate_batch(const Forces<float>&, const Eigen::Ref<const Matrix<float>>&, BatchEvaluation<float>&);

}  // namespace ritz::runtime
