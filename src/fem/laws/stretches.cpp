#include "ritz/fem/laws/stretches.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "volume.hpp"

namespace ritz::fem {
namespace {

/// e^x − 1 − x, with full relative precision for small x.
double exponential_remainder(double x) {
  if (std::abs(x) > .5) return std::expm1(x) - x;
  double tail = 1;  // 1 + x/3 (1 + x/4 (1 + …)), the last term below 1e-17
  for (int k = 16; k > 2; --k) tail = 1 + x / k * tail;
  return x * x / 2 * tail;
}

/// sinh(x)/x.
double sinhc(double x) {
  if (std::abs(x) > .5) return std::sinh(x) / x;
  double sum = 1;
  for (int k = 7; k > 0; --k) sum = 1 + x * x / (2 * k * (2 * k + 1)) * sum;
  return sum;
}

/// The principal stretches of a state, with full relative precision of λ_a − 1 and ln λ_a for small strains.
struct Stretched {
  Vector<3> stretch, less_one, log;
  Matrix<3, 3> axes;    ///< N_a, a column each, of the body at rest
  Matrix<3, 3> turned;  ///< n_a = F N_a/λ_a
  double change;        ///< J − 1

  explicit Stretched(const Matrix<3, 3>& G) : change(G.trace() + nonlinear_volume_change(G)) {
    const Eigen::SelfAdjointEigenSolver<Matrix<3, 3>> eigen((G + G.transpose() + G.transpose() * G) / 2);
    axes = eigen.eigenvectors();
    const Vector<3> twice = 2 * eigen.eigenvalues();  // λ² − 1
    for (int a = 0; a < 3; ++a) {
      stretch[a] = std::sqrt(1 + twice[a]);
      less_one[a] = twice[a] / (1 + stretch[a]);
      log[a] = std::log1p(twice[a]) / 2;
    }
    turned = (axes + G * axes) * stretch.cwiseInverse().asDiagonal();
  }
  bool admitted() const { return change > -1; }
};

/// The energy w of the stretches with its derivatives, Pa: p_a = ∂w/∂λ_a, their derivatives by λ_b, and the difference
/// quotients (p_a − p_b)/(λ_a − λ_b), which are the derivatives' limits where two stretches coincide.
struct Principal {
  double energy;
  Vector<3> p;
  Matrix<3, 3> derivatives, quotients;  ///< the diagonal of `quotients` is unused
};

/// The same from derivatives by e_a = ln λ_a: τ_a = ∂w/∂e_a, ∂τ_a/∂e_b, and (τ_a − τ_b)/(e_a − e_b).
Principal of_logarithms(const Stretched& s, double energy, const Vector<3>& tau, const Matrix<3, 3>& by_log,
                        const Matrix<3, 3>& quotients) {
  Principal w{energy, tau.cwiseQuotient(s.stretch), {}, Matrix<3, 3>::Zero()};
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      const double product = s.stretch[a] * s.stretch[b];
      w.derivatives(a, b) = (by_log(a, b) - (a == b ? tau[a] : 0)) / product;
      if (a == b) continue;
      // (e_a − e_b)/(λ_a − λ_b) = 1/(√(λ_aλ_b) sinhc((e_a − e_b)/2)), and the mean of τ/λ's two splittings.
      const double by_stretch = quotients(a, b) / (std::sqrt(product) * sinhc((s.log[a] - s.log[b]) / 2));
      w.quotients(a, b) = (by_stretch * (s.stretch[a] + s.stretch[b]) - (tau[a] + tau[b])) / (2 * product);
    }
  return w;
}

struct Term {
  double mu, alpha;
};

Principal principal(const Ogden& law, const Stretched& s) {
  const double mean = s.log.sum() / 3;
  const Volume U = powers_of_volume(s.change, {law.d1, law.d2, law.d3});
  const double J = 1 + s.change;
  double energy = U.energy;
  Vector<3> tau = Vector<3>::Constant(J * U.first);
  Matrix<3, 3> by_log = Matrix<3, 3>::Constant(J * (U.first + J * U.second)), quotients = Matrix<3, 3>::Zero();
  for (const auto& [mu, alpha] : {Term{law.mu1, law.alpha1}, Term{law.mu2, law.alpha2}, Term{law.mu3, law.alpha3}}) {
    if (mu == 0) continue;
    Vector<3> y;  // λ̄_a^α − 1
    for (int a = 0; a < 3; ++a) {
      y[a] = std::expm1(alpha * (s.log[a] - mean));
      energy += 2 * mu / (alpha * alpha) * exponential_remainder(alpha * (s.log[a] - mean));
    }
    const double middle = y.sum() / 3;
    tau.array() += 2 * mu / alpha * (y.array() - middle);
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) {
        by_log(a, b) += 2 * mu * ((a == b ? 1 + y[a] : 0) - (1 + y[a] + y[b] - middle) / 3);
        const double between = (s.log[a] + s.log[b]) / 2 - mean, apart = (s.log[a] - s.log[b]) / 2;
        quotients(a, b) += 2 * mu * std::exp(alpha * between) * sinhc(alpha * apart);
      }
  }
  return of_logarithms(s, energy, tau, by_log, quotients);
}

Principal principal(const Hencky& law, const Stretched& s) {
  const double lambda = lame_lambda(law.young, law.poisson), mu = shear_modulus(law.young, law.poisson);
  const double sum = s.log.sum();
  Matrix<3, 3> by_log = Matrix<3, 3>::Constant(lambda);
  by_log.diagonal().array() += 2 * mu;
  return of_logarithms(s, mu * s.log.squaredNorm() + lambda / 2 * sum * sum,
                       (2 * mu * s.log.array() + lambda * sum).matrix(), by_log, Matrix<3, 3>::Constant(2 * mu));
}

Principal principal(const Corotational& law, const Stretched& s) {
  const double lambda = lame_lambda(law.young, law.poisson), mu = shear_modulus(law.young, law.poisson);
  const double sum = s.less_one.sum();
  Principal w{mu * s.less_one.squaredNorm() + lambda / 2 * sum * sum,
              (2 * mu * s.less_one.array() + lambda * sum).matrix(), Matrix<3, 3>::Constant(lambda),
              Matrix<3, 3>::Constant(2 * mu)};
  w.derivatives.diagonal().array() += 2 * mu;
  return w;
}

/// P = Σ p_a n_a N_aᵀ.
template <class Law>
Response response_of(const Law& law, const Matrix<3, 3>& G) {
  const Stretched s(G);
  if (!s.admitted()) return unknown();
  const Principal w = principal(law, s);
  return {w.energy, s.turned * w.p.asDiagonal() * s.axes.transpose()};
}

/// The second derivative of W by F is Σ_ab ∂p_a/∂λ_b A_a ⊗ A_b with A_a = n_a N_aᵀ, and for each pair of axes
/// ½ (p_a − p_b)/(λ_a − λ_b) L ⊗ L + ½ (p_a + p_b)/(λ_a + λ_b) T ⊗ T with L = n_a N_bᵀ + n_b N_aᵀ and
/// T = n_a N_bᵀ − n_b N_aᵀ [Smith, De Goes and Kim 2019, Analytic eigensystems for isotropic distortion energies].
template <class Law>
Moduli moduli_of(const Law& law, const Matrix<3, 3>& G) {
  const Stretched s(G);
  if (!s.admitted()) return Moduli::unknown();
  const Principal w = principal(law, s);
  const auto outer = [&](int a, int b) -> Matrix<3, 3> { return s.turned.col(a) * s.axes.col(b).transpose(); };
  Moduli A = Moduli::of_products(outer(0, 0), w.derivatives(0, 0), 0);
  for (int a = 0; a < 3; ++a) {
    if (a > 0) A.add_products(outer(a, a), w.derivatives(a, a), 0);
    const int b = (a + 1) % 3;
    A.add_dyads(outer(a, a), outer(b, b), w.derivatives(a, b));
    A.add_products(outer(a, b) + outer(b, a), w.quotients(a, b) / 2, 0);
    A.add_products(outer(a, b) - outer(b, a), (w.p[a] + w.p[b]) / (2 * (s.stretch[a] + s.stretch[b])), 0);
  }
  return A;
}

}  // namespace

std::optional<Ogden> Ogden::of_constants(std::span<const double> given) {
  if (given.size() != 3 && given.size() != 5 && given.size() != 7) return std::nullopt;
  Ogden law{.mu1 = given[0], .alpha1 = given[1], .d1 = given.back()};
  if (given.size() > 3) law.mu2 = given[2], law.alpha2 = given[3];
  if (given.size() > 5) law.mu3 = given[4], law.alpha3 = given[5];
  return law;
}

/// From Σ (λ̄_a^α − 3) = α²/2 tr H'² + α³/6 tr H'³ + … with the deviator H' of H = ½ ln(1 + 2E) = E − E² + 4/3 E³ − ….
ElasticConstants Ogden::at_rest() const {
  const double mu = mu1 + mu2 + mu3, third = mu1 * alpha1 + mu2 * alpha2 + mu3 * alpha3;
  const ElasticConstants of_volume = volume_at_rest(d1);
  return {of_volume.lambda - 2. / 3 * mu, mu, third - 6 * mu, of_volume.B + (2 * mu - third) / 3,
          of_volume.C + 2. / 9 * third};
}
Response Ogden::response(const Matrix<3, 3>& G) const { return response_of(*this, G); }
Moduli Ogden::moduli(const Matrix<3, 3>& G) const { return moduli_of(*this, G); }

/// From tr H² = t₂ − 2 t₃ + … and tr²H = t₁² − 2 t₁t₂ + … with t_k = tr E^k.
ElasticConstants Hencky::at_rest() const {
  const double lambda = lame_lambda(young, poisson), mu = shear_modulus(young, poisson);
  return {lambda, mu, -6 * mu, -lambda, 0};
}
Response Hencky::response(const Matrix<3, 3>& G) const { return response_of(*this, G); }
Moduli Hencky::moduli(const Matrix<3, 3>& G) const { return moduli_of(*this, G); }

/// From √(1 + 2E) − 1 = E − ½ E² + …: the squares are t₂ − t₃ + … and t₁² − t₁t₂ + ….
ElasticConstants Corotational::at_rest() const {
  const double lambda = lame_lambda(young, poisson), mu = shear_modulus(young, poisson);
  return {lambda, mu, -3 * mu, -lambda / 2, 0};
}
Response Corotational::response(const Matrix<3, 3>& G) const { return response_of(*this, G); }
Moduli Corotational::moduli(const Matrix<3, 3>& G) const { return moduli_of(*this, G); }

}  // namespace ritz::fem
