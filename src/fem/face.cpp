#include "ritz/fem/face.hpp"

#include <Eigen/Geometry>

#include "instantiate.hpp"

namespace ritz::fem {

template <class F>
Coordinates<F> pressure_vectors(const Coordinates<F>& x) {
  const Coordinates<F> r = x.colwise() - x.col(0);
  Coordinates<F> p = Coordinates<F>::Zero();
  for (const auto& [xi, weight] : F::rule) {
    const Matrix<3, 2> J = r * F::gradient(xi);
    p += weight * J.col(0).cross(J.col(1)) * F::shape(xi).transpose();
  }
  return p;
}

template <class F>
Vector<F::vertices> traction_weights(const Coordinates<F>& x) {
  const Coordinates<F> r = x.colwise() - x.col(0);
  Vector<F::vertices> w = Vector<F::vertices>::Zero();
  for (const auto& [xi, weight] : F::rule) {
    const Matrix<3, 2> J = r * F::gradient(xi);
    w += weight * J.col(0).cross(J.col(1)).norm() * F::shape(xi);
  }
  return w;
}

#define INSTANTIATE(F)                                                \
  template Coordinates<F> pressure_vectors<F>(const Coordinates<F>&); \
  template Vector<F::vertices> traction_weights<F>(const Coordinates<F>&);
RITZ_FACES(INSTANTIATE)
#undef INSTANTIATE

}  // namespace ritz::fem
