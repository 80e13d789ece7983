#include "ritz/runtime/forces.hpp"

#include <algorithm>
#include <cmath>

#include "kernels.hpp"

namespace ritz::runtime {
namespace {

using Eigen::Index;

/// The products z_k z_l of all pairs, squares halved: H4 = C times them.
template <class Scalar>
void multiply_out(Index r, const Scalar* z, Scalar* products) {
  for (Index k = 0; k < r; ++k) {
    const Scalar zk = z[k];
    *products++ = zk * zk / 2;
    for (Index l = k + 1; l < r; ++l) *products++ = zk * z[l];
  }
}

template <class Scalar>
AlignedVector<Scalar> zeros(Index size) {
  return AlignedVector<Scalar>(static_cast<std::size_t>(size), Scalar(0));
}

/// force += weight (A + H3/2 + H4/3) z, tangent += slope (A + H3 + H4) in the lower triangle.
template <class Scalar>
void add_point(const Forces<Scalar>& forces, const Scalar* z, const Scalar* h3, const Scalar* h4, Scalar weight,
               Scalar slope, Vector<Scalar>& force, Matrix<Scalar>& tangent) {
  const Index r = forces.r;
  const Scalar* linear = forces.linear.data();
  for (Index i = 0; i < r; ++i) {
    const Index n = r - i;
    const auto run = [n](const Scalar* p) { return Eigen::Map<const Eigen::Array<Scalar, -1, 1>>(p, n); };
    const auto secant = run(linear) + run(h3) * Scalar(0.5) + run(h4) * Scalar(1.0 / 3);
    force[i] += weight * (secant * run(z + i)).sum();
    if (n > 1) force.tail(n - 1).array() += weight * z[i] * secant.tail(n - 1);
    tangent.col(i).tail(n).array() += slope * (run(linear) + run(h3) + run(h4));
    linear += n, h3 += n, h4 += n;
  }
}

template <class Scalar>
void mirror(Matrix<Scalar>& symmetric) {
  symmetric.template triangularView<Eigen::StrictlyUpper>() = symmetric.transpose();
}

}  // namespace

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
  const auto array = [&](const auto& v) {
    return Eigen::Map<const Eigen::Array<Scalar, -1, 1>>(v.data(), forces.linear.size());
  };
  energy = (array(products) * (array(forces.linear) + array(h3) * Scalar(1.0 / 3) + array(h4) * Scalar(1.0 / 6))).sum();
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
