#include "ritz/runtime/forces.hpp"

#include <algorithm>
#include <cmath>

#include "forces_point.hpp"
#include "kernels.hpp"

namespace ritz::runtime {
using Eigen::Index;

template <class Scalar>
Evaluation<Scalar> make_evaluation(const Forces<Scalar>& forces) {
  return {.force = Vector<Scalar>::Zero(forces.r),
          .tangent = Matrix<Scalar>::Zero(forces.r, forces.r),
          .products = zeros<Scalar>(forces.pairs),
          .h3 = zeros<Scalar>(forces.pairs),
          .h4 = zeros<Scalar>(forces.pairs)};
}

template <class Scalar>
void evaluate(const Forces<Scalar>& forces, const VectorRef<Scalar>& z, Evaluation<Scalar>& result) {
  auto& [energy, force, tangent, products, h3, h4] = result;
  multiply_out(forces.r, z.data(), products.data());
  std::ranges::fill(h3, Scalar(0));
  std::ranges::fill(h4, Scalar(0));
  multiply_columns(forces.pairs, forces.r, forces.cubic.data(), z.data(), h3.data());
  multiply_symmetric(forces.pairs, forces.quartic.data(), products.data(), h4.data());
  force.setZero();
  tangent.setZero();
  add_point(forces, z.data(), h3.data(), h4.data(), Scalar(1), Scalar(1), force, tangent);
  mirror(tangent);
  energy = energy_of(forces, products, h3, h4);
}

template <class Scalar>
MeanEvaluation<Scalar> make_mean_evaluation(const Forces<Scalar>& forces) {
  const Vector<Scalar> none = Vector<Scalar>::Zero(forces.r);
  return {.force = none,
          .tangent = Matrix<Scalar>::Zero(forces.r, forces.r),
          .first = none,
          .second = none,
          .products = zeros<Scalar>(2 * forces.pairs),
          .h3 = zeros<Scalar>(2 * forces.pairs),
          .h4 = zeros<Scalar>(2 * forces.pairs)};
}

template <class Scalar>
void evaluate_mean(const Forces<Scalar>& forces, const VectorRef<Scalar>& z, const VectorRef<Scalar>& d,
                   MeanEvaluation<Scalar>& result) {
  auto& [force, tangent, first, second, products, h3, h4] = result;
  const auto gauss = static_cast<Scalar>(1 / std::sqrt(12.0));
  const Scalar nodes[2] = {Scalar(0.5) - gauss, Scalar(0.5) + gauss};
  first = z + nodes[0] * d;
  second = z + nodes[1] * d;
  std::ranges::fill(h3, Scalar(0));
  std::ranges::fill(h4, Scalar(0));
  const Vector<Scalar>* points[2] = {&first, &second};
  for (int q = 0; q < 2; ++q) {
    multiply_out(forces.r, points[q]->data(), products.data() + q * forces.pairs);
    multiply_columns(forces.pairs, forces.r, forces.cubic.data(), points[q]->data(), h3.data() + q * forces.pairs);
  }
  multiply_symmetric_twice(forces.pairs, forces.quartic.data(), products.data(), h4.data());
  force.setZero();
  tangent.setZero();
  for (int q = 0; q < 2; ++q)
    add_point(forces, points[q]->data(), h3.data() + q * forces.pairs, h4.data() + q * forces.pairs, Scalar(0.5),
              nodes[q] / 2, force, tangent);
  mirror(tangent);
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
