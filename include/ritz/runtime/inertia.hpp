// The inertia of a reduced model, M(q) q̈ + h(q, q̇): mass times acceleration, and what a mass that changes with the
// configuration adds to it.
#pragma once
#include <functional>
#include <variant>

#include "ritz/runtime/vector.hpp"

namespace ritz::runtime {

/// M = I: the inertia over a mass-orthonormal basis, UᵀMU = I.
struct UnitInertia {};

/// A constant mass, r x r, symmetric and positive definite.
template <class Scalar>
struct ConstantInertia {
  Matrix<Scalar> mass;
};

/// The inertia at a configuration q, a velocity v and an acceleration a, and room for it.
template <class Scalar>
struct InertiaAt {
  Matrix<Scalar> mass;         ///< M(q), r x r, symmetric and positive definite
  Vector<Scalar> force;        ///< M(q) a + h(q, v), r
  Matrix<Scalar> by_position;  ///< its derivative by q, r x r
  Matrix<Scalar> by_velocity;  ///< its derivative by v, ∂h/∂v, r x r
};

/// A mass M(q) that depends on the configuration. `evaluate` fills an InertiaAt whose arrays have their sizes.
template <class Scalar>
struct VaryingInertia {
  std::function<void(const VectorRef<Scalar>& q, const VectorRef<Scalar>& v, const VectorRef<Scalar>& a,
                     InertiaAt<Scalar>& result)>
      evaluate;
};

template <class Scalar>
using Inertia = std::variant<UnitInertia, ConstantInertia<Scalar>, VaryingInertia<Scalar>>;

template <class Scalar>
InertiaAt<Scalar> make_inertia_at(Eigen::Index r);

/// The inertia of any kind at (q, v, a). Does not allocate, unless `evaluate` of a varying one does.
template <class Scalar>
void evaluate(const Inertia<Scalar>& inertia, const VectorRef<Scalar>& q, const VectorRef<Scalar>& v,
              const VectorRef<Scalar>& a, InertiaAt<Scalar>& result);

/// matrix += scale M, r x r; of a varying inertia the mass that `at` was evaluated to last.
template <class Scalar>
void add_mass(const Inertia<Scalar>& inertia, Scalar scale, const InertiaAt<Scalar>& at, Matrix<Scalar>& matrix);

}  // namespace ritz::runtime
