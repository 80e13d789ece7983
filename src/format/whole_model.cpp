#include "read.hpp"
#include "ritz/base/random.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/format/sound.hpp"

namespace ritz::format {

void write_body(ModelWriter& out, const model::Body& body) {
  write_checksums(out, body.checksums, body.name);
  write_geometry(out, body.geometry, whole(body.geometry), body.name);
  write_basis(out, body.basis, shown_columns(body), {0, body.basis.U.rows() / 3}, body.name);
  if (body.modes) write_modes(out, *body.modes, body.name);
  if (body.reduction) write_reduction(out, *body.reduction, body.name);
  if (body.polynomial) write_polynomial(out, *body.polynomial, body.name);
  if (body.cubature) write_cubature(out, *body.cubature, body.name);
  if (body.inertia) write_inertia(out, *body.inertia, body.name);
  write_loads(out, body.loads, body.name);
  write_report(out, body.report, body.name);
}

void write(const std::filesystem::path& path, const model::Model& model) {
  ModelWriter out(path);
  write_provenance(out, model.provenance);
  for (const auto& body : model.bodies) write_body(out, body);
  out.commit();
}

std::string coordinates_checksum(const ModelReader& in, std::string_view body) {
  std::uint64_t sum = 0;
  const auto add = [&](const std::string& dataset) {
    if (exists(in, dataset)) sum = split_mix(sum ^ read_bits(in, dataset, schema::checksum));
  };
  const auto part = [&](std::string_view name, std::string_view dataset) {
    return schema::join(schema::body_part(body, name), dataset);
  };
  const auto columns = part(schema::basis, schema::columns);
  for (const auto& column : links(in, columns)) add(schema::join(columns, column));
  add(part(schema::modes, schema::eigenvalues));
  add(part(schema::reduction, schema::stiffness));
  for (const auto* order : {schema::quadratic, schema::cubic, schema::quartic}) add(part(schema::polynomial, order));
  for (const auto* numbers : {schema::weights, schema::gradients}) add(part(schema::cubature, numbers));
  return formatted("%016llx", static_cast<unsigned long long>(sum));
}

model::Body read_body(const ModelReader& in, const std::string& name) {
  model::Body body;
  body.name = name;
  check_shapes(in, name);
  body.checksums = read_checksums(in, name);
  body.geometry = read_geometry(in, name);
  body.basis = read_basis(in, {}, name);
  body.modes = read_modes(in, name);
  body.reduction = read_reduction(in, name);
  body.polynomial = read_polynomial(in, name);
  body.cubature = read_cubature(in, name);
  body.inertia = read_inertia(in, name);
  body.loads = read_loads(in, name);
  body.report = read_report(in, name);
  return body;
}

model::Model read(const ModelReader& in) {
  model::Model model{read_provenance(in), {}};
  in.first_body();
  for (const auto& name : in.bodies()) model.bodies.push_back(read_body(in, name));
  return model;
}

model::Model read(const std::filesystem::path& path) { return read(ModelReader(path)); }

}  // namespace ritz::format
