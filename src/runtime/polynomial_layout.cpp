#include <array>
#include <string>

#include "ritz/base/error.hpp"
#include "ritz/base/simd.hpp"
#include "ritz/runtime/polynomial_force.hpp"

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
template <std::size_t size>
Index position(Index r, const std::array<Index, size>& at) {
  constexpr int order = size;
  Index after = 0;
  for (int s = 0; s < order; ++s) after += binomial(r - 1 - at[s] + order - 1 - s, order - s);
  return binomial(r + order - 1, order) - 1 - after;
}

/// The factorials of how often an index of i ≤ j ≤ ... is repeated.
template <std::size_t size>
double repeats(const std::array<Index, size>& at) {
  double product = 1;
  int same = 1;
  for (std::size_t s = 1; s < size; ++s) {
    same = at[s] == at[s - 1] ? same + 1 : 1;
    product *= same;
  }
  return product;
}

void require_sizes(const model::Polynomial& p) {
  const bool fits = p.r > 0 && p.quadratic.size() == binomial(p.r + 1, 2) && p.cubic.size() == binomial(p.r + 2, 3) &&
                    p.quartic.size() == binomial(p.r + 3, 4);
  if (!fits)
    throw InputError("the polynomial does not have the coefficients of " + std::to_string(p.r) +
                     " coordinates: reduce the model again");
}

/// Appends the coefficients of i0, i0 + 1, ..., a register's, with the other indices, which ascend.
template <class Scalar, class... Others>
void append(const Eigen::VectorXd& unique, Index r, Index i0, AlignedVector<Scalar>& to, Others... others) {
  for (Index i = i0; i < i0 + lanes<Scalar>; ++i) {
    const std::array at{i, others...};
    to.push_back(i > at[1] ? Scalar(0) : static_cast<Scalar>(unique[position(r, at)] / repeats(at)));
  }
}

template <class Scalar>
AlignedVector<Scalar> lay_out_cubic(const model::Polynomial& polynomial) {
  const Index r = polynomial.r;
  AlignedVector<Scalar> to;
  for (Index i0 = 0; i0 < r; i0 += lanes<Scalar>)
    for (Index k = i0; k < r; ++k)
      for (Index l = k; l < r; ++l) append(polynomial.cubic, r, i0, to, k, l);
  return to;
}

/// How many coefficients that makes: two slices of n = r − j rows and one less have n² together.
template <class Scalar>
std::size_t quartic_size(Index r) {
  Index registers = 0;
  for (Index i0 = 0; i0 < r; i0 += lanes<Scalar>)
    for (Index j = i0; j < r; j += 2) registers += (r - j) * (r - j);
  return static_cast<std::size_t>(registers * lanes<Scalar>);
}

template <class Scalar>
AlignedVector<Scalar> lay_out_quartic(const model::Polynomial& polynomial) {
  const Index r = polynomial.r;
  AlignedVector<Scalar> to;
  to.reserve(quartic_size<Scalar>(r));
  const auto append_to = [&](Index i0, Index j, Index k, Index l) { append(polynomial.quartic, r, i0, to, j, k, l); };
  for (Index i0 = 0; i0 < r; i0 += lanes<Scalar>)
    for (Index j = i0; j < r; j += 2) {
      for (Index l = j; l < r; ++l) append_to(i0, j, j, l);
      for (Index k = j + 1; k < r; k += 2) {
        append_to(i0, j, k, k);
        append_to(i0, j + 1, k, k);
        for (Index l = k + 1; l < r; ++l)
          for (const Index row : {k, k + 1})
            for (const Index slice : {j, j + 1}) append_to(i0, slice, row, l);
      }
    }
  return to;
}

}  // namespace

template <class Scalar>
PolynomialForce<Scalar> make_polynomial_force(const model::Polynomial& polynomial) {
  require_sizes(polynomial);
  const Index r = polynomial.r;
  PolynomialForce<Scalar> forces{.r = r,
                                 .linear = Matrix<Scalar>(r, r),
                                 .cubic = lay_out_cubic<Scalar>(polynomial),
                                 .quartic = lay_out_quartic<Scalar>(polynomial)};
  for (Index i = 0, at = 0; i < r; ++i)
    for (Index j = i; j < r; ++j, ++at)
      forces.linear(i, j) = forces.linear(j, i) = static_cast<Scalar>(polynomial.quadratic[at]);
  return forces;
}

template PolynomialForce<double> make_polynomial_force(const model::Polynomial&);
template PolynomialForce<float> make_polynomial_force(const model::Polynomial&);

}  // namespace ritz::runtime
