#include "ritz/runtime/frame.hpp"

#include <cmath>
#include <limits>

namespace ritz::runtime {
namespace {

template <class Scalar>
using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
template <class Scalar>
using Matrix3 = Eigen::Matrix<Scalar, 3, 3>;

/// a ↦ v × a.
template <class Scalar>
Matrix3<Scalar> cross(const Vector3<Scalar>& v) {
  Matrix3<Scalar> matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

/// Below this angle series are exact to rounding.
template <class Scalar>
Scalar small_angle() {
  return std::pow(std::numeric_limits<Scalar>::epsilon(), Scalar(0.25));
}

/// The rotation by |θ| about θ.
template <class Scalar>
Eigen::Quaternion<Scalar> exponential(const Vector3<Scalar>& theta) {
  const Scalar half = theta.norm() / 2;
  const Scalar sine = half < small_angle<Scalar>() ? Scalar(0.5) * (1 - half * half / 6) : std::sin(half) / (2 * half);
  const Vector3<Scalar> v = sine * theta;
  return Eigen::Quaternion<Scalar>(std::cos(half), v.x(), v.y(), v.z());
}

/// J of exp(θ + dθ) = exp(θ) exp(J dθ): I − (1 − cos a)/a² θ̃ + (a − sin a)/a³ θ̃², a = |θ|.
template <class Scalar>
Matrix3<Scalar> right_jacobian(const Vector3<Scalar>& theta) {
  const Scalar a = theta.norm();
  const bool small = a < small_angle<Scalar>();
  const Scalar first = small ? Scalar(0.5) - a * a / 24 : 2 * std::pow(std::sin(a / 2) / a, Scalar(2));
  const Scalar second = small ? Scalar(1) / 6 - a * a / 120 : (a - std::sin(a)) / (a * a * a);
  const Matrix3<Scalar> tilde = cross<Scalar>(theta);
  return Matrix3<Scalar>::Identity() - first * tilde + second * tilde * tilde;
}

}  // namespace

template <class Scalar>
Frame<Scalar> moved(const Frame<Scalar>& frame, const FrameChange<Scalar>& change) {
  const Vector3<Scalar> d = change.template head<3>(), theta = change.template tail<3>(), half = theta / 2;
  return {frame.origin + frame.rotation * (exponential<Scalar>(half) * d),
          (frame.rotation * exponential<Scalar>(theta)).normalized()};
}

template <class Scalar>
MovedDerivative<Scalar> moved_derivative(const FrameChange<Scalar>& change) {
  const Vector3<Scalar> d = change.template head<3>(), theta = change.template tail<3>(), half = theta / 2;
  const Matrix3<Scalar> back = exponential<Scalar>(theta).toRotationMatrix().transpose();
  const Matrix3<Scalar> halfway = exponential<Scalar>(half).toRotationMatrix();
  MovedDerivative<Scalar> derivative;
  auto& [by_frame, by_change] = derivative;
  by_frame << back, -back * cross<Scalar>(halfway * d), Matrix3<Scalar>::Zero(), back;
  by_change << halfway.transpose(), -halfway.transpose() * cross<Scalar>(d) * right_jacobian<Scalar>(half) / 2,
      Matrix3<Scalar>::Zero(), right_jacobian<Scalar>(theta);
  return derivative;
}

#define RITZ_INSTANCE(S)                                           \
  template Frame<S> moved(const Frame<S>&, const FrameChange<S>&); \
  template MovedDerivative<S> moved_derivative(const FrameChange<S>&);
RITZ_INSTANCE(double)
RITZ_INSTANCE(float)
#undef RITZ_INSTANCE

}  // namespace ritz::runtime
