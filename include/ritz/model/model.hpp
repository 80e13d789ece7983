// The reduced model as plain values, in SI units throughout; a part that no scene needs is an absent optional. n is the
// number of vertices of the mesh (those that cells use), r the number of columns of the basis U.
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

/// Row-major arrays, 3n x r and n x 3: the three components of a vertex are adjacent.
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// The cells to draw: those of the volume or, if only the surface is stored, its boundary faces. VTK's numbers of
/// types, and VTK's order of vertices.
struct DrawnCells {
  std::vector<std::uint8_t> vtk_types;
  std::vector<std::int64_t> offsets;  ///< cell i has vertices[offsets[i] ... offsets[i + 1]); one entry more than cells
  std::vector<std::int64_t> vertices;  ///< rows of `points`
};

struct VertexSet {
  std::string name;
  std::vector<std::int64_t> rows;  ///< rows of `points` that belong to the set and are stored, ascending
  std::int64_t full_count;         ///< number of vertices of the set in the whole mesh
};

struct RegionMaterial {
  std::string region;
  fem::Material material;
};

/// Which vertices are stored: all of the mesh, or those of its surface.
enum class Rows : std::uint8_t { all, surface };

/// The stored vertices, and what is needed to draw and to name them.
struct Geometry {
  Rows rows = Rows::all;
  std::int64_t full_vertices = 0;  ///< n of the whole mesh, even if only the surface is stored
  Points points;                   ///< n_stored x 3: the stored vertices at rest, m, in the order of the mesh file
  std::vector<std::int64_t> vertex_ids;  ///< the mesh file's number of each stored vertex
  DrawnCells cells;
  std::vector<VertexSet> sets;
  std::vector<RegionMaterial> materials;
};

/// The basis U of displacements u = U z. It is mass-orthonormal over the whole mesh (UᵀMU = I), of which it has the
/// rows of the stored vertices.
struct Basis {
  RowMatrix U;  ///< 3 n_stored x r, 1/sqrt(kg)
};

enum class ModeKind : std::uint8_t { rigid, flexible };
enum class Certified : std::uint8_t { no, probabilistic, inertia_f32, inertia };

/// √λ / 2π, Hz; 0 where λ is negative, by rounding.
double frequency(double eigenvalue);

/// An independent count of the modes below `shift`.
struct Certificate {
  Certified kind = Certified::no;
  double shift = 0;          ///< σ, rad²/s², above the last mode kept
  std::int64_t counted = 0;  ///< eigenvalues below σ by the inertia of K − σM
  std::int64_t found = 0;    ///< eigenvalues below σ that were computed
};

/// The k modes of Kψ = λMψ (Eq. 1 of the notes) in ascending order, rigid ones first. Without a Reduction, column i of
/// U is mode i.
struct Modes {
  Eigen::VectorXd eigenvalues;  ///< λ = ω², k numbers, rad²/s²; 0 for a rigid mode
  Eigen::VectorXd energies;  ///< ψᵀKψ / ψᵀMψ as computed, rad²/s²; of rigid modes from their strains, which tells how
                             ///< rigid they are
  Eigen::VectorXd residuals;  ///< ‖Kψ − λMψ‖ / (λ‖Mψ‖); for a rigid mode ‖Kψ‖ / (‖K‖‖ψ‖)
  std::vector<std::uint8_t> floor_applies;  ///< 1 where the residual passed only because ‖Kψ − λMψ‖ ≤ 10 ε‖K‖‖ψ‖
  std::vector<ModeKind> kinds;
  double orthonormality = 0;  ///< max |ΨᵀMΨ − I|
  Certificate certificate;
};

/// The Gram matrix G = Bᵀ M_s B of size 4 + 3r, where M_s is the scalar consistent mass (kg) and
/// B = [1, X, Y, Z, U_x, U_y, U_z]: X, Y, Z are the coordinates minus `origin`, and U_x (n x r) has the rows of U for
/// the x components, zero where they are fixed.
struct Inertia {
  Eigen::Vector3d origin;  ///< m
  Eigen::MatrixXd gram;    ///< G, (4 + 3r) x (4 + 3r)

  double mass() const;                     ///< of the body, kg
  Eigen::Vector3d centre_of_mass() const;  ///< m
  Eigen::Matrix3d tensor() const;          ///< the tensor of inertia about the centre of mass, kg m²
  /// UᵀMR, r x 6, √kg and √kg m: the columns of R are unit translations along x, y, z and unit rotations about axes
  /// along x, y, z through the centre of mass.
  Eigen::MatrixXd rigid_coupling() const;
  /// The participation factors UᵀMR, as rigid_coupling returns them, for printing: an entry below 1e-9 of the largest
  /// that a column of U could have, √mass or √tr(tensor), is set to zero.
  Eigen::MatrixXd participation_factors() const;
  /// (ψᵀMR_d)² for the three translations R_d, r x 3, kg. Summed over any number of modes it is at most the mass of the
  /// body.
  Eigen::MatrixXd effective_masses() const;
};

/// Unit loads b on a named set, projected onto the basis: Uᵀb.
struct SetLoad {
  std::string set;
  std::int64_t vertices = 0;  ///< number of vertices that share a total force
  Eigen::MatrixXd total;      ///< r x 3, 1/√kg: total forces of 1 N along x, y, z, shared equally by the vertices
  bool has_surface = false;   ///< whether the three members below are set
  double area = 0;            ///< of the surface, m²
  Eigen::VectorXd pressure;   ///< r, m²/√kg: a pressure of 1 Pa, which pushes into the body
  Eigen::MatrixXd traction;   ///< r x 3, m²/√kg: tractions of 1 Pa along x, y, z
};

/// How the basis of a model with modal derivatives, snapshots or residual vectors was made (Eqs. 12, 18 of the notes).
/// Absent: the columns of U are the modes.
struct Reduction {
  Eigen::VectorXd stiffness;  ///< the diagonal of UᵀKU, whose other entries are zero, r, ascending, rad²/s²; 0: rigid
  Eigen::Index residual_vectors = 0;  ///< how many directions of U are static answers, whatever their σ
  Eigen::VectorXd singular_values;  ///< σ (M-norm) of the vectors that the others were cut from, descending, of which
                                    ///< the first are kept; none where the others are the modes
  double discarded = 0;  ///< √(Σσ²) over all that U leaves out, with a bound for what was not computed; units of σ

  Eigen::Index kept() const;  ///< how many of the singular values belong to directions of U
};

/// The energy of St. Venant-Kirchhoff material over U (Sec. 3.1 of the notes), exact for the quadrature rules of the
/// elements:
///   Ẽ(z) = ½ A_ij z_i z_j + ⅙ B_ijk z_i z_j z_k + 1/24 C_ijkl z_i z_j z_k z_l.
/// A, B, C are the second, third and fourth derivatives of Ẽ at rest, fully symmetric. Each entry is stored once, for
/// i ≤ j ≤ k ≤ l in lexicographic order.
struct Polynomial {
  Eigen::Index r = 0;
  Eigen::VectorXd quadratic;  ///< A, r(r+1)/2 numbers, 1/s²
  Eigen::VectorXd cubic;      ///< B, C(r+2, 3) numbers, 1/(s² m √kg)
  Eigen::VectorXd quartic;    ///< C, C(r+3, 4) numbers, 1/(s² m² kg)
};

/// What a cubature integrates: the whole energy of the material, or its difference to the body's Polynomial, which is
/// exact for St. Venant-Kirchhoff laws of the same constants at rest and has the larger part of the energy near rest.
enum class Integrand : std::uint8_t { energy, beyond_polynomial };

/// The errors of reduced forces over some poses: ‖Λ^(−½)(f̃ − f)‖ / ‖Λ^(−½) f‖ of each pose, where f = Uᵀf(Uz) is the
/// projected force of all cells and Λ the diagonal of UᵀKU; near rest it is the relative error of a displacement in
/// the energy norm.
struct PoseErrors {
  double root_mean_square = 0;  ///< √ of the mean of squares over the poses
  double largest = 0;
};

/// The errors of a cubature of some number of cells: over the poses that it was trained on, and over others that it has
/// never seen, of two kinds.
struct CubatureError {
  std::int64_t cells = 0;
  PoseErrors training;
  PoseErrors lifts;  ///< held out: low modes with their second-order corrections, u = Σ p_i ψ_i + ½ Σ p_i p_j Φ_ij
  PoseErrors statics;  ///< held out: equilibria of the reduced model under loads
};

/// The energy of any law over U, or what the Polynomial lacks of it, by cubature (Eqs. 8-11 of the notes) over T cells,
/// which have P quadrature points together:
///   Ẽ(z) = Ẽ_polynomial(z) + Σ_c w_c Σ_{p of c} V_p (W(G_p(z)) − W_StVK(G_p(z))),   G_p(z) = Σ_i z_i G_pi,
/// where G_p = ∇u is the displacement gradient; of Integrand::energy the first and the last term are absent.
struct Cubature {
  Integrand integrand = Integrand::energy;
  std::vector<std::int64_t> cells;    ///< T, the mesh file's numbers of the cells, ascending
  Eigen::VectorXd weights;            ///< w, T, 1; > 0
  std::vector<std::int64_t> regions;  ///< T, entries of Geometry::materials
  std::vector<std::int64_t> starts;   ///< T + 1: cell c has points starts[c] ... starts[c + 1]
  Eigen::VectorXd volumes;            ///< V, P, m³: quadrature weight times det J of the cell
  Eigen::MatrixXd gradients;          ///< 9P x r, 1/(m √kg): rows 9p + 3j + i are ∂u_i/∂X_j of the columns of U
  double largest_energy = 0;          ///< J, of the poses of the training: beyond it the cubature is not tested
  std::vector<CubatureError> errors;  ///< in the order of their numbers of cells; the last is of this cubature
};

/// Hashes, in hexadecimal, of what a body was made from.
struct Checksums {
  std::string mesh;     ///< of the vertices, cells and regions
  std::string problem;  ///< of these and the materials and supports: everything that the modes depend on
};

/// The time that a stage of the reduction took, s.
struct StageTime {
  std::string stage;
  double seconds;
};

/// Diagnostics of a body's reduction. No motion depends on them.
struct Report {
  std::vector<StageTime> seconds;
  std::vector<std::pair<std::string, double>> figures;  ///< iterations, peak memory, counts, by name
  std::vector<std::string> notes;                       ///< the warnings that were printed
  Eigen::VectorXd mesh_errors;                          ///< of each mode f_h / f − 1, estimated; empty if none were
};

/// A reduced body: everything that its motion is computed from, and how it was made.
struct Body {
  std::string name = "body";
  Checksums checksums;
  Geometry geometry;
  Basis basis;
  std::optional<Modes> modes;
  std::optional<Reduction> reduction;
  std::optional<Polynomial> polynomial;
  std::optional<Cubature> cubature;
  std::optional<Inertia> inertia;
  std::vector<SetLoad> loads;
  Report report;
};

/// Whether the body has forces of large displacements: a polynomial, a cubature or both.
inline bool is_nonlinear(const Body& body) { return body.polynomial || body.cubature; }

/// The run that wrote a model: its program, the versions of libraries, and its options.
struct Provenance {
  std::string program;                                        ///< "ritz-reduce 0.1.0"
  std::vector<std::pair<std::string, std::string>> versions;  ///< PETSc, SLEPc, MPI, BLAS
  std::vector<std::pair<std::string, std::string>> options;   ///< name and value of every option, defaults included
  int ranks = 1;                                              ///< number of MPI ranks
};

/// The contents of one file: one body or several, with distinct names.
struct Model {
  Provenance provenance;
  std::vector<Body> bodies;
};

}  // namespace ritz::model
