#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ritz/algebra/panel.hpp"
#include "ritz/algebra/speed.hpp"
#include "ritz/app/estimate.hpp"
#include "ritz/app/plan.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/files/summary.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/block_lanczos.hpp"
#include "ritz/stages/eigen_strategy.hpp"

namespace ritz::app {
namespace {

// Figures of MUMPS, of the Lanczos iteration and of LOBPCG measured on Tet10 and Tet4 beams of 100k and 300k degrees of
// freedom (benchmarks/modes).
constexpr double factor_efficiency = 0.5;    ///< of dgemm's rate, one rank
constexpr double parallel_efficiency = 0.7;  ///< of a second, third ... rank
constexpr double solve_passes = 5;           ///< readings of the factor that a block solve of Lanczos costs
constexpr double wide_efficiency = 0.4;      ///< of dgemm's rate, in a solve of a wide block
constexpr double columns_per_mode = 6;       ///< Lanczos columns a wanted pair
constexpr double lobpcg_steps = 50;          ///< iterations
constexpr double products_per_panel = 16;    ///< with K, for eight columns of the block, in one of them
constexpr double flops_per_row = 60;         ///< of the dense algebra in one of them, over the block's width squared
constexpr double columns_per_column = 20;    ///< vectors in memory for each of the block
constexpr double cycles_per_solve = 28;      ///< of multigrid, with conjugate gradients
constexpr double products_per_cycle = 10;    ///< with K, for eight columns, in one of these
constexpr double hierarchy = 0.3;            ///< of what is held before it, in memory
constexpr double fits = 2e4;                 ///< flops of patch recovery for a quadratic cell and mode
constexpr double flops_of_factor = 2.5e11;   ///< of a solid of 1e5 degrees of freedom
constexpr double mesh_cycles = 15;           ///< of multigrid, to solve on quadratic cells
constexpr double mesh_columns = 12 * 16;     ///< vectors there at once, besides one a mode
constexpr double base_memory = 70e6;         ///< of a rank that holds nothing, bytes

ModesEstimate direct(const Workload& work) {
  const stages::ModesOptions& options = work.modes;
  const algebra::FactorEstimate f =
      algebra::Factorization(work.problem.mesh.comm, "solve_").analyse(work.problem.matrices.stiffness);
  const double pairs = options.count + stages::spare_pairs, columns = pairs * columns_per_mode;
  const double vector = 8 * work.rows, found = 2 * pairs * vector;
  const double krylov = stages::lanczos_columns(options.count + stages::spare_pairs, options.block) * vector;
  const double factor = 2 * f.flops / (factor_efficiency * work.rate * work.speed);
  const double solve = columns / options.block * solve_passes * 8 * f.entries / (work.memory * work.speed);
  const bool kept = options.inverse == stages::InverseUse::kept;
  // The factor that is kept stands beside the one that counts the modes.
  const double peak = f.memory_rank + found + std::max(krylov, kept ? f.memory_rank : 0.0);
  ModesEstimate estimate;
  estimate.stage = {"modes", factor + solve, work.held + peak,
                    "two factorizations " + shown_seconds(factor) + ", block Lanczos " + shown_seconds(solve) +
                        (kept ? "; the first factor is kept" : "")};
  if (kept) estimate.inverse_memory = f.memory_rank;
  estimate.inverse_seconds = 4 * f.entries / (wide_efficiency * work.rate * work.speed);
  estimate.newton_memory = f.memory_rank;
  estimate.newton_seconds = factor / 2;
  return estimate;
}

ModesEstimate iterative(const Workload& work) {
  const double width = stages::iterative_block(work.modes.count + stages::spare_pairs);
  const double product = parallel::max(work.problem.mesh.comm, algebra::panel_seconds(work.problem.matrices.stiffness));
  const double step = width / algebra::panel_width * products_per_panel * product +
                      flops_per_row * work.rows * width * width / work.rate;
  ModesEstimate estimate;
  estimate.stage = {"modes", lobpcg_steps * step,
                    (1 + hierarchy) * work.held + 8 * work.rows * columns_per_column * width,
                    "multigrid and about " + std::to_string(static_cast<int>(lobpcg_steps)) + " steps of LOBPCG"};
  if (work.modes.inverse == stages::InverseUse::kept) estimate.inverse_memory = hierarchy * work.held;
  estimate.inverse_seconds = cycles_per_solve * products_per_cycle * product / algebra::panel_width;
  estimate.newton_memory = hierarchy * work.held;
  estimate.newton_seconds = estimate.inverse_seconds * algebra::panel_width;
  return estimate;
}

}  // namespace

Workload workload(const config::Config& config, const stages::Problem& problem, const stages::ModesOptions& modes) {
  const double ranks = parallel::size(problem.mesh.comm), total = static_cast<double>(problem.dofs.total);
  return {config,
          problem,
          modes,
          algebra::dgemm_rate(),
          algebra::memory_rate(),
          ranks,
          1 + parallel_efficiency * (ranks - 1),
          total,
          total / ranks,
          base_memory + files::peak_memory()};
}

ModesEstimate estimate_modes(const Workload& work) {
  return work.modes.strategy == stages::Strategy::iterative ? iterative(work) : direct(work);
}

Estimate estimate_mesh_error(const Workload& work) {
  const mesh::Mesh& mesh = work.problem.mesh;
  const double modes = work.modes.count;
  double cells = 0, rows = 0, bytes = 0;  // of quadratic cells in place of linear ones, deep inside a body
  for (int c = 0; c < mesh.cells.owned; ++c, ++cells) {
    const auto type = mesh.cells.types[static_cast<std::size_t>(c)];
    const double vertices = type == fem::CellType::hex8 ? 4 : type == fem::CellType::wedge6 ? 2.5 : 1.36;
    const double neighbours = type == fem::CellType::hex8 ? 58 : type == fem::CellType::wedge6 ? 45 : 28;
    rows += mesh::components * vertices;
    bytes += 12 * mesh::components * vertices * neighbours * (mesh::components + 1 + 1. / mesh::components);
  }
  for (double* most : {&cells, &rows, &bytes}) *most = parallel::max(mesh.comm, *most);
  if (cells > 0 && fem::shape(mesh.cells.types[0]).quadratic())
    return {"mesh error", modes * cells * fits / work.rate, work.held + 8 * work.rows * modes, "recovered strains"};
  mesh::Dofs quadratic;
  quadratic.comm = mesh.comm;
  quadratic.total = static_cast<mesh::Index>(rows * work.ranks);
  const double vectors = 8 * rows * (modes + mesh_columns);
  const std::string how =
      ", one step on quadratic cells of about " + std::to_string(quadratic.total) + " degrees of freedom";
  if (choose_strategy(work.config, quadratic).strategy == stages::Strategy::direct) {
    const double size = static_cast<double>(quadratic.total) / 1e5;
    return {"mesh error", flops_of_factor * size * size / (factor_efficiency * work.rate * work.speed),
            work.held + bytes + rough_factor_bytes(static_cast<double>(quadratic.total)) / work.ranks + vectors,
            "a factorization" + how};
  }
  const double product = bytes / work.memory, panels = std::ceil(modes / algebra::panel_width);
  return {"mesh error", panels * mesh_cycles * products_per_cycle * product,
          work.held + (1 + hierarchy) * bytes + vectors, "multigrid" + how};
}

std::string shown_seconds(double seconds) { return formatted("%.1f s", seconds); }

}  // namespace ritz::app
