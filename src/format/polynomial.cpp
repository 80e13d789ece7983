#include "read.hpp"
#include "ritz/format/parts.hpp"
#include "write.hpp"

namespace ritz::format {

void write_polynomial(ModelWriter& out, const model::Polynomial& polynomial, std::string_view body) {
  const auto group = schema::body_part(body, schema::polynomial);
  create_group(out, group);
  write_attribute(out, group, schema::column_count, static_cast<std::int64_t>(polynomial.r));
  write_vector<double>(out, schema::join(group, schema::quadratic), "1/s^2", view(polynomial.quadratic));
  write_vector<double>(out, schema::join(group, schema::cubic), "1/(s^2 m kg^1/2)", view(polynomial.cubic));
  write_vector<double>(out, schema::join(group, schema::quartic), "1/(s^2 m^2 kg)", view(polynomial.quartic));
}

std::optional<model::Polynomial> read_polynomial(const ModelReader& in, std::string_view body) {
  const auto group = schema::body_part(body, schema::polynomial);
  if (!exists(in, group)) return {};
  model::Polynomial polynomial;
  const auto r = read_index(in, group, schema::column_count);
  constexpr Index most = 10000;  // keeps the counts below within 64 bits
  if (r < 1 || r > most) fail(in, group, "claims " + std::to_string(r) + " coordinates");
  polynomial.r = r;
  const auto pairs = r * (r + 1) / 2, triples = pairs * (r + 2) / 3;
  polynomial.quadratic = read_column(in, schema::join(group, schema::quadratic), pairs);
  polynomial.cubic = read_column(in, schema::join(group, schema::cubic), triples);
  polynomial.quartic = read_column(in, schema::join(group, schema::quartic), triples * (r + 3) / 4);
  return polynomial;
}

}  // namespace ritz::format
