// How far too stiff linear cells are for the modes that were found on them.
#pragma once
#include <string>
#include <vector>

#include "ritz/stages/linear_modes.hpp"

namespace ritz::stages {

/// The mesh's error in one mode, from the strains that its cells cannot follow.
///
/// Zienkiewicz and Zhu: the strains of the Tet4 and Hex8 cells around a vertex, weighted by their volumes, give a
/// continuous field ε*, linear in a cell as its shape functions are; η² = ∫ (ε* − ε) : C : (ε* − ε) / ∫ ε : C : ε.
/// What the mesh adds to λ is taken as η² λ. Cells are averaged with those of like stiffness alone (Young's moduli in
/// one octave), for strains jump where stiffness does.
///
/// Against Tet10 on the same or finer cells, over some 350 modes of bars, beams, plates, blocks and cubes of one to
/// eight layers: errors of 2 to 60 % of a frequency were estimated at .4 to 1.3 of what they are (mostly .8 to 1.1),
/// larger ones too low, down to a quarter; one layer of cells that twist, all of one strain, is not seen. No estimate
/// was above the true error by more than 3 points.
struct LinearCellsError {
  double frequency = 0;  ///< estimated: how much too high, relative to the right one
  double layers = 0;     ///< estimated: cells across what bends or twists, from how ε* varies within a cell
};

/// Of each mode, by λ and displacements `u` (M-normalised; rows of owned vertices, 3 a vertex). *Collective*.
std::vector<LinearCellsError> linear_cells_errors(const Problem& problem, const Eigen::VectorXd& lambda,
                                                  mesh::VertexRef u);

/// A sentence on the lowest flexible modes (at most six, up to four times the first frequency), or nothing: where a
/// frequency is estimated to be a quarter too high, or a tenth and less than 2.6 cells lie across what bends.
/// Thick bodies and bars that stretch pass. *Collective*.
std::vector<std::string> linear_cells_warning(const Problem& problem, const ModesResult& modes);

}  // namespace ritz::stages
