// What ritz-inspect says about a model: as text, as checks (--check), and as numbers (--summary FILE.json, described in
// docs/summary.md).
#pragma once
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "ritz/base/program.hpp"
#include "ritz/files/claim.hpp"
#include "ritz/files/json.hpp"
#include "ritz/format/parts.hpp"
#include "ritz/format/reader.hpp"

namespace ritz::tools {

/// Prints what there is: the parts of each body, the program and its options, the report; to a verbose voice also
/// residuals, participation factors, checksums, all figures of the report, the datasets. Frequencies in Hz, the rest in
/// SI. Throws InputError for a damaged file.
void describe(const format::ModelReader& in, Voice voice, std::ostream& out);

/// "tet4"; of cells that ritz does not know "VTK type 13".
std::string cell_name(std::uint8_t vtk_type);

void describe_geometry(const model::Geometry& geometry, std::ostream& out);
void describe_basis(const format::BasisSize& size, std::ostream& out);
/// A row a mode: kind and frequency; and what certifies that none is missing.
void describe_modes(const model::Modes& modes, Voice voice, std::ostream& out);
/// What U was cut from, and by how much.
void describe_reduction(const model::Reduction& reduction, Voice voice, std::ostream& out);
/// Counts of coefficients and their size.
void describe_polynomial(const model::Polynomial& polynomial, std::ostream& out);
void describe_cubature(const model::Cubature& cubature, std::ostream& out);
/// Mass, centre, tensor, and the effective masses of U's columns.
void describe_inertia(const model::Inertia& inertia, Voice voice, std::ostream& out);
void describe_loads(const std::vector<model::SetLoad>& loads, std::ostream& out);

/// What was measured of a body.
struct CheckedBody {
  std::string name;
  double orthonormality = 0;        ///< max |UᵀMU − I|
  std::optional<double> stiffness;  ///< max |K̃(0) − UᵀKU| / max |UᵀKU| of a polynomial
};

/// Verifies every checksum and what must hold between the parts: none missing, shapes, finite numbers, eigenvalues that
/// ascend with the rigid ones first, no mode missed below the certificate's shift, UᵀMU = I to 1e-12, the polynomial's
/// K̃(0) equal to the reduction's diagonal to 1e-9 of its largest entry. Prints an "ok" line a check. Throws InputError
/// with one sentence on the first that fails.
std::vector<CheckedBody> check(const format::ModelReader& in, std::ostream& out);

/// `checked`: what --check measured, a body each; nothing where it was not asked for.
files::Json summary(const format::ModelReader& in, const std::optional<std::vector<CheckedBody>>& checked);

/// Takes the name `path` for the summary of a model. Throws InputError where it cannot be written to or is the model.
files::Claim claim_summary(const std::filesystem::path& path, const std::filesystem::path& model);

/// Writes a summary to `path`, which gets its name when it is complete. Throws InputError or NumericalError where it
/// cannot be written.
void write_summary(const files::Json& summary, const std::filesystem::path& path, const files::Claim& claim);

}  // namespace ritz::tools
