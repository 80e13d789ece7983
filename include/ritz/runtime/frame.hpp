// A rigid frame that carries a body in free flight: x = origin + rotation (X + U z).
//
// The configuration of such a body is the frame and z; its velocity is ν = (v, ω, z'), where v is the velocity of the
// origin, m/s, and ω the angular velocity, rad/s, both by the axes of the frame. A step's change δ has the same 6 + r
// components and moves the frame by `moved`: in the history of a state the first six coordinates are therefore 0 at
// the beginning of each step. This is the Lie group form of the methods [Brüls and Cardona 2010]: it has no angles that
// could lock, and the rotation stays one.
#pragma once
#include <Eigen/Geometry>

#include "ritz/runtime/vector.hpp"

namespace ritz::runtime {

/// How many coordinates of a change move the frame: three of its origin, then three of its rotation.
inline constexpr Eigen::Index frame_coordinates = 6;

template <class Scalar>
using FrameChange = Eigen::Matrix<Scalar, frame_coordinates, 1>;
template <class Scalar>
using FrameMatrix = Eigen::Matrix<Scalar, frame_coordinates, frame_coordinates>;

template <class Scalar>
struct Frame {
  Eigen::Matrix<Scalar, 3, 1> origin = Eigen::Matrix<Scalar, 3, 1>::Zero();  ///< m
  Eigen::Quaternion<Scalar> rotation = Eigen::Quaternion<Scalar>::Identity();
};

/// The frame after the change (d, θ): origin + R exp(θ/2) d and R exp(θ), R being its rotation. d is by the axes
/// halfway.
template <class Scalar>
Frame<Scalar> moved(const Frame<Scalar>& frame, const FrameChange<Scalar>& change);

/// How the moved frame follows. Of small motions of each frame by its own axes,
///   motion of the moved frame = by_frame (motion of the frame) + by_change d(change).
template <class Scalar>
struct MovedDerivative {
  FrameMatrix<Scalar> by_frame, by_change;
};

template <class Scalar>
MovedDerivative<Scalar> moved_derivative(const FrameChange<Scalar>& change);

}  // namespace ritz::runtime
