// Vectors of r and matrices of r x r numbers, r being the number of reduced coordinates.
#pragma once
#include <Eigen/Core>
#include <type_traits>

namespace ritz::runtime {

template <class Scalar>
using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
template <class Scalar>
using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
/// A vector, or a part of one, as an argument that is only read.
template <class Scalar>
using VectorRef = Eigen::Ref<const Vector<std::type_identity_t<Scalar>>>;

}  // namespace ritz::runtime
