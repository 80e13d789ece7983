#include "ritz/runtime/polynomial_force.hpp"

#include <algorithm>

#include "kernels.hpp"
#include "polynomial_point.hpp"

namespace ritz::runtime {
using Eigen::Index;

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
          .carried = {}};
}

template <class Scalar>
void evaluate(const PolynomialForce<Scalar>& forces, const VectorRef<Scalar>& z, Evaluation<Scalar>& evaluation) {
  auto& [energy, force, tangent, sums, point, room, result, carried] = evaluation;
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

}  // namespace ritz::runtime
