#include "inspect_check.hpp"

#include <algorithm>
#include <ostream>

#include "inspect_text.hpp"
#include "ritz/format/contents.hpp"
#include "ritz/format/sound.hpp"

namespace ritz::tools {

namespace {

std::string certificate_checked(const model::Certificate& c) {
  if (c.kind == model::Certified::no) return "the number of modes is not certified, so not checked";
  return text("none of the %td modes below the shift is missing", c.counted);
}

}  // namespace

void check(const format::ModelReader& in, std::ostream& out) {
  const auto ok = [&](const std::string& what) { out << "ok  " << what << '\n'; };
  const auto body = format::check(in);
  const auto datasets = format::contents(in);
  ok(text("%td datasets have the checksums they were written with",
          std::ranges::count(datasets, false, &format::DatasetInfo::is_virtual)));
  ok("the parts have shapes that fit together");
  ok("no part is missing");
  ok("all numbers are finite");
  if (const auto& modes = body.modes) {
    ok(text("%td eigenvalues ascend, rigid ones first", modes->eigenvalues.size()));
    ok(certificate_checked(modes->certificate));
  }
  if (body.reduction) ok(text("%td columns of a reduction, softest first", body.reduction->stiffness.size()));
  if (body.polynomial) ok(text("the polynomial's K̃(0) = UᵀKU to %.1e", format::stiffness_error(body)));
  ok(text("UᵀMU = I to %.1e", format::orthonormality_error(*body.inertia)));
}

}  // namespace ritz::tools
