#include "ritz/app/plan.hpp"

#include <cmath>
#include <cstdio>

#include "ritz/app/resources.hpp"
#include "ritz/base/counted.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/petsc/panel.hpp"
#include "ritz/petsc/speed.hpp"
#include "ritz/stages/eigen_strategy.hpp"

namespace ritz::app {
namespace {

// Figures of MUMPS, of the Lanczos iteration and of LOBPCG measured on Tet10 and Tet4 beams of 100k and 300k degrees of
// freedom (benchmarks/modes).
constexpr double factor_efficiency = 0.5;    ///< of dgemm's rate, one rank
constexpr double parallel_efficiency = 0.7;  ///< of a second, third ... rank
constexpr double solve_passes = 5;           ///< readings of the factor that a block solve costs
constexpr double columns_per_mode = 6;       ///< Lanczos columns a wanted pair
constexpr double lobpcg_steps = 50;          ///< iterations
constexpr double products_per_panel = 16;    ///< with K, for eight columns of the block, in one of them
constexpr double flops_per_row = 60;         ///< of the dense algebra in one of them, over the block's width squared
constexpr double columns_per_column = 20;    ///< vectors in memory for each of the block
constexpr double base_memory = 70e6;         ///< of a rank that holds nothing, bytes
constexpr double memory_share = 0.8;         ///< of the free memory that the direct strategy may take

/// The factor of a solid of N degrees of freedom, bytes over all ranks, without an analysis: fill grows like N^1.41.
double rough_factor_bytes(double N) { return 0.8e9 * std::pow(N / 1e5, 1.41); }

struct Estimate {
  double memory_rank = 0, seconds = 0;
  std::string how;
};

std::string shown(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f s", seconds);
  return text;
}

Estimate direct(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const stages::Full& full,
                const stages::ModesOptions& options) {
  const double ranks = parallel::size(mesh.comm), speed = 1 + parallel_efficiency * (ranks - 1);
  const petsc::FactorEstimate f = petsc::Factorization(mesh.comm, "solve_").analyse(full.stiffness);
  const double pairs = options.count + stages::spare_pairs, columns = pairs * columns_per_mode;
  const double basis =
      8.0 * static_cast<double>(dofs.total) / ranks * (std::max(2 * pairs, pairs + 20 * options.block) + 2 * pairs);
  const double factor = 2 * f.flops / (factor_efficiency * petsc::dgemm_rate() * speed);
  const double solve = columns / options.block * solve_passes * 8 * f.entries / (petsc::memory_rate() * speed);
  return {base_memory + f.memory_rank + peak_memory() + basis, factor + solve,
          "two factorizations " + shown(factor) + ", block Lanczos " + shown(solve)};
}

Estimate iterative(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const stages::Full& full,
                   const stages::ModesOptions& options) {
  const double rows = static_cast<double>(dofs.total) / parallel::size(mesh.comm);
  const double width = stages::iterative_block(options.count + stages::spare_pairs);
  const double product = parallel::max(mesh.comm, petsc::panel_seconds(full.stiffness));
  const double step = width / petsc::panel_width * products_per_panel * product +
                      flops_per_row * rows * width * width / petsc::dgemm_rate();
  return {base_memory + 1.3 * peak_memory() + 8 * rows * columns_per_column * width, lobpcg_steps * step,
          "multigrid and about " + std::to_string(static_cast<int>(lobpcg_steps)) + " steps of LOBPCG"};
}

std::string row(const std::string& stage, double seconds, const std::string& what) {
  char text[200];
  std::snprintf(text, sizeof text, "  %-12s %8.1f s   %s", stage.c_str(), seconds, what.c_str());
  return text;
}

}  // namespace

stages::ModesOptions choose_strategy(const config::Config& config, const mesh::Dofs& dofs) {
  stages::ModesOptions options = config.modes;
  options.strategy =
      config.solver == config::Solver::iterative ? stages::Strategy::iterative : stages::Strategy::direct;
  if (config.solver != config::Solver::automatic) return options;
  const double room = memory_share * free_memory_per_rank(dofs.comm) * parallel::size(dofs.comm);
  if (rough_factor_bytes(static_cast<double>(dofs.total)) > room) options.strategy = stages::Strategy::iterative;
  return options;
}

void print_plan(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs, const stages::Full& full,
                const stages::ModesOptions& options, const Progress& progress) {
  const auto estimate = options.strategy == stages::Strategy::iterative ? iterative : direct;
  const Estimate e = estimate(mesh, dofs, full, options);
  double done = 0;
  for (const auto& stage : progress.seconds()) done += stage.seconds;
  const double memory = parallel::max(mesh.comm, e.memory_rank);
  const double rest = 0.3 * done;
  char total[160];
  std::snprintf(total, sizeof total, "  %-12s %8.1f s   %.2f GB a rank at most, %.2f GB over %s", "in all",
                done + e.seconds + rest, memory / 1e9, parallel::sum(mesh.comm, e.memory_rank) / 1e9,
                counted(parallel::size(mesh.comm), "rank", "ranks").c_str());
  progress.line("plan: what these options need (nothing has been solved)");
  for (const auto& stage : progress.seconds()) progress.line(row(stage.stage, stage.seconds, "done for this plan"));
  progress.line(row("modes", e.seconds, e.how));
  progress.line(row("write", rest, "inertia, loads and " + config.output.string()));
  progress.line(total);
}

}  // namespace ritz::app
