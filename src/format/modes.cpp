#include <algorithm>

#include "read.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/format/names.hpp"
#include "ritz/format/parts.hpp"
#include "write.hpp"

namespace ritz::format {

namespace {

constexpr auto eigenvalue_units = "rad^2/s^2";

void write_certificate(const ModelWriter& out, const std::string& group, const model::Certificate& certificate) {
  create_group(out, group);
  write_attribute(out, group, schema::certified, name(certificate.kind));
  write_attribute(out, group, schema::shift, certificate.shift);
  write_attribute(out, group, schema::counted, certificate.counted);
  write_attribute(out, group, schema::found, certificate.found);
}

/// Rigid modes first, of λ = 0; then flexible ones, of ascending λ > 0.
void check_order(const ModelReader& in, const std::string& group, const model::Modes& modes) {
  const auto& values = modes.eigenvalues;
  require(std::ranges::is_sorted(values), in, group, "the eigenvalues do not ascend");
  require(std::ranges::is_sorted(modes.kinds), in, group, "a rigid mode stands after a flexible one");
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const auto kind = modes.kinds[static_cast<std::size_t>(i)];
    require(kind == model::ModeKind::rigid ? values[i] == 0 : values[i] > 0, in, group,
            "mode " + std::to_string(i + 1) + " is " + std::string(name(kind)) + " with the eigenvalue " +
                shown(values[i]));
  }
}

model::Certificate read_certificate(const ModelReader& in, const std::string& group) {
  model::Certificate certificate;
  if (!parse(read_text(in, group, schema::certified), certificate.kind)) fail(in, group, "is of an unknown kind");
  certificate.shift = read_double(in, group, schema::shift);
  certificate.counted = read_index(in, group, schema::counted);
  certificate.found = read_index(in, group, schema::found);
  require(certificate.counted >= 0 && certificate.found >= 0, in, group, "a number of modes is negative");
  return certificate;
}

}  // namespace

void write_modes(ModelWriter& out, const model::Modes& modes, std::string_view body) {
  const auto group = schema::body_part(body, schema::modes);
  create_group(out, group);
  write_vector<double>(out, schema::join(group, schema::eigenvalues), eigenvalue_units, view(modes.eigenvalues));
  write_vector<double>(out, schema::join(group, schema::energies), eigenvalue_units, view(modes.energies));
  write_vector<double>(out, schema::join(group, schema::residuals), "1", view(modes.residuals));
  write_vector<std::uint8_t>(out, schema::join(group, schema::floor_applies), "1", modes.floor_applies);
  std::vector<std::string> kinds;
  for (const auto kind : modes.kinds) kinds.emplace_back(name(kind));
  write_texts(out, schema::join(group, schema::kinds), kinds);
  write_attribute(out, group, schema::orthonormality, modes.orthonormality);
  write_certificate(out, schema::join(group, schema::certificate), modes.certificate);
}

std::optional<model::Modes> read_modes(const ModelReader& in, std::string_view body) {
  const auto group = schema::body_part(body, schema::modes);
  if (!exists(in, group)) return {};
  model::Modes modes;
  modes.eigenvalues = read_column(in, schema::join(group, schema::eigenvalues));
  const auto count = modes.eigenvalues.size();
  modes.energies = read_column(in, schema::join(group, schema::energies), count);
  modes.residuals = read_column(in, schema::join(group, schema::residuals), count);
  modes.floor_applies = read_vector<std::uint8_t>(in, schema::join(group, schema::floor_applies), count);
  const auto kinds = schema::join(group, schema::kinds);
  for (const auto& text : read_texts(in, kinds))
    if (!parse(text, modes.kinds.emplace_back())) fail(in, kinds, "has an unknown kind of mode '" + text + "'");
  if (static_cast<Index>(modes.kinds.size()) != count) fail(in, kinds, "does not have one entry a mode");
  check_order(in, group, modes);
  require((modes.residuals.array() >= 0).all(), in, group, "a residual is negative");
  require(std::ranges::all_of(modes.floor_applies, [](auto flag) { return flag <= 1; }), in, group,
          "a flag of the rounding floor is neither 0 nor 1");
  modes.orthonormality = read_double(in, group, schema::orthonormality);
  modes.certificate = read_certificate(in, schema::join(group, schema::certificate));
  return modes;
}

}  // namespace ritz::format
