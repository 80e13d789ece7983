#include "ritz/fem/face.hpp"

#include <Eigen/Geometry>

#include "ritz/fem/element.hpp"

namespace ritz::fem {
namespace {

/// Calls add(weight, dx/dξ, dx/dη, N) at each point of the rule.
template <class Add>
void integrate(FaceType type, const FaceVectors& x, const Add& add) {
  const auto& [vertices, reference, shape, gradient, rule, mass_rule, at_vertices] = element(type);
  const FaceVectors from_first = relative(x);
  for (int q = 0; q < rule.count(); ++q) {
    const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 2>> g(rule.gradients.data() + 2 * vertices * q,
                                                                       vertices, 2);
    const Matrix<3, 2> J = from_first.lazyProduct(g);
    add(rule.weights[static_cast<std::size_t>(q)], Vector<3>(J.col(0)), Vector<3>(J.col(1)),
        Eigen::Map<const Eigen::VectorXd>(rule.values.data() + vertices * q, vertices));
  }
}

}  // namespace

FaceVectors pressure_vectors(FaceType type, const FaceVectors& x) {
  FaceVectors p = FaceVectors::Zero(3, x.cols());
  integrate(type, x, [&](double weight, const Vector<3>& along, const Vector<3>& across, const auto& N) {
    p += (weight * along.cross(across)).lazyProduct(N.transpose());
  });
  return p;
}

UpTo<max_face_vertices, 1> traction_weights(FaceType type, const FaceVectors& x) {
  UpTo<max_face_vertices, 1> w = UpTo<max_face_vertices, 1>::Zero(x.cols(), 1);
  integrate(type, x, [&](double weight, const Vector<3>& along, const Vector<3>& across, const auto& N) {
    w += weight * along.cross(across).norm() * N;
  });
  return w;
}

}  // namespace ritz::fem
