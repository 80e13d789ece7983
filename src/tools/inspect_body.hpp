// The parts of one body in words.
#pragma once
#include <iosfwd>

#include "ritz/format/parts.hpp"

namespace ritz::tools {

/// "tet4"; of cells that ritz does not know "VTK type 13".
std::string cell_name(std::uint8_t vtk_type);

void describe_geometry(const model::Geometry& geometry, std::ostream& out);
void describe_basis(const format::BasisSize& size, std::ostream& out);
/// A row a mode: kind, frequency, residual; and what certifies that none is missing.
void describe_modes(const model::Modes& modes, std::ostream& out);
/// What U was cut from, and by how much.
void describe_reduction(const model::Reduction& reduction, std::ostream& out);
/// Counts of coefficients and their size.
void describe_polynomial(const model::Polynomial& polynomial, std::ostream& out);
/// Mass, centre, tensor, and the effective masses of U's columns.
void describe_inertia(const model::Inertia& inertia, std::ostream& out);
void describe_loads(const std::vector<model::SetLoad>& loads, std::ostream& out);

}  // namespace ritz::tools
