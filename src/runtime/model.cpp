#include "ritz/runtime/model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"

namespace ritz::runtime {
namespace {

/// λ of each mode; 0 of a rigid one.
Eigen::VectorXd stiffness_of(const model::Modes& modes) {
  Eigen::VectorXd stiffness = Eigen::VectorXd::Zero(modes.eigenvalues.size());
  for (Eigen::Index i = 0; i < stiffness.size(); ++i) {
    if (modes.kinds[static_cast<std::size_t>(i)] == model::ModeKind::rigid) continue;
    stiffness[i] = modes.eigenvalues[i];
    if (!(stiffness[i] >= 0))
      throw InputError("mode " + std::to_string(i + 1) + " of the model has the eigenvalue " + shown(stiffness[i]) +
                       " rad²/s², which is not a vibration: reduce the model again");
  }
  return stiffness;
}

/// 2 ζ_i ω_i; a coordinate without stiffness has no ratio.
Eigen::VectorXd by_ratios(const Damping& damping, const Eigen::VectorXd& stiffness, double softest) {
  const auto& zeta = damping.ratio;
  Eigen::VectorXd d = Eigen::VectorXd::Zero(stiffness.size());
  std::size_t flexible = 0;
  for (Eigen::Index i = 0; i < stiffness.size() && !zeta.empty(); ++i)
    if (stiffness[i] > softest) d[i] = 2 * zeta[std::min(flexible++, zeta.size() - 1)] * std::sqrt(stiffness[i]);
  return d;
}

/// Whether nothing but rounding stands beside the diagonal.
bool is_diagonal(const Eigen::MatrixXd& matrix) {
  constexpr double rounding = 1e-13;
  const Eigen::MatrixXd beside = matrix - Eigen::MatrixXd(matrix.diagonal().asDiagonal());
  return beside.cwiseAbs().maxCoeff() <= rounding * matrix.cwiseAbs().maxCoeff();
}

template <class Scalar>
Model<Scalar> oscillators(const Eigen::VectorXd& stiffness, const Damping& damping) {
  const Eigen::VectorXd d =
      (damping.alpha + (damping.beta * stiffness + by_ratios(damping, stiffness, 0)).array()).matrix();
  return {.force = LinearForce<Scalar>{stiffness.cast<Scalar>()}, .damping = Vector<Scalar>(d.cast<Scalar>())};
}

template <class Scalar>
Model<Scalar> nonlinear(InternalForce<Scalar> force, const Damping& damping) {
  const Eigen::MatrixXd rest = stiffness_at_rest(force).template cast<double>();
  Eigen::MatrixXd D = damping.beta * rest;
  D.diagonal().array() += damping.alpha;
  D.diagonal() += by_ratios(damping, rest.diagonal(), rigid_stiffness * rest.diagonal().maxCoeff());
  if (damping.beta == 0 || is_diagonal(rest))
    return {.force = std::move(force), .damping = Vector<Scalar>(D.diagonal().cast<Scalar>())};
  return {.force = std::move(force), .damping = Matrix<Scalar>(D.cast<Scalar>())};
}

}  // namespace

template <class Scalar>
Model<Scalar> make_model(const model::Modes& modes, const Damping& damping) {
  return oscillators<Scalar>(stiffness_of(modes), damping);
}

template <class Scalar>
Model<Scalar> make_model(const model::Reduction& reduction, const Damping& damping) {
  const auto& stiffness = reduction.stiffness;
  const double softest = stiffness.size() > 0 ? rigid_stiffness * stiffness.maxCoeff() : 0;
  return oscillators<Scalar>((stiffness.array() > softest).select(stiffness, 0), damping);
}

template <class Scalar>
Model<Scalar> make_model(const model::Polynomial& polynomial, const Damping& damping) {
  return nonlinear<Scalar>(make_polynomial_force<Scalar>(polynomial), damping);
}

template <class Scalar>
Model<Scalar> make_model(const model::Cubature& cubature, std::span<const model::RegionMaterial> materials,
                         const model::Polynomial* polynomial, const Damping& damping) {
  return nonlinear<Scalar>(make_cubature_force<Scalar>(cubature, materials, polynomial), damping);
}

template <class Scalar>
Model<Scalar> carry(Model<Scalar> body, Inertia<Scalar> inertia) {
  const Eigen::Index r = body.size(), size = frame_coordinates + r;
  Model<Scalar> model{.force = CarriedForce<Scalar>{}, .damping = Vector<Scalar>(), .inertia = std::move(inertia)};
  std::visit(
      [&]<class Force>(Force& force) {
        if constexpr (std::is_same_v<Force, CarriedForce<Scalar>>)
          throw std::logic_error("a frame carries the body already");
        else std::get<CarriedForce<Scalar>>(model.force).body = std::move(force);
      },
      body.force);
  if (const auto* diagonal = std::get_if<Vector<Scalar>>(&body.damping)) {
    Vector<Scalar> damping = Vector<Scalar>::Zero(size);
    damping.tail(r) = *diagonal;
    model.damping = std::move(damping);
  } else {
    Matrix<Scalar> damping = Matrix<Scalar>::Zero(size, size);
    damping.bottomRightCorner(r, r) = std::get<Matrix<Scalar>>(body.damping);
    model.damping = std::move(damping);
  }
  return model;
}

template <class Scalar>
bool is_oscillators(const Model<Scalar>& model) {
  return std::holds_alternative<LinearForce<Scalar>>(model.force) &&
         std::holds_alternative<Vector<Scalar>>(model.damping) && std::holds_alternative<UnitInertia>(model.inertia);
}

template <class Scalar>
void add_damping(const Model<Scalar>& model, Scalar scale, const VectorRef<Scalar>& x, Vector<Scalar>& y) {
  if (const auto* diagonal = std::get_if<Vector<Scalar>>(&model.damping)) y += scale * diagonal->cwiseProduct(x);
  else y.noalias() += scale * std::get<Matrix<Scalar>>(model.damping) * x;
}

template <class Scalar>
void add_damping(const Model<Scalar>& model, Scalar scale, Matrix<Scalar>& matrix) {
  if (const auto* diagonal = std::get_if<Vector<Scalar>>(&model.damping)) matrix.diagonal() += scale * *diagonal;
  else matrix += scale * std::get<Matrix<Scalar>>(model.damping);
}

template <class Scalar>
Scalar energy(const Model<Scalar>& model, const VectorRef<Scalar>& z, const VectorRef<Scalar>& v,
              Evaluation<Scalar>& room) {
  evaluate<Scalar>(model.force, z, room);
  if (std::holds_alternative<UnitInertia>(model.inertia)) return v.squaredNorm() / 2 + room.energy;
  if (const auto* constant = std::get_if<ConstantInertia<Scalar>>(&model.inertia)) {
    room.force.noalias() = constant->mass * v;
    return v.dot(room.force) / 2 + room.energy;
  }
  auto at = make_inertia_at<Scalar>(z.size());
  room.force.setZero();
  evaluate<Scalar>(model.inertia, z, v, room.force, at);
  room.force.noalias() = at.mass * v;
  return v.dot(room.force) / 2 + room.energy;
}

#define RITZ_INSTANCE(S)                                                                       \
  template Model<S> make_model(const model::Modes&, const Damping&);                           \
  template Model<S> make_model(const model::Reduction&, const Damping&);                       \
  template Model<S> make_model(const model::Polynomial&, const Damping&);                      \
  template Model<S> make_model(const model::Cubature&, std::span<const model::RegionMaterial>, \
                               const model::Polynomial*, const Damping&);                      \
  template Model<S> carry(Model<S>, Inertia<S>);                                               \
  template bool is_oscillators(const Model<S>&);                                               \
  template void add_damping(const Model<S>&, S, const VectorRef<S>&, Vector<S>&);              \
  template void add_damping(const Model<S>&, S, Matrix<S>&);                                   \
  template S energy(const Model<S>&, const VectorRef<S>&, const VectorRef<S>&, Evaluation<S>&);
RITZ_INSTANCE(double)
RITZ_INSTANCE(float)
#undef RITZ_INSTANCE

}  // namespace ritz::runtime
