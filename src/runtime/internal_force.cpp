#include "ritz/runtime/internal_force.hpp"

#include <cmath>

namespace ritz::runtime {

template <class Scalar>
Evaluation<Scalar> make_evaluation(const LinearForce<Scalar>& force) {
  const Eigen::Index r = force.size();
  Evaluation<Scalar> evaluation;
  evaluation.force = Vector<Scalar>::Zero(r);
  evaluation.tangent = force.stiffness.asDiagonal();
  return evaluation;
}

template <class Scalar>
void evaluate(const LinearForce<Scalar>& force, const VectorRef<Scalar>& z, Evaluation<Scalar>& result) {
  result.force = force.stiffness.cwiseProduct(z);
  result.energy = z.dot(result.force) / 2;
}

template <class Scalar>
Evaluation<Scalar> make_evaluation(const CarriedForce<Scalar>& force) {
  const Eigen::Index size = force.size();
  Evaluation<Scalar> evaluation;
  evaluation.force = Vector<Scalar>::Zero(size);
  evaluation.tangent = Matrix<Scalar>::Zero(size, size);
  evaluation.carried.push_back(std::visit([](const auto& body) { return make_evaluation(body); }, force.body));
  return evaluation;
}

template <class Scalar>
void evaluate(const CarriedForce<Scalar>& force, const VectorRef<Scalar>& q, Evaluation<Scalar>& result) {
  auto& own = result.carried.front();
  const Eigen::Index r = own.force.size();
  std::visit([&](const auto& body) { evaluate<Scalar>(body, q.tail(r), own); }, force.body);
  result.energy = own.energy;
  result.force.head(frame_coordinates).setZero();
  result.force.tail(r) = own.force;
  result.tangent.bottomRightCorner(r, r) = own.tangent;
}

template <class Scalar>
Matrix<Scalar> stiffness_at_rest(const LinearForce<Scalar>& force) {
  return force.stiffness.asDiagonal();
}

template <class Scalar>
Matrix<Scalar> stiffness_at_rest(const PolynomialForce<Scalar>& force) {
  return force.linear;
}

template <class Scalar>
Matrix<Scalar> stiffness_at_rest(const CarriedForce<Scalar>& force) {
  const Matrix<Scalar> body = std::visit([](const auto& f) { return stiffness_at_rest(f); }, force.body);
  Matrix<Scalar> stiffness = Matrix<Scalar>::Zero(force.size(), force.size());
  stiffness.bottomRightCorner(body.rows(), body.cols()) = body;
  return stiffness;
}

template <class Scalar>
MeanEvaluation<Scalar> make_mean_evaluation(const InternalForce<Scalar>& force) {
  const Eigen::Index r = size(force);
  return {.force = Vector<Scalar>::Zero(r),
          .tangent = Matrix<Scalar>::Zero(r, r),
          .point = Vector<Scalar>::Zero(r),
          .at_point = make_evaluation(force)};
}

template <class Scalar>
std::array<Scalar, 2> mean_points() {
  const auto gauss = static_cast<Scalar>(1 / std::sqrt(12.0));
  return {Scalar(0.5) - gauss, Scalar(0.5) + gauss};
}

template <class Scalar>
void evaluate_mean(const InternalForce<Scalar>& internal, const VectorRef<Scalar>& z, const VectorRef<Scalar>& d,
                   MeanEvaluation<Scalar>& result) {
  auto& [force, tangent, point, at_point] = result;
  force.setZero();
  tangent.setZero();
  for (const Scalar s : mean_points<Scalar>()) {
    point = z + s * d;
    evaluate<Scalar>(internal, point, at_point);
    force += at_point.force / 2;
    tangent += at_point.tangent * (s / 2);
  }
}

#define RITZ_INSTANCE(S)                                                               \
  template Evaluation<S> make_evaluation(const LinearForce<S>&);                       \
  template void evaluate(const LinearForce<S>&, const VectorRef<S>&, Evaluation<S>&);  \
  template Evaluation<S> make_evaluation(const CarriedForce<S>&);                      \
  template void evaluate(const CarriedForce<S>&, const VectorRef<S>&, Evaluation<S>&); \
  template Matrix<S> stiffness_at_rest(const LinearForce<S>&);                         \
  template Matrix<S> stiffness_at_rest(const PolynomialForce<S>&);                     \
  template Matrix<S> stiffness_at_rest(const CarriedForce<S>&);                        \
  template MeanEvaluation<S> make_mean_evaluation(const InternalForce<S>&);            \
  template std::array<S, 2> mean_points();                                             \
  template void evaluate_mean(const InternalForce<S>&, const VectorRef<S>&, const VectorRef<S>&, MeanEvaluation<S>&);
RITZ_INSTANCE(double)
RITZ_INSTANCE(float)
#undef RITZ_INSTANCE

}  // namespace ritz::runtime
