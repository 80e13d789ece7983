#include "ritz/fem/laws/orthotropic.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

#include "ritz/fem/laws/stvk.hpp"

namespace ritz::fem {
namespace {

/// The components xx yy zz xy yz zx of a symmetric tensor: rows and columns of each.
constexpr int component_row[6] = {0, 1, 2, 0, 1, 2}, component_column[6] = {0, 1, 2, 1, 2, 0};

Matrix<3, 3> tensor(const Vector<6>& stress) {
  Matrix<3, 3> S;
  for (int k = 0; k < 6; ++k)
    S(component_row[k], component_column[k]) = S(component_column[k], component_row[k]) = stress[k];
  return S;
}

/// xx yy zz 2xy 2yz 2zx.
Vector<6> doubled_shear(const Matrix<3, 3>& E) {
  Vector<6> e;
  for (int k = 0; k < 6; ++k)
    e[k] = E(component_row[k], component_column[k]) + (k < 3 ? 0 : E(component_column[k], component_row[k]));
  return e;
}

/// C in the axes of the material.
Matrix<6, 6> along_axes(const OrthotropicStVK::Values& v) {
  const auto [e1, e2, e3, nu12, nu13, nu23, g12, g13, g23, x1, y1, z1, x2, y2, z2] = v;
  Matrix<3, 3> compliance;
  compliance << 1 / e1, -nu12 / e1, -nu13 / e1,  //
      -nu12 / e1, 1 / e2, -nu23 / e2,            //
      -nu13 / e1, -nu23 / e2, 1 / e3;
  Matrix<6, 6> C = Matrix<6, 6>::Zero();
  const Matrix<3, 3> stiffness = compliance.inverse();
  C.topLeftCorner<3, 3>() = (stiffness + stiffness.transpose()) / 2;
  C.diagonal().tail<3>() << g12, g23, g13;
  return C;
}

/// The axes of the material, a row each.
Matrix<3, 3> axes_of(const OrthotropicStVK::Values& v) {
  const Vector<3> given1 = Eigen::Map<const Vector<3>>(v.data() + 9).stableNormalized(),
                  given2 = Eigen::Map<const Vector<3>>(v.data() + 12).stableNormalized();
  Matrix<3, 3> Q;
  Q.row(0) = given1;
  Q.row(2) = given1.cross(given2).stableNormalized();
  Q.row(1) = Q.row(2).cross(Q.row(0));
  return Q;
}

Matrix<6, 6> turned(const Matrix<6, 6>& C, const Matrix<3, 3>& Q) {
  Matrix<6, 6> strain;  // from the coordinates' strain to that along the axes
  for (int k = 0; k < 6; ++k)
    strain.col(k) = doubled_shear(Q * tensor(Vector<6>::Unit(k) / (k < 3 ? 1 : 2)) * Q.transpose());
  const Matrix<6, 6> result = strain.transpose() * C * strain;
  return (result + result.transpose()) / 2;
}

}  // namespace

OrthotropicStVK::OrthotropicStVK(const Values& values)
    : values_(values), hooke_(turned(along_axes(values), axes_of(values))) {}

std::optional<OrthotropicStVK> OrthotropicStVK::of_constants(std::span<const double> given) {
  if (given.size() != 9) return std::nullopt;
  Values values{0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  std::ranges::copy(given, values.begin());
  return OrthotropicStVK(values);
}

ElasticConstants OrthotropicStVK::at_rest() const { return ElasticConstants::anisotropic(hooke_); }

double OrthotropicStVK::angle_of_axes() const {
  return Eigen::Map<const Vector<3>>(values_.data() + 9)
      .stableNormalized()
      .cross(Eigen::Map<const Vector<3>>(values_.data() + 12).stableNormalized())
      .norm();
}

Response OrthotropicStVK::response(const Matrix<3, 3>& G) const {
  const Matrix<3, 3> E = StVK::strain(G), S = tensor(hooke_ * doubled_shear(E));
  return {S.cwiseProduct(E).sum() / 2, S + G * S};
}

Moduli OrthotropicStVK::moduli(const Matrix<3, 3>& G) const {
  const Matrix<3, 3> I = Matrix<3, 3>::Identity(), F = I + G;
  Moduli A = Moduli::of_products(I, 0, 0);
  for (int j = 0; j < 3; ++j)
    for (int l = 0; l < 3; ++l) {
      Matrix<3, 3> between;  // C_mjnl
      for (int m = 0; m < 3; ++m)
        for (int n = 0; n < 3; ++n) between(m, n) = hooke_(strain_component(m, j), strain_component(n, l));
      const Matrix<3, 3> both = F * between * F.transpose();
      for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i) A(i, j, k, l) = both(i, k);
    }
  A.add_product(I, tensor(hooke_ * doubled_shear(StVK::strain(G))));
  return A;
}

}  // namespace ritz::fem
