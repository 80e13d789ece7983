#include "ritz/runtime/inertia.hpp"

namespace ritz::runtime {

template <class Scalar>
InertiaAt<Scalar> make_inertia_at(Eigen::Index r) {
  const Matrix<Scalar> none = Matrix<Scalar>::Zero(r, r);
  return {.mass = Matrix<Scalar>::Identity(r, r),
          .force = Vector<Scalar>::Zero(r),
          .by_position = none,
          .by_velocity = none};
}

template <class Scalar>
void evaluate(const Inertia<Scalar>& inertia, const VectorRef<Scalar>& q, const VectorRef<Scalar>& v,
              const VectorRef<Scalar>& a, InertiaAt<Scalar>& result) {
  if (const auto* varying = std::get_if<VaryingInertia<Scalar>>(&inertia)) {
    varying->evaluate(q, v, a, result);
    return;
  }
  if (const auto* constant = std::get_if<ConstantInertia<Scalar>>(&inertia)) {
    result.mass = constant->mass;
    result.force.noalias() = constant->mass * a;
    return;
  }
  result.force = a;
}

template <class Scalar>
void add_mass(const Inertia<Scalar>& inertia, Scalar scale, const InertiaAt<Scalar>& at, Matrix<Scalar>& matrix) {
  if (std::holds_alternative<UnitInertia>(inertia)) matrix.diagonal().array() += scale;
  else if (const auto* constant = std::get_if<ConstantInertia<Scalar>>(&inertia)) matrix += scale * constant->mass;
  else matrix += scale * at.mass;
}

#define RITZ_INSTANCE(S)                                                                                   \
  template void add_mass(const Inertia<S>&, S, const InertiaAt<S>&, Matrix<S>&);                           \
  template InertiaAt<S> make_inertia_at(Eigen::Index);                                                     \
  template void evaluate(const Inertia<S>&, const VectorRef<S>&, const VectorRef<S>&, const VectorRef<S>&, \
                         InertiaAt<S>&);
RITZ_INSTANCE(double)
RITZ_INSTANCE(float)
#undef RITZ_INSTANCE

}  // namespace ritz::runtime
