// The reduced model as values. Whatever a scene does not need is an absent optional.
// Everything is in SI units. n: vertices of the mesh (that cells use); r: columns of the basis U.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ritz/fem/cell.hpp"
#include "ritz/fem/material.hpp"

namespace ritz::model {

/// A row-major 3n x r or n x 3 array: three components of a vertex stand together.
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Cells for drawing: the volume's cells, or (surface only) the boundary faces. VTK numbering of types and vertices.
struct DrawnCells {
  std::vector<std::uint8_t> vtk_types;
  std::vector<std::int64_t> offsets;   ///< one more than cells, first 0
  std::vector<std::int64_t> vertices;  ///< rows of `points`
};

struct VertexSet {
  std::string name;
  std::vector<std::int64_t> rows;  ///< rows of `points` that are stored and belong to the set, ascending
  std::int64_t full_count;         ///< how many vertices the set has in the whole mesh
};

struct RegionMaterial {
  std::string region;
  fem::Material material;
};

enum class Rows : std::uint8_t { all, surface };

/// The stored vertices and what is needed to draw and to name them.
struct Geometry {
  Rows rows = Rows::all;
  std::int64_t full_vertices = 0;        ///< n of the whole mesh, also when only the surface is stored
  Points points;                         ///< stored vertices, m, in the mesh file's own order
  std::vector<std::int64_t> vertex_ids;  ///< the mesh file's own number of each stored vertex
  DrawnCells cells;
  std::vector<VertexSet> sets;
  std::vector<RegionMaterial> materials;
};

/// The basis U: u = U z, mass-orthonormal over the whole mesh (UᵀMU = I), rows of stored vertices only.
struct Basis {
  RowMatrix U;  ///< 3 n_stored x r, 1/sqrt(kg)
};

enum class ModeKind : std::uint8_t { rigid, flexible };
enum class Certified : std::uint8_t { no, probabilistic, inertia_f32, inertia };

/// √λ / 2π, Hz; 0 where λ is negative, by rounding.
double frequency(double eigenvalue);

/// Where the number of modes below `shift` was counted.
struct Certificate {
  Certified kind = Certified::no;
  double shift = 0;          ///< σ, rad²/s², past the last mode kept
  std::int64_t counted = 0;  ///< eigenvalues below σ by the inertia of K - σM
  std::int64_t found = 0;    ///< eigenvalues below σ that were computed
};

/// The modes of Kψ = λMψ (Eq. 1) in ascending order, rigid ones first. Without a Reduction, column i of U is mode i.
struct Modes {
  Eigen::VectorXd eigenvalues;  ///< λ = ω², rad²/s²; 0 for a rigid mode
  Eigen::VectorXd energies;  ///< ψᵀKψ/ψᵀMψ as computed, of rigid modes from their strains (tells how rigid they are)
  Eigen::VectorXd residuals;  ///< ‖Kψ − λMψ‖ / (λ‖Mψ‖); for a rigid mode ‖Kψ‖ / (‖K‖‖ψ‖)
  std::vector<std::uint8_t> floor_applies;  ///< 1 where the residual passed by 10 ε‖K‖‖ψ‖ alone
  std::vector<ModeKind> kinds;
  double orthonormality = 0;  ///< max |ΨᵀMΨ − I|
  Certificate certificate;
};

/// G = Bᵀ M_s B, size 4 + 3r, with M_s the scalar consistent mass (kg) and B = [1, X, Y, Z, U_x, U_y, U_z]:
/// X, Y, Z are coordinates minus `origin`, U_x the x-rows of U (n x r), zero at fixed components.
struct Inertia {
  Eigen::Vector3d origin;
  Eigen::MatrixXd gram;

  double mass() const;                     ///< kg
  Eigen::Vector3d centre_of_mass() const;  ///< m
  Eigen::Matrix3d tensor() const;          ///< about the centre of mass, kg m²
  /// UᵀMR, r x 6: R's columns are unit translations along x, y, z and unit rotations about axes x, y, z through
  /// the centre of mass.
  Eigen::MatrixXd rigid_coupling() const;
  /// UᵀMR to be printed: zero where it is below 1e-9 of what a column of U could have, √mass or √tr(tensor). As U is
  /// mass-orthonormal, these are its participation factors, √kg and √kg m.
  Eigen::MatrixXd participation_factors() const;
  /// (ψᵀMR_d)² for the three translations, r x 3, kg: sums to at most the mass over all modes.
  Eigen::MatrixXd effective_masses() const;
};

/// Unit loads on a named set, projected: Uᵀb.
struct SetLoad {
  std::string set;
  std::int64_t vertices = 0;  ///< that share a total force
  Eigen::MatrixXd total;      ///< r x 3: a unit total force along x, y, z shared equally by the set's vertices
  bool has_surface = false;   ///< whether the three below mean anything
  double area = 0;            ///< m²
  Eigen::VectorXd pressure;   ///< r: a unit pressure pushing into the body
  Eigen::MatrixXd traction;   ///< r x 3: a unit traction along x, y, z
};

/// Where the basis of a model with modal derivatives or snapshots comes from (Eqs. 12, 18). Absent: U is the modes.
struct Reduction {
  Eigen::VectorXd stiffness;        ///< diagonal of UᵀKU, which has no other entries; ascending, rad²/s²
  Eigen::VectorXd singular_values;  ///< σ of the set that U was cut from, in the M-norm, descending; the first r kept
  double discarded = 0;  ///< √(Σσ² of all that U leaves out), a bound for what was never computed included; as σ
};

/// The energy of St. Venant-Kirchhoff material over U (Sec. 3.1), exact for the elements' quadrature rules:
/// Ẽ(z) = ½ A_ij z_i z_j + ⅙ B_ijk z_i z_j z_k + 1/24 C_ijkl z_i z_j z_k z_l, with A, B, C fully symmetric (the second,
/// third and fourth derivatives of Ẽ at rest). Each is stored once: i ≤ j ≤ k ≤ l in lexicographic order.
struct Polynomial {
  Eigen::Index r = 0;
  Eigen::VectorXd quadratic;  ///< A, r(r+1)/2 numbers, 1/s²
  Eigen::VectorXd cubic;      ///< B, C(r+2, 3) numbers, 1/(s² m √kg)
  Eigen::VectorXd quartic;    ///< C, C(r+3, 4) numbers, 1/(s² m² kg)
};

/// What a body was made from, as hashes in hexadecimal.
struct Checksums {
  std::string mesh;     ///< of vertices, cells and regions
  std::string problem;  ///< of these, the materials and the supports: modes depend on nothing else
};

struct StageTime {
  std::string stage;
  double seconds;
};

/// Diagnostics of a body's reduction; nothing that a motion depends on.
struct Report {
  std::vector<StageTime> seconds;
  std::vector<std::pair<std::string, double>> figures;  ///< iterations, peak memory, counts
  std::vector<std::string> notes;                       ///< warnings that were printed
};

/// A reduced body: all that its motion is computed from, and what is known of how it was made.
struct Body {
  std::string name = "body";
  Checksums checksums;
  Geometry geometry;
  Basis basis;
  std::optional<Modes> modes;
  std::optional<Reduction> reduction;
  std::optional<Polynomial> polynomial;
  std::optional<Inertia> inertia;
  std::vector<SetLoad> loads;
  Report report;
};

/// What the run that wrote a model depended on.
struct Provenance {
  std::string program;                                        ///< "ritz-reduce 0.1.0"
  std::vector<std::pair<std::string, std::string>> versions;  ///< PETSc, SLEPc, MPI, BLAS
  std::vector<std::pair<std::string, std::string>> options;   ///< every resolved option
  int ranks = 1;
};

/// What one file holds: one body or several, whose names differ.
struct Model {
  Provenance provenance;
  std::vector<Body> bodies;
};

}  // namespace ritz::model
