#include "read.hpp"
#include "ritz/format/parts.hpp"
#include "write.hpp"

namespace ritz::format {

void write_inertia(ModelWriter& out, const model::Inertia& inertia, std::string_view body) {
  const auto group = schema::body_part(body, schema::inertia);
  create_group(out, group);
  const std::span<const double> origin(inertia.origin.data(), 3);
  write_vector<double>(out, schema::join(group, schema::origin), "m", origin);
  write_matrix(out, schema::join(group, schema::gram), "kg; each factor X brings m, each factor U kg^-1/2",
               inertia.gram);
}

std::optional<model::Inertia> read_inertia(const ModelReader& in, std::string_view body) {
  const auto group = schema::body_part(body, schema::inertia);
  if (!exists(in, group)) return {};
  model::Inertia inertia;
  inertia.origin = read_column(in, schema::join(group, schema::origin), 3);
  const auto path = schema::join(group, schema::gram);
  inertia.gram = read_matrix(in, path, any, any);
  const auto size = inertia.gram.rows();
  if (size != inertia.gram.cols() || size < 4 || (size - 4) % 3 != 0) fail(in, path, "is not of the size 4 + 3r");
  require(inertia.mass() > 0, in, group, "the mass is not a positive number");
  require(inertia.gram.isApprox(inertia.gram.transpose(), 1e-12), in, group,
          "the Gram matrix of the inertia is not symmetric");
  return inertia;
}

}  // namespace ritz::format
