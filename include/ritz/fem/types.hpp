// Fixed-size vectors and matrices for elements.
#pragma once
#include <Eigen/Core>
#include <array>

namespace ritz::fem {

template <int n>
using Vector = Eigen::Matrix<double, n, 1>;

template <int m, int n>
using Matrix = Eigen::Matrix<double, m, n>;

/// Reference coordinates in an element of dimension d.
template <int d>
using Point = std::array<double, d>;

/// The vertices of one cell or face E, 3 x vertices with one column for each, m.
template <class E>
using Coordinates = Matrix<3, E::vertices>;

}  // namespace ritz::fem
