#include "ritz/app/plan.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ritz/base/shown.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::app {
namespace {

constexpr double memory_share = 0.8;  ///< of the free memory that the direct strategy may take

std::string row(const std::string& stage, double seconds, const std::string& what) {
  return formatted("  %-12s %8.1f s   %s", stage.c_str(), seconds, what.c_str());
}

}  // namespace

double rough_factor_bytes(double N) { return 0.8e9 * std::pow(N / 1e5, 1.41); }

stages::ModesOptions choose_strategy(const config::Config& config, const mesh::Dofs& dofs) {
  stages::ModesOptions options = config.modes;
  options.strategy =
      config.solver == config::Solver::iterative ? stages::Strategy::iterative : stages::Strategy::direct;
  if (config.solver != config::Solver::automatic) return options;
  const double room = memory_share * free_memory_per_rank(dofs.comm) * parallel::size(dofs.comm);
  const double factors = options.inverse == stages::InverseUse::kept ? 2 : 1;
  if (factors * rough_factor_bytes(static_cast<double>(dofs.total)) > room)
    options.strategy = stages::Strategy::iterative;
  return options;
}

Plan make_plan(const config::Config& config, const stages::Problem& problem, const stages::ModesOptions& options,
               const Earlier& earlier, const Progress& progress) {
  const MPI_Comm comm = problem.mesh.comm;
  Plan plan;
  plan.stages = estimate_stages(workload(config, problem, options), earlier.basis);
  double done = 0, memory = 0;
  for (const auto& stage : progress.seconds()) done += stage.seconds;
  plan.stages.push_back({"write", 0.3 * done, 0, "inertia, loads and " + config.output.string()});
  plan.seconds = done;
  for (auto& stage : plan.stages) {
    plan.seconds += stage.seconds;
    memory = std::max(memory, stage.memory);
    stage.memory = parallel::max(comm, stage.memory);
  }
  plan.memory = {parallel::max(comm, memory), parallel::sum(comm, memory)};
  return plan;
}

void print_plan(MPI_Comm comm, const Plan& plan, const Progress& progress) {
  const auto memory = formatted("%.2f GB a rank at most, %.2f GB over %s", plan.memory.largest_rank / 1e9,
                                plan.memory.all_ranks / 1e9, counted(parallel::size(comm), "rank", "ranks").c_str());
  progress.line("plan: what these options need (nothing has been solved)");
  for (const auto& stage : progress.seconds()) progress.line(row(stage.stage, stage.seconds, "done for this plan"));
  for (const auto& stage : plan.stages) progress.line(row(stage.stage, stage.seconds, stage.how));
  progress.line(row("in all", plan.seconds, memory));
}

}  // namespace ritz::app
