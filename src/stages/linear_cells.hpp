// Estimates by how much linear cells are too stiff for the modes that were found on them.
#pragma once
#include <string>
#include <vector>

#include "ritz/stages/linear_modes.hpp"

namespace ritz::stages {

/// The discretization error of one mode, from the strains that the cells cannot represent.
///
/// By Zienkiewicz and Zhu: the strains of the Tet4 and Hex8 cells around a vertex, averaged with their volumes as
/// weights, give a continuous field ε*, interpolated in each cell by its shape functions. With
///   η² = ∫ (ε* − ε) : C : (ε* − ε) / ∫ ε : C : ε
/// the mesh is taken to add η² λ to λ. Only cells of similar stiffness (Young's moduli within one octave) are averaged,
/// because strains jump where the stiffness does.
///
/// Compared with Tet10 on the same or finer cells, over some 350 modes of bars, beams, plates, blocks and cubes of one
/// to eight layers: errors of 2 to 60 % of a frequency were estimated at 0.4 to 1.3 (mostly 0.8 to 1.1) times their
/// true size; larger errors were underestimated, down to a quarter; one layer of cells in torsion, all with the same
/// strain, goes unnoticed. No estimate exceeded the true error by more than 3 percentage points.
struct LinearCellsError {
  double frequency = 0;  ///< estimated excess of the frequency, relative to the exact one
  double layers = 0;     ///< estimated number of cells across what bends or twists, from how ε* varies within a cell
};

/// *Collective*. The error of each mode, from λ and the displacements `u` (M-normalised; rows of owned vertices, 3 for
/// each).
std::vector<LinearCellsError> linear_cells_errors(const Problem& problem, const Eigen::VectorXd& lambda,
                                                  mesh::VertexRef u);

/// *Collective*. A warning of one sentence about the lowest flexible modes (at most six, up to four times the first
/// frequency), or nothing. It is given if a frequency is estimated to be a quarter too high, or a tenth too high with
/// fewer than 2.6 cells across what bends. Thick bodies and bars that stretch get none.
std::vector<std::string> linear_cells_warning(const Problem& problem, const ModesResult& modes);

}  // namespace ritz::stages
