// One write/read pair for each part of a model. See src/format/README.md for the shapes in the file.
//
// Every write_* is *Collective* and throws std::runtime_error on all ranks when the file cannot be written. Arguments
// are replicated (the same on all ranks; the rank with Access::writes_small writes them) unless their comment says that
// each rank passes its own rows.
// Every read_* verifies shapes, types and checksums, and throws an InputError that names the file and the HDF5 path,
// also when the geometry or the basis of the body is missing.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ritz/format/reader.hpp"
#include "ritz/format/writer.hpp"
#include "ritz/model/model.hpp"

namespace ritz::format {

using Index = std::int64_t;

/// Where the rows of one rank stand in the whole array: they begin at row `first`, of `total` rows over all ranks.
struct Slice {
  Index first = 0;
  Index total = 0;
};

/// Where one rank's part of the geometry stands.
struct GeometrySlices {
  Slice vertices;       ///< rows of points and vertex_ids
  Slice cells;          ///< rows of cells
  Slice cell_vertices;  ///< entries of DrawnCells::vertices
};

/// The slices for a rank that holds the whole geometry.
GeometrySlices whole(const model::Geometry& geometry);

/// Writes the geometry, and the grid for ParaView. `mine` holds the points, vertex_ids and cells of this rank: its
/// cells.offsets count from its own first entry (they are empty when it has no cells), its cells.vertices are rows of
/// the whole array of points. Sets (rows of the whole array) and materials are replicated.
void write_geometry(ModelWriter& out, const model::Geometry& mine, const GeometrySlices& slices,
                    std::string_view body = schema::default_body);
model::Geometry read_geometry(const ModelReader& in, std::string_view body = schema::default_body);

/// The materials of the geometry alone; empty where none are stored.
std::vector<model::RegionMaterial> read_materials(const ModelReader& in, std::string_view body = schema::default_body);

/// Writes column `column` of U, 1/√kg, to `values`: three numbers for each vertex of this rank, the components of one
/// vertex together.
using ColumnSource = std::function<void(Index column, std::span<double> values)>;

/// How ParaView shows a column of U: as an array of displacements, m, which are the column times `factor`, m √kg.
struct ShownColumn {
  std::string name;
  double factor = 1;
};

/// What columns are called: "mode 07, 440.0 Hz" or "mode 01, rigid" where U is the modes, counted from 1 with the rigid
/// ones, so that --animate-mode takes the same number; of another basis "column 07, 440.0 Hz", by the frequency at
/// which the body would swing in that column alone.
std::vector<std::string> column_names(Index columns, const std::optional<model::Modes>& modes,
                                      const std::optional<model::Reduction>& reduction);
/// The factor by which a shape is seen: its largest displacement, `largest` before, becomes a tenth of the diagonal of
/// the body's bounding box. 1 for a shape that does not move.
double factor_for_the_eye(double largest, double diagonal);
/// How the columns of a whole body are shown.
std::vector<ShownColumn> shown_columns(const model::Body& body);

/// Writes the columns of U one by one, as many as are shown; this rank holds the rows of `my_vertices` vertices. Call
/// it after write_geometry: where that has written a grid for ParaView, it gets a point vector a column, in single
/// precision.
void write_basis(ModelWriter& out, const std::vector<ShownColumn>& columns, Index my_vertices, Slice vertices,
                 const ColumnSource& source, std::string_view body = schema::default_body);
/// The same from the rows of U of this rank, 3 (vertices of this rank) x r.
void write_basis(ModelWriter& out, const model::Basis& mine, const std::vector<ShownColumn>& columns, Slice vertices,
                 std::string_view body = schema::default_body);

/// Which part of U to read, 0-based and in any order; absent: all of it. The file is read from the smallest to the
/// largest vertex selected, and checksums are verified when these are all vertices. An index out of range is an
/// InputError.
struct BasisSelection {
  std::optional<std::vector<Index>> columns;
  std::optional<std::vector<Index>> vertices;  ///< rows of Geometry::points
};

struct BasisSize {
  Index vertices;
  Index columns;
};

BasisSize basis_size(const ModelReader& in, std::string_view body = schema::default_body);
model::Basis read_basis(const ModelReader& in, const BasisSelection& selection = {},
                        std::string_view body = schema::default_body);

void write_modes(ModelWriter& out, const model::Modes& modes, std::string_view body = schema::default_body);
/// Absent when the body has no such part.
std::optional<model::Modes> read_modes(const ModelReader& in, std::string_view body = schema::default_body);

void write_reduction(ModelWriter& out, const model::Reduction& reduction, std::string_view body = schema::default_body);
/// Absent when the body has no such part: its basis consists of its modes.
std::optional<model::Reduction> read_reduction(const ModelReader& in, std::string_view body = schema::default_body);

void write_polynomial(ModelWriter& out, const model::Polynomial& polynomial,
                      std::string_view body = schema::default_body);
/// Absent when the body has no such part.
std::optional<model::Polynomial> read_polynomial(const ModelReader& in, std::string_view body = schema::default_body);

/// Raises the file's version, because readers of version 1 know no cubature.
void write_cubature(ModelWriter& out, const model::Cubature& cubature, std::string_view body = schema::default_body);
/// Absent when the body has no such part.
std::optional<model::Cubature> read_cubature(const ModelReader& in, std::string_view body = schema::default_body);

void write_inertia(ModelWriter& out, const model::Inertia& inertia, std::string_view body = schema::default_body);
/// Absent when the body has no such part.
std::optional<model::Inertia> read_inertia(const ModelReader& in, std::string_view body = schema::default_body);

/// Writes nothing when there are no loads.
void write_loads(ModelWriter& out, const std::vector<model::SetLoad>& loads,
                 std::string_view body = schema::default_body);
/// In the order in which they were written; empty when the body has no such part.
std::vector<model::SetLoad> read_loads(const ModelReader& in, std::string_view body = schema::default_body);

void write_provenance(ModelWriter& out, const model::Provenance& provenance);
model::Provenance read_provenance(const ModelReader& in);

void write_checksums(ModelWriter& out, const model::Checksums& checksums, std::string_view body = schema::default_body);
model::Checksums read_checksums(const ModelReader& in, std::string_view body = schema::default_body);

void write_report(ModelWriter& out, const model::Report& report, std::string_view body = schema::default_body);
/// Empty when the body has no report.
model::Report read_report(const ModelReader& in, std::string_view body = schema::default_body);

/// A checksum of what reduced coordinates mean: of the basis U, its modes or reduction, and the polynomial if there is
/// one. Motions name it, so that none is taken for that of another model. Made of stored checksums; reads no numbers.
std::string coordinates_checksum(const ModelReader& in, std::string_view body = schema::default_body);

/// Writes all parts of a body under its own name; for one rank. Bodies are written one after another.
void write_body(ModelWriter& out, const model::Body& body);
/// Reads all parts of the body called `name`. Throws InputError, also when there is no such body or its parts do not
/// fit together.
model::Body read_body(const ModelReader& in, const std::string& name);

/// Writes a whole model and commits it; for one rank.
void write(const std::filesystem::path& path, const model::Model& model);
/// Reads the whole file. Throws InputError as read_body does, and when there is no body.
model::Model read(const std::filesystem::path& path);
model::Model read(const ModelReader& in);

}  // namespace ritz::format
