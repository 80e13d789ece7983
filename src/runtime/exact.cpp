// With K = λΔt², C = dΔt and the impulse response g of x'' + C x' + K x = 0, g(0) = 0, g'(0) = 1 at time 1:
//   z_{n+1}   = (g' + C g) z + g Δt z' + Δt² [(G₁ - G₂) f_n + G₂ f_{n+1}],
//   Δt z'_{n+1} = -K g z + g' Δt z'    + Δt² [(g - G₁) f_n + G₁ f_{n+1}],
// G₁ and G₂ the first and second integral of g. They are the divided differences of exp at the roots μ₁, μ₂ and
// one or two zeros; each of the branches below is where its formula loses no more than a digit.
#include <cmath>

#include "ritz/runtime/integrator.hpp"

namespace ritz::runtime {
namespace {

// The coefficients are computed once, so they can afford the longest type there is: the phase ωΔt of a long step then
// keeps its digits. The formulas are sound in double as well.
using Real = long double;

struct Response {
  Real at_rest;  ///< g' + C g: the motion that starts with x = 1, x' = 0
  Real g, g_prime, G1, G2;
};

/// (e^x - 1) / x.
Real phi1(Real x) { return x == 0 ? 1 : std::expm1(x) / x; }

/// (e^x - 1 - x) / x², x <= 0.
Real phi2(Real x) {
  if (x < -1) return (phi1(x) - 1) / x;
  Real term = Real(0.5), sum = term;
  for (int n = 3; n < 26; ++n) sum += term *= x / n;
  return sum;
}

/// Small K and C: the Taylor series of g, whose coefficients follow from the equation of motion.
Response series(Real K, Real C) {
  Real before = 0, a = 1;  // coefficients n - 1 and n of g
  Response r{.at_rest = 0, .g = 0, .g_prime = 0, .G1 = 0, .G2 = 0};
  for (int n = 1; n < 40; ++n) {
    r.g += a;
    r.g_prime += n * a;
    r.G1 += a / (n + 1);
    r.G2 += a / ((n + 1) * (n + 2));
    const Real next = -(C * n * a + K * before) / (n * (n + 1));
    before = a;
    a = next;
  }
  r.at_rest = r.g_prime + C * r.g;
  return r;
}

/// The integrals by the equation of motion, integrated once and twice: K must not be small.
void integrate(Real K, Real C, Response& r) {
  r.G1 = (1 - r.at_rest) / K;
  r.G2 = (1 - r.g - C * r.G1) / K;
}

Response underdamped(Real K, Real C) {
  const Real w = std::sqrt(K - C * C / 4), decay = std::exp(-C / 2);
  const Real cosine = decay * std::cos(w);
  Response r{};
  r.g = w == 0 ? decay : decay * std::sin(w) / w;
  r.g_prime = cosine - C / 2 * r.g;
  r.at_rest = cosine + C / 2 * r.g;
  integrate(K, C, r);
  return r;
}

Response overdamped(Real K, Real C) {
  const Real delta = std::sqrt(C * C / 4 - K);
  const Real fast = -(C / 2 + delta), slow = K / fast;  // the roots; their difference is 2 delta
  Response r{};
  r.g = std::exp(slow) * phi1(-2 * delta);
  r.g_prime = std::exp(fast) + slow * r.g;
  r.at_rest = std::exp(fast) - fast * r.g;
  if (delta < C / 4) {
    integrate(K, C, r);
  } else {
    r.G1 = (phi1(slow) - phi1(fast)) / (2 * delta);
    r.G2 = (phi2(slow) - phi2(fast)) / (2 * delta);
  }
  return r;
}

Response response(Real K, Real C) {
  if (K <= 2 && C <= 2) return series(K, C);
  return K >= C * C / 4 ? underdamped(K, C) : overdamped(K, C);
}

OscillatorStep exact_step(double stiffness, double damping, double dt) {
  const Real h = dt, K = Real(stiffness) * h * h;
  const Response r = response(K, Real(damping) * h);
  const auto number = [](Real x) { return static_cast<double>(x); };
  OscillatorStep step;
  step.A.topLeftCorner<2, 2>() << number(r.at_rest), number(h * r.g), number(-stiffness * h * r.g), number(r.g_prime);
  step.b.head<2>() << number(h * h * (r.G1 - r.G2)), number(h * (r.g - r.G1));
  step.c.head<2>() << number(h * h * r.G2), number(h * r.G1);
  return step;
}

}  // namespace

Integrator exact() { return {"exact", History::none, exact_step}; }

}  // namespace ritz::runtime
