#include "ritz/format/sound.hpp"

#include <algorithm>
#include <cmath>

#include "read.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/format/names.hpp"
#include "ritz/format/reader.hpp"

namespace ritz::format {

namespace {

/// The columns that the modes or, where there is one, the reduction have numbers of; none where both are absent.
std::optional<Index> numbered_columns(const ModelReader& in, std::string_view body) {
  if (in.has(schema::reduction, body))
    return stored_shape(in, schema::join(schema::body_part(body, schema::reduction), schema::stiffness)).front();
  if (in.has(schema::modes, body))
    return stored_shape(in, schema::join(schema::body_part(body, schema::modes), schema::eigenvalues)).front();
  return {};
}

std::string load_of(std::string_view body, const std::string& link) {
  return schema::join(schema::body_part(body, schema::loads), link);
}

void check_targets(const ModelReader& in, std::string_view body) {
  const auto sets = schema::join(schema::body_part(body, schema::geometry), schema::sets);
  for (const auto& link : links(in, sets)) {
    const bool stored = stored_shape(in, schema::join(schema::join(sets, link), schema::set_rows)).front() > 0;
    require(!stored || exists(in, load_of(body, link)), in, sets,
            "the load on the set '" + schema::name_of_link(link) + "' is missing");
  }
  for (const auto& link : links(in, schema::body_part(body, schema::loads)))
    require(exists(in, schema::join(sets, link)), in, sets,
            "the set '" + schema::name_of_link(link) + "' is missing, on which there is a load");
}

const Eigen::VectorXd& stiffness_of(const model::Body& body) {
  return body.reduction ? body.reduction->stiffness : body.modes->eigenvalues;
}

}  // namespace

double orthonormality_error(const model::Inertia& inertia) {
  const auto& G = inertia.gram;
  const auto r = (G.rows() - 4) / 3;
  Eigen::MatrixXd error = -Eigen::MatrixXd::Identity(r, r);  // M is M_s on each component
  for (Eigen::Index a = 0; a < 3; ++a) error += G.block(4 + a * r, 4 + a * r, r, r);
  return r > 0 ? error.cwiseAbs().maxCoeff() : 0;
}

double stiffness_error(const model::Body& body) {
  const auto& p = *body.polynomial;
  const auto& stiffness = stiffness_of(body);
  double error = 0;
  for (Eigen::Index i = 0, at = 0; i < p.r; ++i)
    for (Eigen::Index j = i; j < p.r; ++j, ++at)
      error = std::max(error, std::abs(p.quadratic[at] - (i == j ? stiffness[i] : 0)));
  const double largest = stiffness.cwiseAbs().maxCoeff();
  return largest > 0 ? error / largest : error;
}

void check_shapes(const ModelReader& in, std::string_view body) {
  in.require_body(body);
  const auto r = basis_size(in, body).columns;
  const auto fit = [&](std::string_view part, bool holds) {
    if (!holds) fail(in, schema::body_part(body, part), "does not have the columns of the basis");
  };
  const auto first = [&](std::string_view part, const char* name) {
    return stored_shape(in, schema::join(schema::body_part(body, part), name)).front();
  };
  if (in.has(schema::inertia, body)) fit(schema::inertia, first(schema::inertia, schema::gram) == 4 + 3 * r);
  if (in.has(schema::reduction, body)) fit(schema::reduction, first(schema::reduction, schema::stiffness) == r);
  if (in.has(schema::polynomial, body))
    fit(schema::polynomial, read_index(in, schema::body_part(body, schema::polynomial), schema::column_count) == r);
  if (in.has(schema::cubature, body)) {
    const auto cubature = schema::body_part(body, schema::cubature);
    fit(schema::cubature, stored_shape(in, schema::join(cubature, schema::gradients)).back() == r);
    const bool rest = read_text(in, cubature, schema::integrand) == name(model::Integrand::beyond_polynomial);
    require(rest == in.has(schema::polynomial, body), in, cubature,
            rest ? "the polynomial is missing whose rest it integrates"
                 : "it integrates the whole energy, so that the polynomial beside it is one too many");
  }
  for (const auto& link : links(in, schema::body_part(body, schema::loads)))
    fit(schema::loads, stored_shape(in, schema::join(load_of(body, link), schema::total)).front() == r);
}

void check_complete(const ModelReader& in, std::string_view body) {
  in.require_body(body);
  const auto geometry = schema::body_part(body, schema::geometry);
  require(exists(in, schema::join(geometry, schema::materials)), in, geometry, "the materials are missing");
  require(in.has(schema::inertia, body), in, geometry, "the inertia is missing");
  check_shapes(in, body);
  const auto basis = schema::body_part(body, schema::basis);
  const auto numbered = numbered_columns(in, body);
  require(numbered.has_value(), in, basis, "the modes are missing");
  const auto columns = basis_size(in, body).columns;
  require(columns > 0, in, basis, "there is no column, so nothing can move");
  require(*numbered == columns, in, basis,
          "there are " + std::to_string(*numbered) + " modes for " + std::to_string(columns) + " columns of U");
  check_targets(in, body);
}

void check_witnesses(const ModelReader& in, const model::Body& body) {
  constexpr double orthonormality_gate = 1e-12, stiffness_gate = 1e-9;
  const auto group = [&](std::string_view part) { return schema::body_part(body.name, part); };
  if (body.modes && body.modes->certificate.kind != model::Certified::no) {
    const auto& c = body.modes->certificate;
    require(
        c.counted == c.found, in, group(schema::modes),
        std::to_string(c.counted) + " eigenvalues lie below the shift, but " + std::to_string(c.found) + " were found");
  }
  if (body.inertia) {
    const double error = orthonormality_error(*body.inertia);
    require(error <= orthonormality_gate, in, group(schema::inertia),
            "UᵀMU differs from I by " + shown(error, 3) + ", more than 1e-12");
  }
  if (body.cubature)
    require(std::ranges::all_of(body.cubature->regions,
                                [&](Index region) { return region < std::ssize(body.geometry.materials); }),
            in, group(schema::cubature), "a cell belongs to a region without a material");
  if (body.polynomial) {
    const double error = stiffness_error(body);
    require(error <= stiffness_gate, in, group(schema::polynomial),
            "the polynomial's K̃(0) differs from UᵀKU by " + shown(error, 3) + " of its largest entry, more than 1e-9");
  }
}

namespace {

model::Body checked_body(const ModelReader& in, const std::string& name) {
  model::Body body;
  body.name = name;
  check_complete(in, body.name);
  body.checksums = read_checksums(in, body.name);
  body.geometry = read_geometry(in, body.name);
  for (Index column = 0; column < basis_size(in, body.name).columns; ++column)
    read_basis(in, {.columns = {{column}}, .vertices = {}}, body.name);
  body.modes = read_modes(in, body.name);
  body.reduction = read_reduction(in, body.name);
  body.polynomial = read_polynomial(in, body.name);
  body.cubature = read_cubature(in, body.name);
  body.inertia = read_inertia(in, body.name);
  body.loads = read_loads(in, body.name);
  body.report = read_report(in, body.name);
  check_witnesses(in, body);
  return body;
}

}  // namespace

std::vector<model::Body> check(const ModelReader& in) {
  for (const auto& dataset : contents(in)) verify(in, dataset);
  in.first_body();
  std::vector<model::Body> bodies;
  for (const auto& name : in.bodies()) bodies.push_back(checked_body(in, name));
  read_provenance(in);
  return bodies;
}

}  // namespace ritz::format
