#include <algorithm>
#include <functional>

#include "read.hpp"
#include "ritz/format/parts.hpp"
#include "write.hpp"

namespace ritz::format {

void write_reduction(ModelWriter& out, const model::Reduction& reduction, std::string_view body) {
  const auto group = schema::body_part(body, schema::reduction);
  create_group(out, group);
  write_vector<double>(out, schema::join(group, schema::stiffness), "rad^2/s^2", view(reduction.stiffness));
  write_vector<double>(out, schema::join(group, schema::singular_values), "mixed, as Eq. 18",
                       view(reduction.singular_values));
  write_attribute(out, group, schema::discarded, reduction.discarded);
  if (reduction.residual_vectors > 0) write_attribute(out, group, schema::residual_vectors, reduction.residual_vectors);
}

std::optional<model::Reduction> read_reduction(const ModelReader& in, std::string_view body) {
  const auto group = schema::body_part(body, schema::reduction);
  if (!exists(in, group)) return {};
  model::Reduction reduction;
  reduction.stiffness = read_column(in, schema::join(group, schema::stiffness));
  reduction.singular_values = read_column(in, schema::join(group, schema::singular_values));
  reduction.discarded = read_double(in, group, schema::discarded);
  if (has_attribute(in, group, schema::residual_vectors))
    reduction.residual_vectors = read_index(in, group, schema::residual_vectors);
  require(reduction.residual_vectors >= 0 && reduction.residual_vectors <= reduction.stiffness.size(), in, group,
          "the number of residual vectors is none of its columns");
  const double rounding = reduction.stiffness.size() > 0 ? 1e-6 * reduction.stiffness.cwiseAbs().maxCoeff() : 0;
  require((reduction.stiffness.array() >= -rounding).all(), in, group, "the diagonal of UᵀKU is negative");
  require(std::ranges::is_sorted(reduction.stiffness), in, group, "the diagonal of UᵀKU does not ascend");
  require(std::ranges::is_sorted(reduction.singular_values, std::ranges::greater{}), in, group,
          "the singular values do not descend");
  return reduction;
}

}  // namespace ritz::format
