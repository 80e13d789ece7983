// One write/read pair for each part of a model. See src/format/README.md for the shapes in the file.
//
// Every write_* is *Collective* and throws std::runtime_error when the file cannot be written. What is not said to be
// sliced is replicated: the same on all ranks (the file gets that of the rank with Access::writes_small).
// Every read_* verifies checksums and shapes and throws InputError that names the file and the HDF5 path.
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

/// Where the rows that one rank holds stand in the whole array: from row `first`, of `total` rows over all ranks.
struct Slice {
  Index first = 0;
  Index total = 0;
};

/// Where one rank's part of the geometry stands.
struct GeometrySlices {
  Slice vertices;       ///< rows of points and vertex_ids
  Slice cells;          ///< cells
  Slice cell_vertices;  ///< entries of DrawnCells::vertices
};

/// The slices of a geometry that one rank holds alone.
GeometrySlices whole(const model::Geometry& geometry);

/// Writes the geometry, and the grid that ParaView sees.
/// `mine` holds this rank's points, vertex_ids and cells: its cells.offsets count from its own first entry (or are
/// empty when it has no cells), its cells.vertices are rows of the whole array of points. Sets (rows of the whole) and
/// materials are replicated.
void write_geometry(ModelWriter& out, const model::Geometry& mine, const GeometrySlices& slices,
                    std::string_view body = schema::default_body);
model::Geometry read_geometry(const ModelReader& in, std::string_view body = schema::default_body);

/// Fills `values` (three for each vertex of this rank, components of a vertex together) with column `column` of U.
using ColumnSource = std::function<void(Index column, std::span<double> values)>;

/// Writes U column by column: `columns` in all, of which this rank holds the rows of `my_vertices` vertices.
/// After write_geometry, so that ParaView sees each column as a point vector.
void write_basis(ModelWriter& out, Index columns, Index my_vertices, Slice vertices, const ColumnSource& source,
                 std::string_view body = schema::default_body);
/// The same from this rank's rows of U, 3 x its vertices.
void write_basis(ModelWriter& out, const model::Basis& mine, Slice vertices,
                 std::string_view body = schema::default_body);

/// Which part of U to read; absent: all of it. Any order is allowed, 0-based.
/// Reading runs from the least to the greatest vertex named; checksums are verified when that is all of them.
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
/// Absent when the model has no such part.
std::optional<model::Modes> read_modes(const ModelReader& in, std::string_view body = schema::default_body);

void write_reduction(ModelWriter& out, const model::Reduction& reduction, std::string_view body = schema::default_body);
/// Absent when the model has no such part: its basis is its modes.
std::optional<model::Reduction> read_reduction(const ModelReader& in, std::string_view body = schema::default_body);

void write_polynomial(ModelWriter& out, const model::Polynomial& polynomial,
                      std::string_view body = schema::default_body);
/// Absent when the model has no such part.
std::optional<model::Polynomial> read_polynomial(const ModelReader& in, std::string_view body = schema::default_body);

void write_inertia(ModelWriter& out, const model::Inertia& inertia, std::string_view body = schema::default_body);
/// Absent when the model has no such part.
std::optional<model::Inertia> read_inertia(const ModelReader& in, std::string_view body = schema::default_body);

/// Writes nothing when there are no loads.
void write_loads(ModelWriter& out, const std::vector<model::SetLoad>& loads,
                 std::string_view body = schema::default_body);
/// In the order they were written in; empty when the model has no such part.
std::vector<model::SetLoad> read_loads(const ModelReader& in, std::string_view body = schema::default_body);

void write_provenance(ModelWriter& out, const model::Provenance& provenance);
model::Provenance read_provenance(const ModelReader& in);

void write_checksums(ModelWriter& out, const model::Checksums& checksums, std::string_view body = schema::default_body);
model::Checksums read_checksums(const ModelReader& in, std::string_view body = schema::default_body);

void write_report(ModelWriter& out, const model::Report& report, std::string_view body = schema::default_body);
/// Empty when the body has no report.
model::Report read_report(const ModelReader& in, std::string_view body = schema::default_body);

/// All parts of a body, from one rank, under its own name. Bodies are written one after another.
void write_body(ModelWriter& out, const model::Body& body);
/// All parts of the body called `name`. Throws InputError, also when there is no such body and when its parts do not
/// fit together.
model::Body read_body(const ModelReader& in, const std::string& name);

/// A whole model at once, from one rank. Commits.
void write(const std::filesystem::path& path, const model::Model& model);
/// Everything in the file. Throws InputError as read_body does, and where there is no body.
model::Model read(const std::filesystem::path& path);
model::Model read(const ModelReader& in);

}  // namespace ritz::format
