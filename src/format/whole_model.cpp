#include "read.hpp"
#include "ritz/format/parts.hpp"

namespace ritz::format {

namespace {

void check_fit(const ModelReader& in, const model::Body& body) {
  const auto r = body.basis.U.cols();
  const auto group = [&](std::string_view part) { return schema::body_part(body.name, part); };
  if (r > 0 && body.basis.U.rows() != 3 * body.geometry.points.rows())
    fail(in, group(schema::basis), "does not have the vertices of the geometry");
  if (body.inertia && body.inertia->gram.rows() != 4 + 3 * r)
    fail(in, group(schema::inertia), "does not have the columns of the basis");
  if (body.reduction && body.reduction->stiffness.size() != r)
    fail(in, group(schema::reduction), "does not have the columns of the basis");
  if (body.polynomial && body.polynomial->r != r)
    fail(in, group(schema::polynomial), "does not have the columns of the basis");
  for (const auto& load : body.loads)
    if (load.total.rows() != r) fail(in, group(schema::loads), "does not have the columns of the basis");
}

}  // namespace

void write(const std::filesystem::path& path, const model::Model& model) {
  const auto& body = model.body;
  ModelWriter out(path);
  const auto slices = whole(body.geometry);
  write_provenance(out, model.provenance);
  write_geometry(out, body.geometry, slices, body.name);
  write_basis(out, body.basis, {0, body.basis.U.rows() / 3}, body.name);
  if (body.modes) write_modes(out, *body.modes, body.name);
  if (body.reduction) write_reduction(out, *body.reduction, body.name);
  if (body.polynomial) write_polynomial(out, *body.polynomial, body.name);
  if (body.inertia) write_inertia(out, *body.inertia, body.name);
  write_loads(out, body.loads, body.name);
  write_report(out, model.report);
  out.commit();
}

model::Model read(const ModelReader& in) {
  model::Model model;
  const auto bodies = in.bodies();
  if (bodies.empty()) fail(in, std::string(schema::bodies), "is missing or empty");
  auto& body = model.body;
  body.name = bodies.front();
  body.geometry = read_geometry(in, body.name);
  body.basis = read_basis(in, {}, body.name);
  body.modes = read_modes(in, body.name);
  body.reduction = read_reduction(in, body.name);
  body.polynomial = read_polynomial(in, body.name);
  body.inertia = read_inertia(in, body.name);
  body.loads = read_loads(in, body.name);
  check_fit(in, body);
  model.provenance = read_provenance(in);
  model.report = read_report(in);
  return model;
}

model::Model read(const std::filesystem::path& path) { return read(ModelReader(path)); }

}  // namespace ritz::format
