#include "support/sample_cubature.hpp"

#include <cmath>
#include <random>

#include "support/sample_polynomial.hpp"

namespace ritz::test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// λ/2 tr²E + μ |E|² as half a sum of squares of seven strains, for each point.
model::Polynomial polynomial_of_points(const SampleCubature& sample) {
  const auto& c = sample.cubature;
  const Index r = c.gradients.cols();
  StrainEnergy energy{MatrixXd::Zero(7 * c.volumes.size(), r), {}};
  Index row = 0;
  for (std::size_t cell = 0; cell < c.cells.size(); ++cell) {
    const auto law = sample.materials[static_cast<std::size_t>(c.regions[cell])].material.at_rest();
    for (Index p = c.starts[cell]; p < c.starts[cell + 1]; ++p) {
      const double volume = c.volumes[p];
      const auto component = [&](int i, int j) { return c.gradients.row(9 * p + 3 * j + i); };
      MatrixXd trace = MatrixXd::Zero(r, r);
      const auto add = [&](double factor, const Eigen::RowVectorXd& a, const MatrixXd& Q) {
        energy.a.row(row++) = std::sqrt(volume * factor) * a;
        energy.Q.push_back(std::sqrt(volume * factor) * Q);
      };
      for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) {  // 2 E_ij = G_ij + G_ji + Σ_k G_ki G_kj
          MatrixXd Q = MatrixXd::Zero(r, r);
          for (int k = 0; k < 3; ++k) Q += component(k, i).transpose() * component(k, j);
          const MatrixXd both = (Q + Q.transpose()) / 2;
          if (i == j) trace += both;
          add(i == j ? 2 * law.mu : 4 * law.mu, (component(i, j) + component(j, i)) / 2, both);
        }
      add(law.lambda, component(0, 0) + component(1, 1) + component(2, 2), trace);
    }
  }
  return polynomial_of(energy);
}

}  // namespace

std::vector<model::RegionMaterial> all_isotropic_laws() {
  const double d = 2e-3;
  std::vector<model::RegionMaterial> laws;
  const auto add = [&](fem::AnyLaw law) { laws.push_back({fem::name(law), {std::move(law), 1}}); };
  add(fem::NeoHookean{1e3, .3});
  add(fem::IsochoricNeoHookean{1e3, .4});
  add(fem::MooneyRivlin{150, 40, d});
  add(fem::Yeoh{150, -2, .1, d});
  add(fem::ArrudaBoyce{350, 2.5, d});
  add(*fem::law_of_constants("ogden", std::vector<double>{630, 1.3, 1.2, 5, -10, -2, d}));
  add(fem::Hencky{1e3, .3});
  add(fem::Corotational{1e3, .3});
  return laws;
}

SampleCubature sample_cubature(Index r, Index points, std::vector<model::RegionMaterial> materials,
                               model::Integrand integrand, SampleWeights weights) {
  std::mt19937 generator(static_cast<unsigned>(11 * r + points));
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> half_to_three_halves(.5, 1.5);
  SampleCubature sample{{}, std::move(materials), {}};
  auto& c = sample.cubature;
  c.integrand = integrand;
  c.starts = {0};
  const auto regions = static_cast<std::int64_t>(sample.materials.size());
  for (std::int64_t cell = 0; c.starts.back() < points; ++cell) {
    c.cells.push_back(3 * cell + 5);
    c.regions.push_back(cell % regions);
    c.starts.push_back(std::min<std::int64_t>(points, c.starts.back() + 1 + cell % 3));
  }
  c.weights = Eigen::VectorXd::NullaryExpr(
      std::ssize(c.cells), [&] { return weights == SampleWeights::one ? 1 : half_to_three_halves(generator); });
  c.volumes = Eigen::VectorXd::NullaryExpr(
      points, [&] { return half_to_three_halves(generator) / static_cast<double>(points); });
  const double size = .1 / std::sqrt(static_cast<double>(r));
  c.gradients = MatrixXd::NullaryExpr(9 * points, r, [&] { return size * normal(generator); });
  sample.polynomial = polynomial_of_points(sample);
  return sample;
}

}  // namespace ritz::test
