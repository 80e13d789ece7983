// The reduced forces against one symmetric matrix-vector product (OpenBLAS dsymv) of the quartic matrix, and u = U z
// against reading U once (dasum), measured in turns in the same run. Every row prints the ratio; bars are in the issue
// tracker, none is a test.
//   cmake --build BUILD --target benchmark-runtime
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <random>

#include "ritz/runtime/cubature_force.hpp"
#include "ritz/runtime/polynomial_force.hpp"
#include "ritz/runtime/reconstruction.hpp"
#include "ritz/runtime/step.hpp"

extern "C" void dsymv_(const char* uplo, const int* n, const double* alpha, const double* A, const int* lda,
                       const double* x, const int* incx, const double* beta, double* y, const int* incy);

extern "C" double dasum_(const int* n, const double* x, const int* incx);

extern "C" void dgemm_(const char* transa, const char* transb, const int* m, const int* n, const int* k,
                       const double* alpha, const double* A, const int* lda, const double* B, const int* ldb,
                       const double* beta, double* C, const int* ldc);

namespace ritz::runtime {
namespace {

/// product := A Aᵀ, as a dgemm.
void dgemm(const Eigen::MatrixXd& A, Eigen::MatrixXd& product) {
  const double one = 1, zero = 0;
  const int n = static_cast<int>(A.rows()), k = static_cast<int>(A.cols());
  dgemm_("N", "T", &n, &n, &k, &one, A.data(), &n, A.data(), &n, &zero, product.data(), &n);
}

model::Polynomial random_polynomial(Eigen::Index r) {
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  const auto random = [&](Eigen::Index n) {
    return Eigen::VectorXd::NullaryExpr(n, [&] { return normal(generator); });
  };
  const Eigen::Index pairs = r * (r + 1) / 2, triples = pairs * (r + 2) / 3;
  return {r, random(pairs), random(triples), random(triples * (r + 3) / 4)};
}

template <class Work>
double seconds(Work&& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// dsymv of the p x p matrix of r coordinates, p = r(r+1)/2.
struct Symv {
  explicit Symv(Eigen::Index r) : n(static_cast<int>(r * (r + 1) / 2)), A(Eigen::MatrixXd::Ones(n, n)) {
    x = y = Eigen::VectorXd::Ones(n);
  }
  void operator()() {
    const double one = 1, zero = 0;
    const int next = 1;
    dsymv_("U", &n, &one, A.data(), &n, x.data(), &next, &zero, y.data(), &next);
  }
  int n;
  Eigen::MatrixXd A;
  Eigen::VectorXd x, y;
};

/// The fastest of many turns, µs: what the machine can do when nobody else uses it.
struct Fastest {
  double microseconds = 1e30;
  template <class Work>
  void turn(int times, Work&& work) {
    const double took = seconds([&] {
      for (int i = 0; i < times; ++i) work();
    });
    microseconds = std::min(microseconds, 1e6 * took / times);
  }
};

template <class Scalar>
void evaluation(benchmark::State& state) {
  const Eigen::Index r = state.range(0);
  const auto forces = make_polynomial_force<Scalar>(random_polynomial(r));
  auto result = make_evaluation(forces);
  const Vector<Scalar> z = Vector<Scalar>::LinSpaced(r, -1, 1);
  Symv symv(r);
  Fastest ours, theirs;
  const int times = static_cast<int>(std::max<Eigen::Index>(1, 4000000 / (r * r * r * r)));
  for (auto _ : state) {
    ours.turn(times, [&] { evaluate(forces, z, result); });
    theirs.turn(times, [&] { symv(); });
  }
  state.counters["us"] = ours.microseconds;
  state.counters["dsymv_us"] = theirs.microseconds;
  state.counters["ratio"] = ours.microseconds / theirs.microseconds;
}
BENCHMARK(evaluation<double>)->Arg(20)->Arg(30)->Arg(40)->Arg(60);
BENCHMARK(evaluation<float>)->Arg(20)->Arg(30)->Arg(40)->Arg(60);

/// A cubature of neo-Hookean cells, of T = `cells_by_r` r tetrahedra of one point each, with its polynomial.
template <class Scalar>
CubatureForce<Scalar> random_cubature(Eigen::Index r, Eigen::Index cells_by_r) {
  const Eigen::Index T = cells_by_r * r;
  model::Cubature cubature{.integrand = model::Integrand::beyond_polynomial,
                           .cells = std::vector<std::int64_t>(static_cast<std::size_t>(T)),
                           .weights = Eigen::VectorXd::Ones(T),
                           .regions = std::vector<std::int64_t>(static_cast<std::size_t>(T)),
                           .starts = {},
                           .volumes = Eigen::VectorXd::Ones(T),
                           .gradients = .01 * Eigen::MatrixXd::Random(9 * T, r),
                           .errors = {}};
  for (Eigen::Index c = 0; c <= T; ++c) cubature.starts.push_back(c);
  const std::vector<model::RegionMaterial> materials = {{"rubber", {fem::NeoHookean{1e6, .3}, 1e3}}};
  const auto polynomial = random_polynomial(r);
  return make_cubature_force<Scalar>(cubature, materials, &polynomial);
}

/// Energy, force and tangent of a cubature against a dgemm of the flops of its tangent, (9 T r) r multiplications.
template <class Scalar>
void cubature(benchmark::State& state) {
  const Eigen::Index r = state.range(0), T = state.range(1) * r;
  const auto force = random_cubature<Scalar>(r, state.range(1));
  auto result = make_evaluation(force);
  const Vector<Scalar> z = Vector<Scalar>::LinSpaced(r, -1, 1);
  const Eigen::MatrixXd gradients = Eigen::MatrixXd::Random(r, 9 * T);
  Eigen::MatrixXd product(r, r);
  Fastest ours, theirs;
  for (auto _ : state) {
    ours.turn(5, [&] { evaluate<Scalar>(force, z, result); });
    theirs.turn(5, [&] { dgemm(gradients, product); });
  }
  state.counters["us"] = ours.microseconds;
  state.counters["dgemm_us"] = theirs.microseconds;
  state.counters["ratio"] = ours.microseconds / theirs.microseconds;
}
BENCHMARK(cubature<double>)->ArgsProduct({{20, 30, 40}, {1, 2, 4, 8}});
BENCHMARK(cubature<float>)->ArgsProduct({{20, 30, 40}, {4}});

void sixteen_instances(benchmark::State& state) {
  const Eigen::Index r = state.range(0), instances = 16;
  const auto forces = make_polynomial_force<double>(random_polynomial(r));
  auto single = make_evaluation(forces);
  auto batch = make_batch_evaluation(forces, instances);
  const Eigen::MatrixXd z = Eigen::MatrixXd::Random(r, instances);
  Fastest together, apart;
  for (auto _ : state) {
    together.turn(1, [&] { evaluate_batch(forces, z, batch); });
    apart.turn(1, [&] {
      for (Eigen::Index i = 0; i < instances; ++i) evaluate(forces, z.col(i), single);
    });
  }
  state.counters["us"] = together.microseconds / instances;
  state.counters["single_us"] = apart.microseconds / instances;
  state.counters["ratio"] = together.microseconds / apart.microseconds;
}
BENCHMARK(sixteen_instances)->Arg(20)->Arg(30)->Arg(40);

/// A step, and what it is made of, each timed alone.
struct StepTimes {
  Outcome outcome;
  Fastest whole, evaluating, factoring;
};

StepTimes time_step(benchmark::State& state, const Model<double>& model, Workspace<double>& workspace,
                    const State<double>& start, const Eigen::VectorXd& load, double dt) {
  StepTimes times;
  auto moving = start;
  auto at = make_evaluation(model.force);
  auto factors = make_factors<double>(load.size());
  const Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(load.size(), load.size()) * 400;
  for (auto _ : state) {
    moving = start;
    times.whole.turn(1, [&] { times.outcome = step<double>(model, moving, {load, load}, dt, workspace); });
    times.evaluating.turn(1, [&] { evaluate<double>(model.force, moving.z(), at); });
    times.factoring.turn(1, [&] { factor(matrix, factors); });
  }
  return times;
}

/// A step of implicit Euler against the evaluations and factorizations that it made, measured by themselves.
void implicit_step(benchmark::State& state) {
  const Eigen::Index r = state.range(0);
  auto polynomial = random_polynomial(r);
  polynomial.quadratic *= 1e-3;
  const auto model = make_model<double>(polynomial, {});
  const auto method = implicit_euler();
  const double dt = 0.05;
  auto workspace = make_workspace<double>(model, method, dt);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(r), load = Eigen::VectorXd::Ones(r);
  const auto start = make_state<double>(model, method, rest, rest, load);
  const auto [outcome, whole, evaluating, factoring] = time_step(state, model, workspace, start, load, dt);
  const double parts = outcome.evaluations * evaluating.microseconds + outcome.iterations * factoring.microseconds;
  state.counters["us"] = whole.microseconds;
  state.counters["iterations"] = outcome.iterations;
  state.counters["rejected"] = outcome.rejected;
  state.counters["ratio"] = whole.microseconds / parts;
}
BENCHMARK(implicit_step)->Arg(20)->Arg(30)->Arg(40)->Arg(60);

/// Diagonal to rounding, as the stiffness at rest of a reduced basis is.
Eigen::VectorXd diagonal_stiffness(Eigen::Index r) {
  Eigen::VectorXd quadratic = Eigen::VectorXd::Constant(r * (r + 1) / 2, 1e-16);
  for (Eigen::Index i = 0, at = 0; i < r; at += r - i, ++i) quadratic[at] = 1 + static_cast<double>(i);
  return quadratic;
}

/// Steps of a resolved motion by the linearly implicit method, against one evaluation and one factorization.
void linearly_implicit_step(benchmark::State& state, const Damping& damping) {
  const Eigen::Index r = state.range(0);
  auto polynomial = random_polynomial(r);
  polynomial.quadratic = diagonal_stiffness(r);
  polynomial.cubic *= 1e-4;
  polynomial.quartic *= 1e-4;
  const auto model = make_model<double>(polynomial, damping);
  const auto method = linearly_implicit();
  const double dt = 0.05;
  auto workspace = make_workspace<double>(model, method, dt);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(r), load = Eigen::VectorXd::Constant(r, 1e-2);
  auto start = make_state<double>(model, method, rest, rest, load);
  for (int n = 0; n < 10; ++n) step<double>(model, start, {load, load}, dt, workspace);
  const auto [outcome, whole, evaluating, factoring] = time_step(state, model, workspace, start, load, dt);
  state.counters["us"] = whole.microseconds;
  state.counters["evaluations"] = outcome.evaluations;
  state.counters["ratio"] = whole.microseconds / (evaluating.microseconds + factoring.microseconds);
}
BENCHMARK_CAPTURE(linearly_implicit_step, undamped, Damping{})->Arg(20)->Arg(30)->Arg(40)->Arg(60);
BENCHMARK_CAPTURE(linearly_implicit_step, damped, Damping{.alpha = .5, .beta = 1e-4, .ratio = {}})
    ->Arg(20)
    ->Arg(30)
    ->Arg(40)
    ->Arg(60);

/// u = U z at 50,000 vertices.
void reconstruction(benchmark::State& state) {
  const Eigen::Index r = state.range(0), n = 50'000;
  const model::Basis basis{model::RowMatrix::Random(3 * n, r)};
  const Eigen::VectorXd z = Eigen::VectorXd::LinSpaced(r, -1, 1);
  model::Points u(n, 3);
  const int numbers = static_cast<int>(basis.U.size()), next = 1;
  Fastest ours, reading;
  for (auto _ : state) {
    ours.turn(1, [&] { reconstruct(basis, z, u); });
    reading.turn(1, [&] { benchmark::DoNotOptimize(dasum_(&numbers, basis.U.data(), &next)); });
  }
  state.counters["us"] = ours.microseconds;
  state.counters["reading_us"] = reading.microseconds;
  state.counters["ratio"] = ours.microseconds / reading.microseconds;
}
BENCHMARK(reconstruction)->Arg(10)->Arg(20)->Arg(30)->Arg(40)->Arg(60);

/// The same from a copy, against reading the U in double precision.
template <class Scalar>
void reconstruction_from_copy(benchmark::State& state) {
  const Eigen::Index r = state.range(0), n = 50'000;
  const model::Basis basis{model::RowMatrix::Random(3 * n, r)};
  const auto copy = make_reconstruction<Scalar>(basis);
  const Eigen::VectorXd z = Eigen::VectorXd::LinSpaced(r, -1, 1);
  Displacements<Scalar> u(n, 3);
  const int numbers = static_cast<int>(basis.U.size()), next = 1;
  Fastest ours, reading;
  for (auto _ : state) {
    ours.turn(1, [&] { reconstruct<Scalar>(copy, z, u); });
    reading.turn(1, [&] { benchmark::DoNotOptimize(dasum_(&numbers, basis.U.data(), &next)); });
  }
  state.counters["us"] = ours.microseconds;
  state.counters["reading_us"] = reading.microseconds;
  state.counters["ratio"] = ours.microseconds / reading.microseconds;
}
BENCHMARK(reconstruction_from_copy<float>)->Arg(10)->Arg(20)->Arg(30)->Arg(40)->Arg(60);
BENCHMARK(reconstruction_from_copy<double>)->Arg(10)->Arg(20)->Arg(30)->Arg(40)->Arg(60);

}  // namespace
}  // namespace ritz::runtime

BENCHMARK_MAIN();
