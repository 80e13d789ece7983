#include "inspect_check.hpp"

#include <algorithm>
#include <functional>
#include <ostream>

#include "inspect_text.hpp"
#include "ritz/base/printable.hpp"
#include "ritz/format/contents.hpp"
#include "ritz/format/sound.hpp"

namespace ritz::tools {

namespace {

std::string certificate_checked(const model::Certificate& c) {
  if (c.kind == model::Certified::no) return "the number of modes is not certified, so not checked";
  return text("none of the %td modes below the shift is missing", c.counted);
}

void tell_body(const model::Body& body, const std::function<void(const std::string&)>& ok) {
  if (const auto& modes = body.modes) {
    ok(text("%td eigenvalues ascend, rigid ones first", modes->eigenvalues.size()));
    ok(certificate_checked(modes->certificate));
  }
  if (body.reduction) ok(text("%td columns of a reduction, softest first", body.reduction->stiffness.size()));
  if (body.polynomial) ok(text("the polynomial's K̃(0) = UᵀKU to %.1e", format::stiffness_error(body)));
  ok(text("UᵀMU = I to %.1e", format::orthonormality_error(*body.inertia)));
}

}  // namespace

void check(const format::ModelReader& in, std::ostream& out) {
  const auto ok = [&](const std::string& what) { out << "ok  " << what << '\n'; };
  const auto bodies = format::check(in);
  const auto datasets = format::contents(in);
  ok(text("%td datasets have the checksums they were written with",
          std::ranges::count(datasets, false, &format::DatasetInfo::is_virtual)));
  ok("the parts have shapes that fit together");
  ok("no part is missing");
  ok("all numbers are finite");
  for (const auto& body : bodies) {
    const auto whose = bodies.size() == 1 ? std::string() : "body '" + printable(body.name) + "': ";
    tell_body(body, [&](const std::string& what) { ok(whose + what); });
  }
}

}  // namespace ritz::tools
