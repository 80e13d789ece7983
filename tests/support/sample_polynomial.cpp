#include "support/sample_polynomial.hpp"

#include <cmath>
#include <random>

namespace ritz::test {

double StrainEnergy::energy(const Eigen::VectorXd& z) const {
  double sum = 0;
  for (Eigen::Index m = 0; m < a.rows(); ++m) sum += 0.5 * std::pow(strain(m, z), 2);
  return sum;
}

double StrainEnergy::strain(Eigen::Index m, const Eigen::VectorXd& z) const {
  return a.row(m).dot(z) + 0.5 * z.dot(Q[static_cast<std::size_t>(m)] * z);
}

model::Polynomial polynomial_of(const StrainEnergy& e) {
  const Eigen::Index r = e.a.cols(), n2 = r * (r + 1) / 2, n3 = n2 * (r + 2) / 3, n4 = n3 * (r + 3) / 4;
  model::Polynomial p{r, Eigen::VectorXd::Zero(n2), Eigen::VectorXd::Zero(n3), Eigen::VectorXd::Zero(n4)};
  for (Eigen::Index m = 0; m < e.a.rows(); ++m) {
    const auto& Q = e.Q[static_cast<std::size_t>(m)];
    const auto a = e.a.row(m);
    Eigen::Index at2 = 0, at3 = 0, at4 = 0;
    for (Eigen::Index i = 0; i < r; ++i)
      for (Eigen::Index j = i; j < r; ++j) {
        p.quadratic[at2++] += a[i] * a[j];
        for (Eigen::Index k = j; k < r; ++k) {
          p.cubic[at3++] += a[i] * Q(j, k) + a[j] * Q(i, k) + a[k] * Q(i, j);
          for (Eigen::Index l = k; l < r; ++l)
            p.quartic[at4++] += Q(i, j) * Q(k, l) + Q(i, k) * Q(j, l) + Q(i, l) * Q(j, k);
        }
      }
  }
  return p;
}

StrainEnergy random_strains(Eigen::Index r, double stiffest, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  const auto random = [&] { return normal(generator); };
  StrainEnergy e{Eigen::MatrixXd::Zero(r + 2, r), {}};
  for (Eigen::Index m = 0; m < r + 2; ++m) {
    const double omega =
        r == 1 ? 1 : std::pow(stiffest, static_cast<double>(std::min(m, r - 1)) / static_cast<double>(r - 1));
    if (m < r) e.a(m, m) = omega;
    const Eigen::MatrixXd some = Eigen::MatrixXd::NullaryExpr(r, r, random);
    e.Q.push_back(omega / static_cast<double>(r) * (some + some.transpose()));
  }
  return e;
}

model::Polynomial random_polynomial(Eigen::Index r, double stiffest, unsigned seed) {
  return polynomial_of(random_strains(r, stiffest, seed));
}

model::Polynomial duffing(double lambda, double gamma) {
  using Eigen::VectorXd;
  return {1, VectorXd::Constant(1, lambda), VectorXd::Zero(1), VectorXd::Constant(1, 6 * gamma)};
}

model::Polynomial linear_part(model::Polynomial p) {
  p.cubic.setZero();
  p.quartic.setZero();
  return p;
}

}  // namespace ritz::test
