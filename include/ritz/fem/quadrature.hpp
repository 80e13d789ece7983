// Quadrature rules as constants: ∫ f ≈ Σ weight f(xi).
//
// Reference domains: the tetrahedron and the triangle with corners 0 and the unit vectors (volume 1/6, area 1/2); the
// cube [-1, 1]³ (volume 8) and the square [-1, 1]² (area 4); the wedge, a triangle times -1 ≤ ζ ≤ 1 (volume 1); the
// pyramid with the base [-1, 1]² at ζ = 0 and its apex at ζ = 1 (volume 4/3). All points lie inside, and all weights
// are positive.
#pragma once
#include <array>
#include <cstddef>

#include "ritz/fem/types.hpp"

namespace ritz::fem {

/// A quadrature point and its weight.
template <int d>
struct Sample {
  Point<d> xi;
  double weight;
};

/// A quadrature rule of n points in d dimensions.
template <int d, std::size_t n>
using Rule = std::array<Sample<d>, n>;

namespace quadrature {

/// Gauss-Legendre on [-1, 1]: exact up to degree 2n - 1 with n points.
inline constexpr Rule<1, 2> gauss_2 = {{{{-0.57735026918962576451}, 1}, {{0.57735026918962576451}, 1}}};
inline constexpr Rule<1, 3> gauss_3 = {
    {{{-0.77459666924148337704}, 5. / 9}, {{0}, 8. / 9}, {{0.77459666924148337704}, 5. / 9}}};

inline constexpr Rule<1, 5> gauss_5 = {{{{-0.9061798459386639928}, 0.23692688505618908751},
                                        {{-0.53846931010568309104}, 0.47862867049936646804},
                                        {{0}, 0.56888888888888888889},
                                        {{0.53846931010568309104}, 0.47862867049936646804},
                                        {{0.9061798459386639928}, 0.23692688505618908751}}};

/// Gauss-Jacobi on [0, 1] for the weight function (1-t)^a, a = 0, 1, 2: exact for polynomials up to degree 7.
inline constexpr std::array<Rule<1, 4>, 3> gauss_jacobi_4 = {{{{{{0.06943184420297371239}, 0.17392742256872692869},
                                                                {{0.33000947820757186760}, 0.32607257743127307131},
                                                                {{0.66999052179242813240}, 0.32607257743127307131},
                                                                {{0.93056815579702628761}, 0.17392742256872692869}}},
                                                              {{{{0.05710419611451768219}, 0.13550691343148811621},
                                                                {{0.27684301363812382768}, 0.20346456801027136079},
                                                                {{0.58359043236891682006}, 0.12984754760823244083},
                                                                {{0.86024013565621944785}, 0.03118097095000808217}}},
                                                              {{{{0.04850054944699732930}, 0.11088841561127798368},
                                                                {{0.23860073755186230506}, 0.14345878979921420905},
                                                                {{0.51704729510436750234}, 0.06863388717292307532},
                                                                {{0.79585141789677286330}, 0.01035224074991806528}}}}};

/// The same with five points, up to degree 9, for a = 0 and 1, and with two points, up to degree 3, for a = 2.
inline constexpr std::array<Rule<1, 5>, 2> gauss_jacobi_5 = {{{{{{0.046910077030668003601}, 0.11846344252809454376},
                                                                {{0.23076534494715845448}, 0.23931433524968323402},
                                                                {{0.5}, 0.28444444444444444444},
                                                                {{0.76923465505284154552}, 0.23931433524968323402},
                                                                {{0.9530899229693319964}, 0.11846344252809454376}}},
                                                              {{{{0.039809857051468742341}, 0.096781590226651679274},
                                                                {{0.19801341787360817254}, 0.16717463809436956549},
                                                                {{0.43797481024738614401}, 0.1463869870846698087},
                                                                {{0.69546427335363609451}, 0.073908870072616670351},
                                                                {{0.90146491420117357388}, 0.015747914521692276185}}}}};
inline constexpr Rule<1, 2> gauss_jacobi_2 = {
    {{{0.12251482265544137787}, 0.23254745125350790275}, {{0.5441518440112252888}, 0.10078588207982543058}}};

/// The product of a rule with itself on the square.
template <std::size_t n>
constexpr Rule<2, n * n> square(const Rule<1, n>& line) {
  Rule<2, n* n> rule = {};
  std::size_t k = 0;
  for (const auto& y : line)
    for (const auto& x : line) rule[k++] = {{x.xi[0], y.xi[0]}, x.weight * y.weight};
  return rule;
}

/// The product of a rule with itself on the cube.
template <std::size_t n>
constexpr Rule<3, n * n * n> cube(const Rule<1, n>& line) {
  Rule<3, n* n* n> rule = {};
  std::size_t k = 0;
  for (const auto& z : line)
    for (const auto& [xy, weight] : square(line)) rule[k++] = {{xy[0], xy[1], z.xi[0]}, weight * z.weight};
  return rule;
}

/// The conical product [Stroud 1971] of degree 7: the cube [0, 1]³ collapsed onto the tetrahedron.
constexpr Rule<3, 64> conical_tetrahedron() {
  Rule<3, 64> rule = {};
  std::size_t k = 0;
  for (const auto& [c, wc] : gauss_jacobi_4[2])
    for (const auto& [b, wb] : gauss_jacobi_4[1])
      for (const auto& [a, wa] : gauss_jacobi_4[0])
        rule[k++] = {{a[0] * (1 - b[0]) * (1 - c[0]), b[0] * (1 - c[0]), c[0]}, wa * wb * wc};
  return rule;
}

/// The conical product of degree 9 on the triangle.
constexpr Rule<2, 25> conical_triangle() {
  Rule<2, 25> rule = {};
  std::size_t k = 0;
  for (const auto& [b, wb] : gauss_jacobi_5[1])
    for (const auto& [a, wa] : gauss_jacobi_5[0]) rule[k++] = {{a[0] * (1 - b[0]), b[0]}, wa * wb};
  return rule;
}

/// The product of a triangle's rule with one along ζ.
template <std::size_t m, std::size_t n>
constexpr Rule<3, m * n> wedge(const Rule<2, m>& triangle, const Rule<1, n>& line) {
  Rule<3, m* n> rule = {};
  std::size_t k = 0;
  for (const auto& z : line)
    for (const auto& [xy, weight] : triangle) rule[k++] = {{xy[0], xy[1], z.xi[0]}, weight * z.weight};
  return rule;
}

/// The conical product on the pyramid: the square shrinks towards the apex, and `line` has the weight (1 - ζ)².
template <std::size_t m, std::size_t n>
constexpr Rule<3, m * m * n> pyramid(const Rule<1, m>& side, const Rule<1, n>& line) {
  Rule<3, m* m* n> rule = {};
  std::size_t k = 0;
  for (const auto& [z, wz] : line)
    for (const auto& [xy, weight] : square(side))
      rule[k++] = {{xy[0] * (1 - z[0]), xy[1] * (1 - z[0]), z[0]}, weight * wz};
  return rule;
}

/// The symmetric rule of degree 6 on the triangle [Dunavant 1985].
constexpr Rule<2, 12> symmetric_triangle() {
  constexpr double a = 0.24928674517091042129, wa = 0.05839313786318968301;
  constexpr double b = 0.06308901449150222834, wb = 0.02542245318510340846;
  constexpr double c = 0.05314504984481694735, d = 0.31035245103378440542, e = 1 - c - d;
  constexpr double wc = 0.04142553780918678760;
  return {{{{a, a}, wa},
           {{a, 1 - 2 * a}, wa},
           {{1 - 2 * a, a}, wa},  //
           {{b, b}, wb},
           {{b, 1 - 2 * b}, wb},
           {{1 - 2 * b, b}, wb},  //
           {{c, d}, wc},
           {{c, e}, wc},
           {{d, c}, wc},
           {{d, e}, wc},
           {{e, c}, wc},
           {{e, d}, wc}}};
}

/// The rule of degree 2 on the tetrahedron, with the barycentric coordinates (5 - √5)/20 and (5 + 3√5)/20.
constexpr Rule<3, 4> keast_tetrahedron() {
  constexpr double a = 0.13819660112501051518, b = 0.58541019662496845446;
  return {{{{a, a, a}, 1. / 24}, {{b, a, a}, 1. / 24}, {{a, b, a}, 1. / 24}, {{a, a, b}, 1. / 24}}};
}

inline constexpr Rule<3, 1> tetrahedron_1 = {{{{0.25, 0.25, 0.25}, 1. / 6}}};  ///< degree 1
inline constexpr Rule<3, 4> tetrahedron_4 = keast_tetrahedron();               ///< degree 2
inline constexpr Rule<3, 64> tetrahedron_64 = conical_tetrahedron();           ///< degree 7
inline constexpr Rule<3, 8> cube_8 = cube(gauss_2);                            ///< degree 3 in each coordinate
inline constexpr Rule<3, 27> cube_27 = cube(gauss_3);                          ///< degree 5 in each coordinate
inline constexpr Rule<3, 125> cube_125 = cube(gauss_5);                        ///< degree 9 in each coordinate
inline constexpr Rule<2, 1> triangle_1 = {{{{1. / 3, 1. / 3}, 1. / 2}}};       ///< degree 1
inline constexpr Rule<2, 3> triangle_3 = {
    {{{1. / 6, 1. / 6}, 1. / 6}, {{2. / 3, 1. / 6}, 1. / 6}, {{1. / 6, 2. / 3}, 1. / 6}}};  ///< degree 2
inline constexpr Rule<2, 12> triangle_12 = symmetric_triangle();                            ///< degree 6
inline constexpr Rule<2, 9> square_9 = square(gauss_3);  ///< degree 5 in each coordinate

inline constexpr Rule<2, 25> triangle_25 = conical_triangle();  ///< degree 9

inline constexpr Rule<3, 2> wedge_2 = wedge(triangle_1, gauss_2);       ///< degree 1 in the triangle, 3 along ζ
inline constexpr Rule<3, 9> wedge_9 = wedge(triangle_3, gauss_3);       ///< degree 2, 5
inline constexpr Rule<3, 36> wedge_36 = wedge(triangle_12, gauss_3);    ///< degree 6, 5
inline constexpr Rule<3, 125> wedge_125 = wedge(triangle_25, gauss_5);  ///< degree 9, 9

/// Exact for polynomials of ξ/(1 - ζ), η/(1 - ζ) and ζ of these degrees.
inline constexpr Rule<3, 8> pyramid_8 = pyramid(gauss_2, gauss_jacobi_2);       ///< degree 3, 3 and 3
inline constexpr Rule<3, 36> pyramid_36 = pyramid(gauss_3, gauss_jacobi_4[2]);  ///< degree 5, 5 and 7

}  // namespace quadrature
}  // namespace ritz::fem
