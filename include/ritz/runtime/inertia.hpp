// The inertia of a reduced model, M(q) q̈ + h(q, q̇): mass times acceleration, and the terms h that are quadratic in
// the velocity where the mass depends on the configuration.
#pragma once
#include <functional>
#include <variant>

#include "ritz/runtime/vector.hpp"

namespace ritz::runtime {

/// M = I, the inertia over a mass-orthonormal basis (UᵀMU = I).
struct UnitInertia {};

/// A constant mass M, r x r, symmetric and positive definite.
template <class Scalar>
struct ConstantInertia {
  Matrix<Scalar> mass;
};

/// The inertia at a configuration q, a velocity v and an acceleration a.
template <class Scalar>
struct InertiaAt {
  Matrix<Scalar> mass;         ///< M(q), r x r, symmetric and positive definite
  Vector<Scalar> force;        ///< M(q) a + h(q, v), r
  Matrix<Scalar> by_position;  ///< ∂force/∂q, r x r
  Matrix<Scalar> by_velocity;  ///< ∂force/∂v = ∂h/∂v, r x r
};

/// A mass M(q) that depends on the configuration. `evaluate` writes all members of `result`, whose arrays already have
/// their sizes; q, v and a have r entries each.
template <class Scalar>
struct VaryingInertia {
  std::function<void(const VectorRef<Scalar>& q, const VectorRef<Scalar>& v, const VectorRef<Scalar>& a,
                     InertiaAt<Scalar>& result)>
      evaluate;
};

/// The inertia of a model: one of the three kinds.
template <class Scalar>
using Inertia = std::variant<UnitInertia, ConstantInertia<Scalar>, VaryingInertia<Scalar>>;

/// Allocates the arrays for r coordinates, with M = I and all other numbers 0.
template <class Scalar>
InertiaAt<Scalar> make_inertia_at(Eigen::Index r);

/// Evaluates an inertia of any kind at (q, v, a), each of r numbers; `result` comes from make_inertia_at. Does not
/// allocate, unless `evaluate` of a varying inertia does.
template <class Scalar>
void evaluate(const Inertia<Scalar>& inertia, const VectorRef<Scalar>& q, const VectorRef<Scalar>& v,
              const VectorRef<Scalar>& a, InertiaAt<Scalar>& result);

/// matrix += scale M, r x r. For a varying inertia M is `at.mass`, the mass of the last evaluation.
template <class Scalar>
void add_mass(const Inertia<Scalar>& inertia, Scalar scale, const InertiaAt<Scalar>& at, Matrix<Scalar>& matrix);

}  // namespace ritz::runtime
