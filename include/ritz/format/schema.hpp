// The names of every group, dataset and attribute of the files, in one place. Their shapes, units and meanings are in
// src/format/README.md.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace ritz::format::schema {

inline constexpr std::string_view format_name = "ritz-model";

/// The version of the format. A file is written as the oldest one whose readers understand all that it has.
struct Version {
  std::int64_t major;  ///< raised when an older reader would misread the file
  std::int64_t minor;  ///< raised when something is added that an older reader may ignore
};
inline constexpr Version usual = {1, 4};
inline constexpr Version with_cubature = {2, 0};  ///< a reader of version 1 would take the polynomial for the whole
inline constexpr std::int64_t newest_major = 2;

// Attributes of the root.
inline constexpr auto format = "format";
inline constexpr auto version = "version";

// Attributes of every dataset.
inline constexpr auto units = "units";
inline constexpr auto checksum = "checksum";

// Groups.
inline constexpr std::string_view provenance = "/provenance";
inline constexpr std::string_view bodies = "/bodies";
inline constexpr std::string_view report = "/report";
inline constexpr std::string_view vtkhdf = "/VTKHDF";
inline constexpr std::array<std::string_view, 4> roots = {bodies, provenance, report, vtkhdf};  ///< of the whole file
inline constexpr std::string_view geometry = "geometry";
inline constexpr std::string_view basis = "basis";
inline constexpr std::string_view modes = "modes";
inline constexpr std::string_view reduction = "reduction";
inline constexpr std::string_view polynomial = "polynomial";
inline constexpr std::string_view cubature = "cubature";
inline constexpr std::string_view inertia = "inertia";
inline constexpr std::string_view loads = "loads";
inline constexpr std::string_view default_body = "body";

// provenance
inline constexpr auto program = "program";
inline constexpr auto versions = "versions";
inline constexpr auto options = "options";
inline constexpr auto mesh_checksum = "mesh_checksum";
inline constexpr auto problem_checksum = "problem_checksum";
inline constexpr auto ranks = "ranks";

// geometry
inline constexpr auto rows = "rows";
inline constexpr auto full_vertices = "full_vertices";
inline constexpr auto points = "points";
inline constexpr auto vertex_ids = "vertex_ids";
inline constexpr auto cell_types = "cells/types";
inline constexpr auto cell_offsets = "cells/offsets";
inline constexpr auto cell_vertices = "cells/vertices";
inline constexpr auto sets = "sets";
inline constexpr auto set_rows = "rows";
inline constexpr auto full_count = "full_count";
inline constexpr auto materials = "materials";
inline constexpr auto regions = "regions";
inline constexpr auto laws = "laws";
inline constexpr auto density = "density";

// basis
inline constexpr auto column_count = "column_count";
inline constexpr auto columns = "columns";
inline constexpr auto U = "U";

// modes
inline constexpr auto eigenvalues = "eigenvalues";
inline constexpr auto energies = "energies";
inline constexpr auto residuals = "residuals";
inline constexpr auto floor_applies = "floor_applies";
inline constexpr auto kinds = "kinds";
inline constexpr auto orthonormality = "orthonormality";
inline constexpr auto certificate = "certificate";
inline constexpr auto certified = "certified";
inline constexpr auto shift = "shift";
inline constexpr auto counted = "counted";
inline constexpr auto found = "found";

// reduction
inline constexpr auto stiffness = "stiffness";
inline constexpr auto singular_values = "singular_values";
inline constexpr auto discarded = "discarded";
inline constexpr auto residual_vectors = "residual_vectors";

// polynomial
inline constexpr auto quadratic = "quadratic";
inline constexpr auto cubic = "cubic";
inline constexpr auto quartic = "quartic";

// cubature
inline constexpr auto integrand = "integrand";
inline constexpr auto largest_energy = "largest_energy";
inline constexpr auto numbers = "cells";
inline constexpr auto weights = "weights";
inline constexpr auto cell_regions = "regions";
inline constexpr auto starts = "starts";
inline constexpr auto volumes = "volumes";
inline constexpr auto gradients = "gradients";
inline constexpr auto error_cells = "errors/cells";
inline constexpr auto error_figures = "errors/figures";

// inertia
inline constexpr auto origin = "origin";
inline constexpr auto gram = "gram";

// loads
inline constexpr auto set_vertices = "vertices";
inline constexpr auto total = "total";
inline constexpr auto area = "area";
inline constexpr auto pressure = "pressure";
inline constexpr auto traction = "traction";

// report
inline constexpr auto stages = "stages";
inline constexpr auto seconds = "seconds";
inline constexpr auto figure_names = "figure_names";
inline constexpr auto figure_values = "figure_values";
inline constexpr auto notes = "notes";
inline constexpr auto mesh_errors = "mesh_errors";

// Motion files and last states.
namespace motion {
inline constexpr std::string_view format_name = "ritz-motion 1";
inline constexpr auto points = "/points";
inline constexpr auto vertex_ids = "/vertex_ids";
inline constexpr auto cells = "/cells";
inline constexpr auto times = "/times";
inline constexpr auto z = "/z";
inline constexpr auto zdot = "/zdot";
inline constexpr auto model_checksum = "model_checksum";
inline constexpr auto frame_times = "/frame_times";
inline constexpr auto displacement = "/displacement";
inline constexpr auto snapshots = "/snapshots";
inline constexpr auto frames = "/frames";
inline constexpr auto state = "/state";
inline constexpr std::array<const char*, 4> vertex_arrays = {points, "/state/displacement", "/state/velocity",
                                                             "/state/acceleration"};
inline constexpr std::array<const char*, 6> state_numbers = {"t", "kinetic", "elastic", "work", "dissipated", "start"};
inline constexpr auto integrator = "integrator";
inline constexpr auto kind = "kind";
inline constexpr auto history = "/state/history";
inline constexpr auto scene_checksum = "scene_checksum";
inline constexpr auto steps = "steps";
inline constexpr auto last_step = "last_step";
inline constexpr std::array energies = {"start", "gained", "lost", "available", "work", "dissipated"};
inline constexpr std::array energy_gain = {"gain_since", "gain_largest"};
}  // namespace motion

/// "parent/child".
std::string join(std::string_view parent, std::string_view child);
/// "/bodies/BODY", where BODY is link_name(body).
std::string body_group(std::string_view body);
/// "/bodies/BODY/PART".
std::string body_part(std::string_view body, std::string_view part);
/// A name as an HDF5 link: '/', '%' and the zero byte become %2F, %25 and %00, a leading '.' becomes %2E; the empty
/// name becomes "%".
std::string link_name(std::string_view name);
/// The inverse of link_name.
std::string name_of_link(std::string_view link);
/// "0001" for column 0, "0002" for column 1, ...
std::string column_name(std::int64_t column);

}  // namespace ritz::format::schema
