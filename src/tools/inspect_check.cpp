#include "inspect_check.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "inspect_text.hpp"
#include "ritz/base/error.hpp"
#include "ritz/format/contents.hpp"
#include "ritz/format/parts.hpp"

namespace ritz::tools {

namespace {

constexpr double orthonormality_gate = 1e-12, stiffness_gate = 1e-9;

void require(bool holds, const format::ModelReader& in, const std::string& what) {
  if (!holds) throw InputError(in.name() + ": " + what + "; do not use this model, write it again with ritz-reduce");
}

/// Every model has these parts, a mode (or an entry of the reduction) for each column of U, and a load for each set of
/// which it stores vertices.
std::string check_parts(const format::ModelReader& in, const model::Body& body) {
  require(!body.geometry.materials.empty(), in, "the materials are missing");
  require(body.inertia.has_value(), in, "the inertia is missing");
  require(body.modes || body.reduction, in, "the modes are missing");
  const auto columns = body.reduction ? body.reduction->stiffness.size() : body.modes->eigenvalues.size();
  require(columns == body.basis.U.cols(), in,
          text("there are %td modes for %td columns of U", columns, body.basis.U.cols()));
  for (const auto& set : body.geometry.sets)
    require(set.rows.empty() || std::ranges::find(body.loads, set.name, &model::SetLoad::set) != body.loads.end(), in,
            "the load on the set '" + set.name + "' is missing");
  for (const auto& load : body.loads)
    require(std::ranges::find(body.geometry.sets, load.set, &model::VertexSet::name) != body.geometry.sets.end(), in,
            "the set '" + load.set + "' is missing, on which there is a load");
  return "no part is missing";
}

std::string check_numbers(const format::ModelReader& in, const model::Body& body) {
  require(body.geometry.points.allFinite(), in, "a coordinate is not a finite number");
  require(body.basis.U.allFinite(), in, "an entry of U is not a finite number");
  for (const auto& load : body.loads)
    require(load.total.allFinite() && load.traction.allFinite() && load.pressure.allFinite(), in,
            "the load on the set '" + load.set + "' is not a finite number");
  return "all numbers are finite";
}

std::string check_modes(const format::ModelReader& in, const model::Modes& modes) {
  const auto& values = modes.eigenvalues;
  require(values.allFinite() && modes.residuals.allFinite(), in, "an eigenvalue or residual is not a finite number");
  require(std::ranges::is_sorted(values), in, "the eigenvalues do not ascend");
  require(std::ranges::is_sorted(modes.kinds), in, "a rigid mode stands after a flexible one");
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const bool rigid = modes.kinds[static_cast<std::size_t>(i)] == model::ModeKind::rigid;
    require(rigid ? values[i] == 0 : values[i] > 0, in,
            text("mode %td is %s with the eigenvalue %g", i + 1, rigid ? "rigid" : "flexible", values[i]));
  }
  return text("%td eigenvalues ascend, rigid ones first", values.size());
}

std::string check_certificate(const format::ModelReader& in, const model::Certificate& c) {
  if (c.kind == model::Certified::no) return "the number of modes is not certified, so not checked";
  require(c.counted == c.found, in,
          text("%td eigenvalues lie below the shift, but %td were found", c.counted, c.found));
  return text("none of the %td modes below the shift is missing", c.counted);
}

std::string check_inertia(const format::ModelReader& in, const model::Inertia& inertia) {
  const auto& G = inertia.gram;
  require(G.allFinite() && inertia.mass() > 0, in, "the mass is not a positive number");
  require(G.isApprox(G.transpose(), 1e-12), in, "the Gram matrix of the inertia is not symmetric");
  const auto r = (G.rows() - 4) / 3;
  Eigen::MatrixXd error = -Eigen::MatrixXd::Identity(r, r);  // UᵀMU - I, M being M_s on each component
  for (Eigen::Index a = 0; a < 3; ++a) error += G.block(4 + a * r, 4 + a * r, r, r);
  const double size = r > 0 ? error.cwiseAbs().maxCoeff() : 0;
  require(size <= orthonormality_gate, in, text("UᵀMU differs from I by %.1e, more than 1e-12", size));
  return text("UᵀMU = I to %.1e", size);
}

std::string check_reduction(const format::ModelReader& in, const model::Reduction& reduction) {
  require(
      reduction.stiffness.allFinite() && reduction.singular_values.allFinite() && std::isfinite(reduction.discarded),
      in, "a number of the reduction is not finite");
  require(std::ranges::is_sorted(reduction.stiffness), in, "the diagonal of UᵀKU does not ascend");
  require(std::ranges::is_sorted(reduction.singular_values, std::ranges::greater{}), in,
          "the singular values do not descend");
  return text("%td columns of a reduction, softest first", reduction.stiffness.size());
}

std::string check_polynomial(const format::ModelReader& in, const model::Body& body) {
  const auto& p = *body.polynomial;
  require(p.quadratic.allFinite() && p.cubic.allFinite() && p.quartic.allFinite(), in,
          "a coefficient of the polynomial is not a finite number");
  const Eigen::VectorXd& stiffness = body.reduction ? body.reduction->stiffness : body.modes->eigenvalues;
  double error = 0;
  for (Eigen::Index i = 0, at = 0; i < p.r; ++i)
    for (Eigen::Index j = i; j < p.r; ++j, ++at)
      error = std::max(error, std::abs(p.quadratic[at] - (i == j ? stiffness[i] : 0)));
  error /= stiffness.cwiseAbs().maxCoeff();
  require(error <= stiffness_gate, in,
          text("the polynomial's K̃(0) differs from UᵀKU by %.1e of its largest entry, more than 1e-9", error));
  return text("the polynomial's K̃(0) = UᵀKU to %.1e", error);
}

}  // namespace

void check(const format::ModelReader& in, std::ostream& out) {
  const auto ok = [&](const std::string& what) { out << "ok  " << what << '\n'; };
  std::size_t verified = 0;
  for (const auto& dataset : format::contents(in)) {
    format::verify(in, dataset);
    verified += dataset.is_virtual ? 0 : 1;
  }
  ok(text("%zu datasets have the checksums they were written with", verified));
  const auto model = format::read(in);
  ok("the parts have shapes that fit together");
  ok(check_parts(in, model.body));
  ok(check_numbers(in, model.body));
  if (const auto& modes = model.body.modes) {
    ok(check_modes(in, *modes));
    ok(check_certificate(in, modes->certificate));
  }
  if (model.body.reduction) ok(check_reduction(in, *model.body.reduction));
  if (model.body.polynomial) ok(check_polynomial(in, model.body));
  ok(check_inertia(in, *model.body.inertia));
}

}  // namespace ritz::tools
