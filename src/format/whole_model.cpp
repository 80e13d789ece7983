#include "ritz/format/sound.hpp"

namespace ritz::format {

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
  auto& body = model.body;
  body.name = in.first_body();
  check_shapes(in, body.name);
  body.geometry = read_geometry(in, body.name);
  body.basis = read_basis(in, {}, body.name);
  body.modes = read_modes(in, body.name);
  body.reduction = read_reduction(in, body.name);
  body.polynomial = read_polynomial(in, body.name);
  body.inertia = read_inertia(in, body.name);
  body.loads = read_loads(in, body.name);
  model.provenance = read_provenance(in);
  model.report = read_report(in);
  return model;
}

model::Model read(const std::filesystem::path& path) { return read(ModelReader(path)); }

}  // namespace ritz::format
