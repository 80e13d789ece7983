#include "ritz/runtime/forces.hpp"

#include <algorithm>
#include <cmath>

#include "forces_point.hpp"
#include "kernels.hpp"

namespace ritz::runtime {
using Eigen::Index;

template <class Scalar>
Evaluation<Scalar> make_evaluation(const Forces<Scalar>& forces) {
  constexpr Index width = lanes<Scalar>;
  const Index r = forces.r;
  return {.force = Vector<Scalar>::Zero(r),
          .tangent = Matrix<Scalar>::Zero(r, r),
          .sums = Vector<Scalar>::Zero(result_size(r)),
          .point = zeros<Scalar>(r + width),
          .room = zeros<Scalar>(room_at_point(r) * width),
          .result = zeros<Scalar>(result_size(r) * width)};
}

template <class Scalar>
void evaluate(const Forces<Scalar>& forces, const VectorRef<Scalar>& z, Evaluation<Scalar>& evaluation) {
  auto& [energy, force, tangent, sums, point, room, result] = evaluation;
  std::ranges::copy(z, point.begin());
  differentiate_at_point(forces.r, forces.cubic.data(), forces.quartic.data(), point.data(), room.data(),
                         result.data());
  using Registers = Eigen::Matrix<Scalar, static_cast<int>(lanes<Scalar>), Eigen::Dynamic>;
  sums = Eigen::Map<const Registers, Eigen::Aligned32>(result.data(), lanes<Scalar>, sums.size()).colwise().sum();
  finish<Scalar>(forces, z, sums, energy, force, tangent);
}

template <class Scalar>
MeanEvaluation<Scalar> make_mean_evaluation(const Forces<Scalar>& forces) {
  return {.force = Vector<Scalar>::Zero(forces.r),
          .tangent = Matrix<Scalar>::Zero(forces.r, forces.r),
          .point = Vector<Scalar>::Zero(forces.r),
          .at_point = make_evaluation(forces)};
}

template <class Scalar>
void evaluate_mean(const Forces<Scalar>& forces, const VectorRef<Scalar>& z, const VectorRef<Scalar>& d,
                   MeanEvaluation<Scalar>& result) {
  auto& [force, tangent, point, at_point] = result;
  const auto gauss = static_cast<Scalar>(1 / std::sqrt(12.0));
  force.setZero();
  tangent.setZero();
  for (const Scalar node : {Scalar(0.5) - gauss, Scalar(0.5) + gauss}) {
    point = z + node * d;
    evaluate<Scalar>(forces, point, at_point);
    force += at_point.force / 2;
    tangent += at_point.tangent * (node / 2);
  }
}

template Evaluation<double> make_evaluation(const Forces<double>&);
template Evaluation<float> make_evaluation(const Forces<float>&);
template void evaluate(const Forces<double>&, const VectorRef<double>&, Evaluation<double>&);
template void evaluate(const Forces<float>&, const VectorRef<float>&, Evaluation<float>&);
template MeanEvaluation<double> make_mean_evaluation(const Forces<double>&);
template MeanEvaluation<float> make_mean_evaluation(const Forces<float>&);
template void evaluate_mean(const Forces<double>&, const VectorRef<double>&, const VectorRef<double>&,
                            MeanEvaluation<double>&);
template void evaluate_mean(const Forces<float>&, const VectorRef<float>&, const VectorRef<float>&,
                            MeanEvaluation<float>&);

}  // namespace ritz::runtime
