#include "ritz/runtime/cubature_force.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "cubature_kernels.hpp"
#include "ritz/base/error.hpp"

namespace ritz::runtime {
namespace {

using Eigen::Index;

constexpr Index nine = 9;
constexpr Index read_ahead = 6;  ///< numbers that add_tangent may read behind the last column

[[noreturn]] void refuse(const std::string& what) {
  throw InputError("the cubature of the model cannot be used: " + what + "; reduce the model again");
}

void require_shapes(const model::Cubature& c, std::size_t materials) {
  const auto T = c.cells.size();
  if (T == 0) refuse("it has no cells");
  if (static_cast<std::size_t>(c.weights.size()) != T || c.regions.size() != T || c.starts.size() != T + 1 ||
      c.starts.front() != 0 || c.starts.back() != c.volumes.size() || c.gradients.rows() != nine * c.volumes.size() ||
      c.gradients.cols() == 0 || !std::ranges::is_sorted(c.starts))
    refuse("the numbers of its cells, points and columns do not fit each other");
  if (!(c.weights.minCoeff() > 0)) refuse("a weight is not positive");
  for (const auto region : c.regions)
    if (region < 0 || region >= static_cast<std::int64_t>(materials)) refuse("a cell has a region that is not there");
}

std::optional<fem::Lame> law_of_polynomial(const model::RegionMaterial& region, model::Integrand integrand) {
  if (integrand == model::Integrand::energy) return std::nullopt;
  if (fem::force_degree({region.material}))
    refuse("it has cells of region '" + region.region + "', whose forces the polynomial has already");
  const auto rest = region.material.at_rest();
  return fem::Lame{rest.lambda, rest.mu};
}

/// What a point contributes: the law, less that of the polynomial.
struct Contribution {
  std::array<fem::Matrix<3, 3>, most_points> gradients;
  std::array<fem::Response, most_points> responses;
  std::array<fem::Moduli, most_points> moduli;

  std::span<const fem::Matrix<3, 3>> at(Index count) const {
    return std::span(gradients).first(static_cast<std::size_t>(count));
  }

  void compute(const CubaturePoints& law, Index count) {
    const auto n = static_cast<std::size_t>(count);
    fem::respond(law.material, at(count), std::span(responses).first(n));
    fem::linearise(law.material, at(count), std::span(moduli).first(n));
    if (!law.less) return;
    for (std::size_t p = 0; p < n; ++p) {
      const auto less = fem::stvk_response(*law.less, gradients[p]);
      responses[p].energy -= less.energy;
      responses[p].stress -= less.stress;
    }
  }
};

/// v A as a 9 x 9 matrix, whose row 3j + i and column 3l + k hold A_ijkl, less that of the polynomial's law.
template <class Scalar>
void write_moduli(const fem::Moduli& moduli, const std::optional<fem::Lame>& less, const fem::Matrix<3, 3>& G,
                  double volume, Scalar* A) {
  const double* from = moduli.data();
  const auto write = [&](auto value) {
    for (Index n = 0; n < nine; ++n)
      for (Index j = 0; j < 3; ++j)
        for (Index i = 0; i < 3; ++i) *A++ = static_cast<Scalar>(volume * value(12 * n + 4 * j + i));
  };
  if (!less) return write([&](Index at) { return from[at]; });
  const auto other = fem::stvk_moduli(*less, G);
  const double* minus = other.data();
  write([&](Index at) { return from[at] - minus[at]; });
}

/// Where the arrays of Evaluation::room begin: ΓᵀA of some points, then K̃.
template <class Scalar>
Index changes_size(Index r) {
  return nine * most_points * padded<Scalar>(r);
}

}  // namespace

template <class Scalar>
CubatureForce<Scalar> make_cubature_force(const model::Cubature& cubature,
                                          std::span<const model::RegionMaterial> materials,
                                          const model::Polynomial* polynomial) {
  require_shapes(cubature, materials.size());
  const Index r = cubature.gradients.cols(), rows = padded<Scalar>(r), points = cubature.volumes.size();
  CubatureForce<Scalar> force{.r = r, .laws = {}, .volumes = {}, .gradients = {}, .polynomial = {}};
  if (cubature.integrand == model::Integrand::beyond_polynomial) {
    if (!polynomial) refuse("the polynomial is missing whose rest it integrates");
    if (polynomial->r != r) refuse("its polynomial has another number of coordinates");
    force.polynomial = make_polynomial_force<Scalar>(*polynomial);
  }
  force.gradients.assign(static_cast<std::size_t>(nine * points * rows + read_ahead), Scalar(0));
  for (std::size_t region = 0; region < materials.size(); ++region) {
    const auto first = std::ssize(force.volumes);
    for (std::size_t c = 0; c < cubature.cells.size(); ++c) {
      if (cubature.regions[c] != static_cast<std::int64_t>(region)) continue;
      for (Index p = cubature.starts[c]; p < cubature.starts[c + 1]; ++p) {
        auto* to = force.gradients.data() + std::ssize(force.volumes) * nine * rows;
        Eigen::Map<Matrix<Scalar>>(to, rows, nine).topRows(r) =
            cubature.gradients.middleRows(nine * p, nine).transpose().template cast<Scalar>();
        force.volumes.push_back(cubature.weights[static_cast<Index>(c)] * cubature.volumes[p]);
      }
    }
    if (const auto count = std::ssize(force.volumes) - first; count > 0)
      force.laws.push_back(
          {materials[region].material, law_of_polynomial(materials[region], cubature.integrand), first, count});
  }
  return force;
}

template <class Scalar>
Evaluation<Scalar> make_evaluation(const CubatureForce<Scalar>& force) {
  const Index r = force.r, rows = padded<Scalar>(r);
  Evaluation<Scalar> evaluation;
  evaluation.force = Vector<Scalar>::Zero(r);
  evaluation.tangent = Matrix<Scalar>::Zero(r, r);
  evaluation.point.assign(static_cast<std::size_t>(rows), Scalar(0));
  evaluation.result.assign(static_cast<std::size_t>(rows), Scalar(0));
  evaluation.room.assign(static_cast<std::size_t>(changes_size<Scalar>(r) + rows * tangent_columns(r)), Scalar(0));
  if (force.polynomial) evaluation.inner.push_back(make_evaluation(*force.polynomial));
  return evaluation;
}

template <class Scalar>
void evaluate(const CubatureForce<Scalar>& force, const VectorRef<Scalar>& z, Evaluation<Scalar>& result) {
  const Index r = force.r, rows = padded<Scalar>(r);
  Scalar* const tangent = result.room.data() + changes_size<Scalar>(r);
  std::fill(tangent, result.room.data() + result.room.size(), Scalar(0));
  std::ranges::fill(result.result, Scalar(0));
  std::ranges::copy(z, result.point.begin());

  double energy = 0;
  Contribution of_points;
  std::array<Scalar, nine * most_points> stress;
  std::array<Scalar, nine * nine * most_points> A;
  for (const auto& law : force.laws)
    for (Index first = law.first, end = law.first + law.count; first < end; first += most_points) {
      const Index count = std::min(most_points, end - first);
      const Scalar* gradients = force.gradients.data() + first * nine * rows;
      displacement_gradients(rows, count, gradients, result.point.data(), of_points.gradients[0].data());
      of_points.compute(law, count);
      for (Index p = 0; p < count; ++p) {
        const auto n = static_cast<std::size_t>(p);
        const double volume = force.volumes[static_cast<std::size_t>(first + p)];
        energy += volume * of_points.responses[n].energy;
        for (Index m = 0; m < nine; ++m)
          stress[static_cast<std::size_t>(nine * p + m)] =
              static_cast<Scalar>(volume * of_points.responses[n].stress.data()[m]);
        write_moduli(of_points.moduli[n], law.less, of_points.gradients[n], volume, A.data() + nine * nine * p);
      }
      add_force(rows, count, gradients, stress.data(), result.result.data());
      add_tangent(rows, r, count, gradients, A.data(), result.room.data(), tangent);
    }

  result.energy = static_cast<Scalar>(energy);
  result.force = Eigen::Map<const Vector<Scalar>>(result.result.data(), r);
  for (Index j = 0; j < r; ++j) {
    const Eigen::Map<const Vector<Scalar>> column(tangent + j * rows, rows);
    result.tangent.col(j).tail(r - j) = column.segment(j, r - j);
    result.tangent.row(j).tail(r - j) = result.tangent.col(j).tail(r - j);
  }
  if (!force.polynomial) return;
  auto& polynomial = result.inner.front();
  evaluate<Scalar>(*force.polynomial, z, polynomial);
  result.energy += polynomial.energy;
  result.force += polynomial.force;
  result.tangent += polynomial.tangent;
}

template <class Scalar>
bool admits(const CubatureForce<Scalar>& force, const VectorRef<Scalar>& z, Evaluation<Scalar>& room) {
  const Index rows = padded<Scalar>(force.r);
  std::ranges::copy(z, room.point.begin());
  double energy = static_cast<double>(z.sum());
  Contribution of_points;
  for (const auto& law : force.laws)
    for (Index first = law.first, end = law.first + law.count; first < end; first += most_points) {
      const Index count = std::min(most_points, end - first);
      displacement_gradients(rows, count, force.gradients.data() + first * nine * rows, room.point.data(),
                             of_points.gradients[0].data());
      const auto responses = std::span(of_points.responses).first(static_cast<std::size_t>(count));
      fem::respond(law.material, of_points.at(count), responses);
      for (const auto& response : responses) energy += response.energy;
    }
  return std::isfinite(energy);
}

template <class Scalar>
Matrix<Scalar> stiffness_at_rest(const CubatureForce<Scalar>& force) {
  auto evaluation = make_evaluation(force);
  evaluate<Scalar>(force, Vector<Scalar>::Zero(force.r), evaluation);
  return evaluation.tangent;
}

#define RITZ_INSTANCE(S)                                                                                        \
  template CubatureForce<S> make_cubature_force(const model::Cubature&, std::span<const model::RegionMaterial>, \
                                                const model::Polynomial*);                                      \
  template Evaluation<S> make_evaluation(const CubatureForce<S>&);                                              \
  template void evaluate(const CubatureForce<S>&, const VectorRef<S>&, Evaluation<S>&);                         \
  template bool admits(const CubatureForce<S>&, const VectorRef<S>&, Evaluation<S>&);                           \
  template Matrix<S> stiffness_at_rest(const CubatureForce<S>&);
RITZ_INSTANCE(double)
RITZ_INSTANCE(float)
#undef RITZ_INSTANCE

}  // namespace ritz::runtime
