#include "inspect.hpp"

#include <map>
#include <utility>

#include "ritz/files/part_file.hpp"
#include "ritz/files/summary.hpp"
#include "ritz/format/names.hpp"
#include "ritz/format/parts.hpp"
#include "ritz/format/summaries.hpp"

namespace ritz::tools {
namespace {

using files::Json, files::json_list;

Json words(const std::vector<std::pair<std::string, std::string>>& pairs) {
  Json::Object members;
  for (const auto& [key, value] : pairs) members.emplace_back(key, value);
  return members;
}

Json materials(const model::Geometry& geometry) {
  Json::Array regions;
  for (const auto& [region, material] : geometry.materials) {
    Json::Object constants;
    for (const auto& [parameter, value] : fem::parameters(material.law)) constants.emplace_back(parameter.name, value);
    regions.emplace_back(Json::Object{{"region", region},
                                      {"law", fem::name(material.law)},
                                      {"density", material.density},
                                      {"constants", std::move(constants)}});
  }
  return regions;
}

Json geometry_members(const model::Geometry& geometry) {
  std::map<std::string, std::int64_t> counts;
  for (const auto type : geometry.cells.vtk_types) ++counts[cell_name(type)];
  Json::Object cells;
  for (const auto& [type, count] : counts) cells.emplace_back(type, count);
  Json::Array sets;
  for (const auto& set : geometry.sets)
    sets.emplace_back(Json::Object{{"name", set.name}, {"vertices", set.full_count}, {"stored", std::ssize(set.rows)}});
  Json box = nullptr;
  if (geometry.points.rows() > 0)
    box = Json::Object{{"low", json_list(Eigen::RowVector3d(geometry.points.colwise().minCoeff()))},
                       {"high", json_list(Eigen::RowVector3d(geometry.points.colwise().maxCoeff()))}};
  return Json::Object{{"rows", format::name(geometry.rows)},
                      {"vertices", geometry.points.rows()},
                      {"mesh_vertices", geometry.full_vertices},
                      {"cells", std::move(cells)},
                      {"box", std::move(box)},
                      {"materials", materials(geometry)},
                      {"sets", std::move(sets)}};
}

Json inertia_members(const model::Inertia& inertia) {
  auto members = format::summary(inertia);
  members.insert(members.begin(), {"mass", inertia.mass()});
  return members;
}

Json loads(const std::vector<model::SetLoad>& loads) {
  Json::Array sets;
  for (const auto& load : loads)
    sets.emplace_back(Json::Object{
        {"set", load.set}, {"vertices", load.vertices}, {"area", load.has_surface ? Json(load.area) : Json(nullptr)}});
  return sets;
}

Json report(const model::Report& report) {
  Json::Object figures;
  for (const auto& [name, value] : report.figures) figures.emplace_back(name, value);
  const auto& errors = report.mesh_errors;
  return Json::Object{{"stages", format::summary(report.seconds)},
                      {"figures", std::move(figures)},
                      {"mesh_error", errors.size() > 0 ? Json(json_list(errors)) : nullptr},
                      {"notes", json_list(report.notes)}};
}

template <class Part>
Json or_null(const std::optional<Part>& part) {
  return part ? Json(format::summary(*part)) : Json(nullptr);
}

Json::Object body_members(const format::ModelReader& in, const std::string& name) {
  const auto checksums = format::read_checksums(in, name);
  const auto modes = format::read_modes(in, name);
  const auto reduction = format::read_reduction(in, name);
  const auto inertia = format::read_inertia(in, name);
  const bool has_basis = in.has(format::schema::basis, name);
  const auto size = has_basis ? format::basis_size(in, name) : format::BasisSize{0, 0};
  const auto* over_modes = inertia && !reduction ? &*inertia : nullptr;
  return {{"name", name},
          {"mesh_checksum", checksums.mesh},
          {"problem_checksum", checksums.problem},
          {"geometry",
           in.has(format::schema::geometry, name) ? geometry_members(format::read_geometry(in, name)) : Json(nullptr)},
          {"columns", size.columns},
          {"inertia", inertia ? inertia_members(*inertia) : Json(nullptr)},
          {"modes", modes ? Json(format::summary(*modes, over_modes)) : Json(nullptr)},
          {"basis", or_null(reduction)},
          {"polynomial", or_null(format::read_polynomial(in, name))},
          {"cubature", or_null(format::read_cubature(in, name))},
          {"loads", loads(format::read_loads(in, name))},
          {"report", report(format::read_report(in, name))}};
}

}  // namespace

files::Json summary(const format::ModelReader& in, const std::optional<std::vector<CheckedBody>>& checked) {
  const double memory = files::peak_memory();
  auto members = files::summary_head({.program = "ritz-inspect",
                                      .ranks = 1,
                                      .output = in.name(),
                                      .stages = {},
                                      .largest_rank = memory,
                                      .all_ranks = memory,
                                      .warnings = {}});
  const auto provenance = format::read_provenance(in);
  members.emplace_back("model_format", Json::Array{in.version().major, in.version().minor});
  members.emplace_back("provenance", Json::Object{{"program", provenance.program},
                                                  {"ranks", provenance.ranks},
                                                  {"versions", words(provenance.versions)},
                                                  {"options", words(provenance.options)}});
  Json::Array bodies, checks;
  for (const auto& name : in.bodies()) bodies.emplace_back(body_members(in, name));
  members.emplace_back("bodies", std::move(bodies));
  if (checked)
    for (const auto& body : *checked)
      checks.emplace_back(
          Json::Object{{"name", body.name}, {"orthonormality", body.orthonormality}, {"stiffness", body.stiffness}});
  members.emplace_back("checked", checked ? Json(std::move(checks)) : Json(nullptr));
  return members;
}

files::Claim claim_summary(const std::filesystem::path& path, const std::filesystem::path& model) {
  return files::Claim(
      {.outputs = {{"--summary " + path.string(), path}}, .inputs = {{"the model " + model.string(), model}}});
}

void write_summary(const files::Json& summary, const std::filesystem::path& path, const files::Claim& claim) {
  files::PartFile file(path);
  file.write(files::json_text(summary));
  file.finish();
  claim.verify();
  file.publish();
  claim.say_published();
}

}  // namespace ritz::tools
