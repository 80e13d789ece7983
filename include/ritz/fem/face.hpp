// Consistent loads on faces of cells. `x` are the vertices, 3 x vertices, m.
#pragma once
#include "ritz/fem/types.hpp"

namespace ritz::fem {

/// p_a = ∫ N_a n dA, m², 3 x vertices with one column for each vertex; exact, also on curved faces. n points out of the
/// cell if the vertices are in the order of face_vertices; the force on vertex a of a pressure p that pushes into the
/// body is -p p_a.
FaceVectors pressure_vectors(FaceType type, const FaceVectors& x);

/// w_a = ∫ N_a dA, m², one a vertex: the force of a traction t on vertex a is w_a t. Exact on plane faces; on warped
/// ones the integrand contains a square root, and the rule has degree 5 or more.
UpTo<max_face_vertices, 1> traction_weights(FaceType type, const FaceVectors& x);

/// The area of the face, m².
inline double area(FaceType type, const FaceVectors& x) { return traction_weights(type, x).sum(); }

}  // namespace ritz::fem
