#include "inspect.hpp"

#include <algorithm>
#include <functional>
#include <ostream>

#include "inspect_text.hpp"
#include "ritz/base/printable.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/format/reader.hpp"
#include "ritz/format/sound.hpp"

namespace ritz::tools {

namespace {

std::string certificate_checked(const model::Certificate& c) {
  if (c.kind == model::Certified::no) return "the number of modes is not certified, so not checked";
  return formatted("none of the %td modes below the shift is missing", c.counted);
}

CheckedBody checked(const model::Body& body) {
  CheckedBody figures{
      .name = body.name, .orthonormality = format::orthonormality_error(*body.inertia), .stiffness = {}};
  if (body.polynomial) figures.stiffness = format::stiffness_error(body);
  return figures;
}

void tell_body(const model::Body& body, const CheckedBody& figures, const std::function<void(const std::string&)>& ok) {
  if (const auto& modes = body.modes) {
    ok(formatted("%td eigenvalues ascend, rigid ones first", modes->eigenvalues.size()));
    ok(certificate_checked(modes->certificate));
  }
  if (body.reduction) ok(formatted("%td columns of a reduction, softest first", body.reduction->stiffness.size()));
  if (figures.stiffness) ok(formatted("the polynomial's K̃(0) = UᵀKU to %.1e", *figures.stiffness));
  ok(formatted("UᵀMU = I to %.1e", figures.orthonormality));
}

}  // namespace

std::vector<CheckedBody> check(const format::ModelReader& in, std::ostream& out) {
  const auto ok = [&](const std::string& what) { out << "ok  " << what << '\n'; };
  const auto bodies = format::check(in);
  const auto datasets = format::contents(in);
  ok(formatted("%td datasets have the checksums they were written with",
               std::ranges::count(datasets, false, &format::DatasetInfo::is_virtual)));
  ok("the parts have shapes that fit together");
  ok("no part is missing");
  ok("all numbers are finite");
  std::vector<CheckedBody> all;
  for (const auto& body : bodies) {
    all.push_back(checked(body));
    const auto whose = bodies.size() == 1 ? std::string() : "body '" + printable(body.name) + "': ";
    tell_body(body, all.back(), [&](const std::string& what) { ok(whose + what); });
  }
  return all;
}

}  // namespace ritz::tools
