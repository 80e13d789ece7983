#include <algorithm>
#include <array>

#include "ritz/app/full_file.hpp"
#include "ritz/base/error.hpp"
#include "ritz/format/schema.hpp"
#include "ritz/format/stored_file.hpp"
#include "ritz/parallel/guard.hpp"
#include "ritz/scene/scene.hpp"

namespace ritz::app {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why) {
  throw InputError("-restart " + path.string() + ": " + why);
}

constexpr auto state_group = "/state";
constexpr std::array<const char*, 3> vectors = {"/state/displacement", "/state/velocity", "/state/acceleration"};

/// The file, in which /state is kept as ritz-full writes it.
format::StoredFile open_state(const std::filesystem::path& path) {
  format::StoredFile in(path, "-restart " + path.string(), {.kind = "motion", .writer = "ritz-full"});
  if (format::survey(in, std::array<std::string_view, 1>{state_group}).empty())
    refuse(path, "it holds no last state; name a file that ritz-full wrote");
  return in;
}

StateKind read_kind(const format::StoredFile& in, const std::filesystem::path& path) {
  const auto kind = format::read_text(in, state_group, "kind");
  if (kind != "moving" && kind != "at_rest") refuse(path, "its last state is of the unknown kind '" + kind + "'");
  return kind == "moving" ? StateKind::moving : StateKind::at_rest;
}

std::string read_integrator(const format::StoredFile& in, const std::filesystem::path& path) {
  auto integrator = format::read_text(in, state_group, "integrator");
  const auto& known = scene::integrator_names;
  if (integrator != "none" && std::ranges::find(known, integrator) == known.end())
    refuse(path, "its last state is of the unknown integrator '" + integrator + "'");
  return integrator;
}

}  // namespace

std::string verify_last_state(MPI_Comm comm, const std::filesystem::path& path) {
  std::string warning;
  parallel::on_root(comm, [&] {
    const auto in = open_state(path);
    for (const auto* name : vectors) {
      if (!format::exists(in, name)) refuse(path, std::string(name) + " is missing");
      if (format::has_attribute(in, name, format::schema::checksum)) format::verify_rows(in, name);
      else
        warning = "-restart " + path.string() +
                  ": an earlier ritz-full wrote it without checksums, so damage in its last state goes unseen";
    }
  });
  return warning;
}

LastState read_last_state(const std::filesystem::path& path, const mesh::Mesh& mesh,
                          const std::string& problem_checksum) {
  LastState state;
  const auto slice = parallel::even_slice(mesh.comm, mesh.vertices_total);
  parallel::RowMatrix rows(slice.count, 9);
  parallel::together(mesh.comm, [&] {
    const auto in = open_state(path);
    if (format::read_text(in, state_group, "problem_checksum") != problem_checksum)
      refuse(path, "it was written for another mesh, material or support");
    state.kind = read_kind(in, path);
    state.integrator = read_integrator(in, path);
    for (const auto* name : {"t", "kinetic", "elastic", "work", "dissipated", "start"})
      state.numbers[name] = format::read_double(in, state_group, name);
    for (const auto* name : {"t", "kinetic", "elastic"})
      if (state.numbers[name] < 0) refuse(path, std::string("its last state has a negative ") + name);
    for (std::size_t i = 0; i < vectors.size(); ++i) {
      parallel::RowMatrix three(slice.count, 3);
      format::read_rows(in, vectors[i], {slice.total, 3}, slice.first, slice.count, three.data());
      rows.middleCols(3 * static_cast<Eigen::Index>(i), 3) = three;
    }
  });
  const std::vector<std::int64_t> numbers(mesh.file_positions.begin(), mesh.file_positions.begin() + mesh.owned);
  const auto mine = parallel::from_slices(mesh.comm, numbers, rows, mesh.vertices_total);
  Eigen::Index part = 0;
  for (mesh::VertexRows* column : {&state.u, &state.v, &state.a}) {
    const parallel::RowMatrix three = mine.middleCols(3 * part++, 3);
    *column = Eigen::Map<const petsc::Tall>(three.data(), three.size(), 1);
  }
  return state;
}

}  // namespace ritz::app
