// The nonlinear stages on one rank beside what they are made of, in one run:
//   the polynomial's flops a second over those of dsyrk on the same shapes; the derivatives' loads, µs a cell and pair.
#include <chrono>
#include <cstdio>
#include <functional>

#include "ritz/algebra/dense.hpp"
#include "ritz/algebra/session.hpp"
#include "ritz/mesh/halo.hpp"
#include "ritz/mesh/read.hpp"
#include "ritz/stages/canonical.hpp"
#include "ritz/stages/derivatives.hpp"
#include "ritz/stages/reduce_polynomial.hpp"

namespace {

using namespace ritz;

constexpr int repetitions = 5;
constexpr int strains_at_once = 192;

/// The least of some runs, s.
double seconds(const std::function<void()>& work) {
  double least = 1e300;
  for (int n = 0; n < repetitions; ++n) {
    const auto start = std::chrono::steady_clock::now();
    work();
    least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return least;
}

/// Multiplications and additions of one strain in the Gram matrix of r coordinates.
double flops_a_strain(double r) {
  const double size = r + r * (r + 1) / 2;
  return size * (size + 1);
}

double dsyrk_rate(int r) {
  const Eigen::Index size = r + r * (r + 1) / 2;
  const Eigen::MatrixXd strains = Eigen::MatrixXd::Random(size, strains_at_once);
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(size, size);
  constexpr int calls = 20;
  const double time = seconds([&] {
    for (int n = 0; n < calls; ++n) algebra::add_gram(gram, strains);
  });
  return calls * strains_at_once * flops_a_strain(r) / time;
}

void measure(const char* text, int points) {
  mesh::Source source;
  source.mesh = mesh::parse_box(text);
  auto read = mesh::read(MPI_COMM_WORLD, source);
  auto numbered = mesh::number(read, {}, mesh::FileSupports::ignored);
  const auto problem = stages::assemble(std::move(read), std::move(numbered), {{fem::StVK{1e6, .3}, 1000}});
  const auto& [mesh, dofs, materials, matrices] = problem;
  for (const int r : {20, 30, 40}) {
    const algebra::Tall u = stages::fixed_vectors(mesh, dofs, r, 1);
    const double time = seconds([&] { stages::reduce_polynomial(problem, *stages::polynomial_laws(materials), u); });
    const double rate = 6.0 * points * static_cast<double>(mesh.cells_total) * flops_a_strain(r) / time;
    const double dsyrk = dsyrk_rate(r);
    std::printf("%-28s r = %2d  polynomial %6.2f s, %5.1f GF/s, dsyrk %5.1f GF/s: ratio %.2f\n", text, r, time,
                rate / 1e9, dsyrk / 1e9, rate / dsyrk);
  }
  const algebra::Tall modes = mesh::with_ghosts(
      mesh, mesh::to_vertices(mesh, dofs, stages::fixed_vectors(mesh, dofs, 20, 1)), mesh::components);
  const auto pairs = stages::pairs_of_rows(0, 20, 20).size();
  const double time = seconds([&] { stages::derivative_loads(problem, modes, 0, 20); });
  std::printf("%-28s loads of %zu derivatives: %.3f us a cell and pair\n", text, pairs,
              1e6 * time / static_cast<double>(pairs) / static_cast<double>(mesh.cells_total));
}

}  // namespace

int main(int, char** argv) {
  const ritz::algebra::Session session(argv[0]);
  measure("box:4,1,1/40,10,10/tet4", 1);
  measure("box:4,1,1/16,4,4/tet10", 4);
  measure("box:4,1,1/24,6,6/hex8", 8);
}
