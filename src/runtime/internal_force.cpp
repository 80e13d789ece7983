#include "ritz/runtime/internal_force.hpp"

#include <array>

namespace ritz::runtime {
namespace {

/// The cubature of a body, carried or not; null where it has none.
template <class Scalar>
const CubatureForce<Scalar>* cubature_of(const InternalForce<Scalar>& force) {
  const auto* carried = std::get_if<CarriedForce<Scalar>>(&force);
  return carried ? std::get_if<CubatureForce<Scalar>>(&carried->body) : std::get_if<CubatureForce<Scalar>>(&force);
}

}  // namespace

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
  evaluation.inner.push_back(std::visit([](const auto& body) { return make_evaluation(body); }, force.body));
  return evaluation;
}

template <class Scalar>
void evaluate(const CarriedForce<Scalar>& force, const VectorRef<Scalar>& q, Evaluation<Scalar>& result) {
  auto& own = result.inner.front();
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
bool is_cubic(const InternalForce<Scalar>& force) {
  return !cubature_of(force);
}

template <class Scalar>
bool admits(const InternalForce<Scalar>& force, const VectorRef<Scalar>& z, Evaluation<Scalar>& room) {
  const auto* cubature = cubature_of(force);
  if (!cubature) return true;
  const bool carried = std::holds_alternative<CarriedForce<Scalar>>(force);
  return admits<Scalar>(*cubature, z.tail(cubature->size()), carried ? room.inner.front() : room);
}

template <class Scalar>
std::span<const MeanPoint<Scalar>> mean_rule(const InternalForce<Scalar>& force) {
  static constexpr double two = .28867513459481288225, inner = .16999052179242813240, outer = .43056815579702628761;
  static constexpr double heavy = .32607257743127307131, light = .17392742256872692869;
  static constexpr std::array<MeanPoint<Scalar>, 2> of_two = {
      {{Scalar(.5 - two), Scalar(.5)}, {Scalar(.5 + two), Scalar(.5)}}};
  static constexpr std::array<MeanPoint<Scalar>, 4> of_four = {{{Scalar(.5 - outer), Scalar(light)},
                                                                {Scalar(.5 - inner), Scalar(heavy)},
                                                                {Scalar(.5 + inner), Scalar(heavy)},
                                                                {Scalar(.5 + outer), Scalar(light)}}};
  if (is_cubic(force)) return of_two;
  return of_four;
}

template <class Scalar>
void evaluate_mean(const InternalForce<Scalar>& internal, const VectorRef<Scalar>& z, const VectorRef<Scalar>& d,
                   MeanEvaluation<Scalar>& result) {
  auto& [force, tangent, point, at_point] = result;
  force.setZero();
  tangent.setZero();
  for (const auto [s, weight] : mean_rule(internal)) {
    point = z + s * d;
    evaluate<Scalar>(internal, point, at_point);
    force += at_point.force * weight;
    tangent += at_point.tangent * (s * weight);
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
  template bool is_cubic(const InternalForce<S>&);                                     \
  template bool admits(const InternalForce<S>&, const VectorRef<S>&, Evaluation<S>&);  \
  template std::span<const MeanPoint<S>> mean_rule(const InternalForce<S>&);           \
  template void evaluate_mean(const InternalForce<S>&, const VectorRef<S>&, const VectorRef<S>&, MeanEvaluation<S>&);
RITZ_INSTANCE(double)
RITZ_INSTANCE(float)
#undef RITZ_INSTANCE

}  // namespace ritz::runtime
