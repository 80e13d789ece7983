#include <algorithm>
#include <limits>

#include "ritz/app/estimate.hpp"
#include "ritz/app/reduced_parts.hpp"
#include "ritz/app/snapshots.hpp"
#include "ritz/app/static_loads.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/fem/element.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/cubature_candidates.hpp"
#include "ritz/stages/reduce_polynomial.hpp"

namespace ritz::app {
namespace {

// Figures of the nonlinear stages measured on Tet4, Tet10 and Hex8 beams of up to 300k degrees of freedom
// (benchmarks/nonlinear.py holds a plan against what came of it).
constexpr double loop_efficiency = 0.1;      ///< of dgemm's rate, in loops over cells
constexpr double tall_efficiency = 0.5;      ///< of dgemm's rate, in products of tall matrices
constexpr double directions_per_column = 4;  ///< of the set that a column of the basis is cut from
constexpr double taylor_columns = 14;        ///< displacements of the witness of the derivatives
constexpr double polynomial_columns = 9;     ///< of that of the polynomial
constexpr double newton_steps = 4 * 5;       ///< of a static path of the full model
constexpr double searched_modes = 8;         ///< about, in the search for a basis of some accuracy
constexpr double searched_columns = 20;      ///< the same
constexpr double strains = 6;                ///< components
constexpr double cubature_iterations = 40;   ///< about, of its least squares
constexpr double law_flops = 200;            ///< of the response at a point

/// Quadrature points of the rank that has most, as each loop over cells counts them.
struct Points {
  double owned = 0;   ///< of owned cells
  double loads = 0;   ///< flops for a pair of modes, halo included
  double forces = 0;  ///< flops for a displacement's internal force, halo included
};

Points points_of(const mesh::Mesh& mesh) {
  Points points;
  for (int cell = 0; cell < mesh.cells.count(); ++cell) {
    const auto& element = fem::element(mesh.cells.types[static_cast<std::size_t>(cell)]);
    const double samples = element.rule.count();
    points.loads += samples * (170 + 18 * element.vertices);
    points.forces += samples * (250 + 60 * element.vertices);
    if (cell < mesh.cells.owned) points.owned += samples;
  }
  for (double* most : {&points.owned, &points.loads, &points.forces}) *most = parallel::max(mesh.comm, *most);
  return points;
}

double pair_count(double n) { return n * (n + 1) / 2; }

double residual_columns(const Workload& work) {
  return mesh::components * static_cast<double>(residual_places(work.config, work.problem.mesh).size());
}

/// Adds the static answers to loads that are solved for beside the modes.
void add_answers(const Workload& work, ModesEstimate& modes) {
  const auto& [config, problem, options, rate, memory, ranks, speed, dofs, rows, held] = work;
  const auto places = answered_places(config, problem, options.strategy, residual_places(config, problem.mesh));
  if (places.empty()) return;
  const double columns = mesh::components * static_cast<double>(places.size()),
               seconds = columns * modes.inverse_seconds;
  modes.stage.seconds += seconds;
  modes.stage.memory += 8 * rows * 2 * columns;
  modes.stage.how +=
      ", static answers to " + counted(static_cast<std::int64_t>(columns), "load ", "loads ") + shown_seconds(seconds);
}

/// The vectors that the basis is made of, and its columns at the most.
struct Vectors {
  double modes = 0, derivatives = 0, snapshots = 0;
  double columns = std::numeric_limits<double>::infinity();

  double all() const { return modes + derivatives + snapshots; }
};

Vectors vectors_of(const Workload& work) {
  const stages::BasisOptions& options = *work.config.basis;
  Vectors v;
  v.modes = options.modes.empty() ? work.modes.count : static_cast<double>(options.modes.size());
  v.derivatives = pair_count(options.derivatives);
  if (work.config.snapshots)
    v.snapshots = static_cast<double>(count_snapshots(*work.config.snapshots, work.problem.mesh));
  if (work.config.accuracy) {
    v.modes = std::min(v.modes, searched_modes);
    v.derivatives = pair_count(v.modes);
    v.columns = searched_columns;
  }
  v.columns = std::min({v.columns, v.all(), work.dofs});
  if (options.cut.size > 0) v.columns = std::min<double>(v.columns, options.cut.size);
  v.columns += residual_columns(work);
  if (work.config.forces != config::ReducedForces::none)
    v.columns = std::min(v.columns, static_cast<double>(stages::most_coordinates));
  return v;
}

std::string number_of(double count, const char* one, const char* many) {
  return counted(static_cast<std::int64_t>(count), one, many);
}

/// Seconds of products of tall matrices that take so many flops a row.
double tall_seconds(const Workload& work, double flops) { return flops * work.rows / (tall_efficiency * work.rate); }

/// The coefficients of r coordinates: strains at every point, and their products.
double polynomial_seconds(const Workload& work, const Points& points, double r) {
  const double terms = r + pair_count(r);
  const double fill = (100 * r + 40 * pair_count(r)) / loop_efficiency, products = strains * terms * terms;
  return points.owned * (fill + products) / work.rate;
}

Estimate statics(const Workload& work, const ModesEstimate& modes) {
  return {"full statics", newton_steps * modes.newton_seconds, work.held + modes.newton_memory,
          "about " + number_of(newton_steps, "step", "steps") + " of Newton"};
}

Estimate basis(const Workload& work, const ModesEstimate& modes, const Points& points, const Vectors& v) {
  const double block = work.config.basis->block;
  const double directions = std::min(v.all(), directions_per_column * v.columns);  // while the set grows
  const double loads = v.derivatives * points.loads / (loop_efficiency * work.rate);
  const double solves = v.derivatives * modes.inverse_seconds;
  const double cut = tall_seconds(work, 14 * (v.all() + v.columns) * (directions + block));
  const double search = work.config.accuracy ? v.modes * polynomial_seconds(work, points, v.columns) : 0;
  std::string how = work.config.accuracy ? "a search, through about " : "";
  if (v.derivatives > 0)
    how += number_of(v.derivatives, "derivative", "derivatives") + ": loads " + shown_seconds(loads) + ", solves " +
           shown_seconds(solves) + "; ";
  how += (v.all() > v.snapshots ? "principal directions of " : "proper orthogonal decomposition (POD) of ") +
         number_of(v.all(), "vector ", "vectors ") + shown_seconds(cut);
  const double vectors = 3 * v.modes + 2 * v.snapshots + 3 * directions + (v.derivatives > 0 ? 10 * block : 0);
  return {"basis", loads + solves + cut + search, work.held + modes.inverse_memory + 8 * work.rows * vectors, how};
}

Estimate polynomial(const Workload& work, const ModesEstimate& modes, const Points& points, const Vectors& v) {
  const double r = v.columns, terms = r + pair_count(r), coefficients = pair_count(pair_count(r)) / 3;
  return {"polynomial", polynomial_seconds(work, points, r),
          work.held + modes.inverse_memory + 8 * work.rows * (v.modes + 4 * r) + 8 * (terms * terms + 3 * coefficients),
          number_of(r, "coordinate, ", "coordinates, ") + number_of(terms, "term of a strain", "terms of a strain")};
}

/// Forces of all cells at all poses, then the candidates' columns, which every iteration reads once.
Estimate cubature(const Workload& work, const ModesEstimate& modes, const Points& points, const Vectors& v) {
  const double r = v.columns, poses = work.config.cubature.poses + 2 * stages::held_out_poses;
  const auto candidates = std::min(work.problem.mesh.cells_total, stages::most_candidates);
  const double numbers = static_cast<double>(candidates) / work.ranks * work.config.cubature.poses * r;
  const double projections = points.owned * poses * (36 * r + law_flops / loop_efficiency);
  const double seconds = (projections + cubature_iterations * 2 * numbers / loop_efficiency) / work.rate;
  return {"cubature", seconds, work.held + modes.inverse_memory + 8 * work.rows * (v.modes + 4 * r) + 4 * numbers,
          number_of(poses, "pose, ", "poses, ") + counted(candidates, "candidate", "candidates")};
}

Estimate witness(const Workload& work, const ModesEstimate& modes, const Points& points, const Vectors& v) {
  const bool taylor = v.derivatives > 0, force = work.config.forces != config::ReducedForces::none;
  const double columns = (taylor ? taylor_columns : 0) + (force ? polynomial_columns : 0);
  const double pairs = taylor ? pair_count(3) : 0;
  const double seconds =
      (columns * points.forces + pairs * points.loads) / (loop_efficiency * work.rate) + pairs * modes.inverse_seconds;
  return {"check", seconds,
          work.held + modes.inverse_memory + 8 * work.rows * (2 * v.modes + 2 * v.columns + 4 * columns),
          taylor && force ? "of the derivatives and of the polynomial"
                          : (taylor ? "of the derivatives" : "of the polynomial")};
}

}  // namespace

std::vector<Estimate> estimate_stages(const Workload& work, const std::optional<FinishedBasis>& earlier) {
  std::vector<Estimate> stages;
  ModesEstimate modes;
  if (!earlier) {
    modes = estimate_modes(work);
    add_answers(work, modes);
    if (work.config.accuracy) stages.push_back(statics(work, modes));
    stages.push_back(modes.stage);
    if (work.config.mesh_errors == config::MeshErrors::estimated) stages.push_back(estimate_mesh_error(work));
  }
  if (!work.config.basis) return stages;
  const Points points = points_of(work.problem.mesh);
  const Vectors vectors =
      earlier ? Vectors{.columns = static_cast<double>(earlier->reduced.U.cols())} : vectors_of(work);
  const bool forces = work.config.forces != config::ReducedForces::none;
  if (!earlier) stages.push_back(basis(work, modes, points, vectors));
  if (forces) stages.push_back(polynomial(work, modes, points, vectors));
  if (forces && !fem::force_degree(work.problem.materials)) stages.push_back(cubature(work, modes, points, vectors));
  if (forces || vectors.derivatives > 0) stages.push_back(witness(work, modes, points, vectors));
  return stages;
}

}  // namespace ritz::app
