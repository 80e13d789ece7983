// Faces of cells, and consistent loads on them.
#pragma once
#include <utility>

#include "ritz/fem/cell.hpp"
#include "ritz/fem/quadrature.hpp"

namespace ritz::fem {

/// The linear triangle. Reference corners: (0,0), (1,0), (0,1).
struct Tri3 {
  static constexpr FaceType type = FaceType::tri3;
  static constexpr int vertices = 3;
  static constexpr auto& rule = quadrature::triangle_1;

  static Vector<3> shape(const Point<2>& xi) { return {1 - xi[0] - xi[1], xi[0], xi[1]}; }
  static Matrix<3, 2> gradient(const Point<2>&) {
    Matrix<3, 2> g;
    g << -1, -1, 1, 0, 0, 1;
    return g;
  }
};

/// The quadratic triangle: the corners of Tri3, then the mid-edge vertices 01, 12, 20.
struct Tri6 {
  static constexpr FaceType type = FaceType::tri6;
  static constexpr int vertices = 6;
  static constexpr auto& rule = quadrature::triangle_12;

  static Vector<6> shape(const Point<2>& xi) {
    const Vector<3> L = Tri3::shape(xi);
    Vector<6> N;
    for (int a = 0; a < 3; ++a) {
      N[a] = L[a] * (2 * L[a] - 1);
      N[3 + a] = 4 * L[a] * L[(a + 1) % 3];
    }
    return N;
  }
  static Matrix<6, 2> gradient(const Point<2>& xi) {
    const Vector<3> L = Tri3::shape(xi);
    const Matrix<3, 2> dL = Tri3::gradient(xi);
    Matrix<6, 2> g;
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3;
      g.row(a) = (4 * L[a] - 1) * dL.row(a);
      g.row(3 + a) = 4 * (L[a] * dL.row(b) + L[b] * dL.row(a));
    }
    return g;
  }
};

/// The bilinear quadrilateral. Reference square [-1, 1]², vertices counter-clockwise.
struct Quad4 {
  static constexpr FaceType type = FaceType::quad4;
  static constexpr int vertices = 4;
  static constexpr auto& rule = quadrature::square_9;
  static constexpr std::array<Point<2>, 4> reference = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

  static Vector<4> shape(const Point<2>& xi) {
    Vector<4> N;
    for (int a = 0; a < 4; ++a) N[a] = (1 + reference[a][0] * xi[0]) * (1 + reference[a][1] * xi[1]) / 4;
    return N;
  }
  static Matrix<4, 2> gradient(const Point<2>& xi) {
    Matrix<4, 2> g;
    for (int a = 0; a < 4; ++a) {
      const auto [s, t] = reference[a];
      g.row(a) << s * (1 + t * xi[1]) / 4, t * (1 + s * xi[0]) / 4;
    }
    return g;
  }
};

/// p_a = ∫ N_a n dA, m², 3 x vertices with one column for each vertex; exact, also on curved faces. n points out of the
/// cell if the vertices are in the order of face_vertices; the force on vertex a of a pressure p that pushes into the
/// body is -p p_a.
template <class F>
Coordinates<F> pressure_vectors(const Coordinates<F>& x);

/// w_a = ∫ N_a dA, m²: the force of a traction t on vertex a is w_a t. Exact on plane faces; on warped ones the
/// integrand contains a square root, and the rule has degree 5 or more.
template <class F>
Vector<F::vertices> traction_weights(const Coordinates<F>& x);

/// The area of the face, m².
template <class F>
double area(const Coordinates<F>& x) {
  return traction_weights<F>(x).sum();
}

/// Calls `f(Tri3{})`, `f(Tri6{})` or `f(Quad4{})` and returns its result, which must have the same type for each.
template <class Callable>
constexpr decltype(auto) visit(FaceType type, Callable&& f) {
  switch (type) {
    case FaceType::tri3: return std::forward<Callable>(f)(Tri3{});
    case FaceType::tri6: return std::forward<Callable>(f)(Tri6{});
    case FaceType::quad4: break;
  }
  return std::forward<Callable>(f)(Quad4{});
}

}  // namespace ritz::fem
