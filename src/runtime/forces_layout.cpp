#include <algorithm>
#include <array>
#include <string>

#include "kernels.hpp"
#include "ritz/base/error.hpp"
#include "ritz/runtime/forces.hpp"
#include "simd.hpp"

namespace ritz::runtime {
namespace {

using Eigen::Index;

/// C(n, k) for k ≤ 4.
Index binomial(Index n, int k) {
  Index value = 1;
  for (int i = 1; i <= k; ++i) value = value * (n - k + i) / i;
  return value;
}

/// Where the entry i ≤ j ≤ ... of a fully symmetric tensor over r indices stands in lexicographic order: all less those
/// that come after it, which with the indices counted from the back is a sum of binomials.
template <int order>
Index position(Index r, std::array<Index, order> at) {
  std::ranges::sort(at);
  Index after = 0;
  for (int s = 0; s < order; ++s) after += binomial(r - 1 - at[s] + order - 1 - s, order - s);
  return binomial(r + order - 1, order) - 1 - after;
}

struct Pair {
  Index i, j;
};

std::vector<Pair> all_pairs(Index r) {
  std::vector<Pair> pairs;
  for (Index i = 0; i < r; ++i)
    for (Index j = i; j < r; ++j) pairs.push_back({i, j});
  return pairs;
}

void require_sizes(const model::Polynomial& p) {
  const bool fits = p.r > 0 && p.quadratic.size() == binomial(p.r + 1, 2) && p.cubic.size() == binomial(p.r + 2, 3) &&
                    p.quartic.size() == binomial(p.r + 3, 4);
  if (!fits)
    throw InputError("the polynomial does not have the coefficients of " + std::to_string(p.r) +
                     " coordinates: reduce the model again");
}

template <class Scalar>
void lay_out_quartic(const model::Polynomial& polynomial, const std::vector<Pair>& pairs, Forces<Scalar>& forces) {
  constexpr Index width = lanes<Scalar>;
  const auto count = static_cast<Index>(pairs.size());
  const auto entry = [&](Index p, Index q) -> Scalar {
    if (q < p || q >= count) return 0;
    const auto [i, j] = pairs[static_cast<std::size_t>(p)];
    const auto [k, l] = pairs[static_cast<std::size_t>(q)];
    const double value = polynomial.quartic[position<4>(polynomial.r, {i, j, k, l})];
    return static_cast<Scalar>(p == q ? value / 2 : value);
  };
  for (Index row = 0; row < forces.pairs; row += tile_rows)
    for (Index column = row / width * width; column < forces.pairs; column += width)
      for (Index p = row; p < row + tile_rows; ++p)
        for (Index q = column; q < column + width; ++q) forces.quartic.push_back(entry(p, q));
}

}  // namespace

template <class Scalar>
Forces<Scalar> make_forces(const model::Polynomial& polynomial) {
  require_sizes(polynomial);
  const Index r = polynomial.r;
  const auto pairs = all_pairs(r);
  Forces<Scalar> forces;
  forces.r = r;
  forces.pairs = (std::ssize(pairs) + lanes<Scalar> - 1) / lanes<Scalar> * lanes<Scalar>;
  forces.linear = polynomial.quadratic.cast<Scalar>();
  forces.cubic.assign(static_cast<std::size_t>(forces.pairs * r), 0);
  for (Index k = 0; k < r; ++k)
    for (std::size_t p = 0; p < pairs.size(); ++p)
      forces.cubic[static_cast<std::size_t>(k * forces.pairs) + p] =
          static_cast<Scalar>(polynomial.cubic[position<3>(r, {pairs[p].i, pairs[p].j, k})]);
  forces.quartic.reserve(static_cast<std::size_t>(forces.pairs * (forces.pairs + 2 * lanes<Scalar>) / 2));
  lay_out_quartic(polynomial, pairs, forces);
  return forces;
}

template <class Scalar>
Matrix<Scalar> rest_tangent(const Forces<Scalar>& forces) {
  Matrix<Scalar> A(forces.r, forces.r);
  for (Index i = 0, p = 0; i < forces.r; ++i)
    for (Index j = i; j < forces.r; ++j, ++p) A(i, j) = A(j, i) = forces.linear[p];
  return A;
}

template Forces<double> make_forces(const model::Polynomial&);
template Forces<float> make_forces(const model::Polynomial&);
template Matrix<double> rest_tangent(const Forces<double>&);
template Matrix<float> rest_tangent(const Forces<float>&);

}  // namespace ritz::runtime
