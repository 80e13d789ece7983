#include "read.hpp"
#include "ritz/format/parts.hpp"
#include "write.hpp"

namespace ritz::format {

void write_loads(ModelWriter& out, const std::vector<model::SetLoad>& loads, std::string_view body) {
  for (const auto& load : loads) {
    const auto group = schema::join(schema::body_part(body, schema::loads), schema::link_name(load.set));
    create_group(out, group);
    write_attribute(out, group, schema::set_vertices, load.vertices);
    write_matrix(out, schema::join(group, schema::total), "kg^-1/2", load.total);
    if (!load.has_surface) continue;
    const std::span<const double> pressure(load.pressure.data(), static_cast<std::size_t>(load.pressure.size()));
    write_attribute(out, group, schema::area, load.area);
    write_vector<double>(out, schema::join(group, schema::pressure), "m^2 kg^-1/2", pressure);
    write_matrix(out, schema::join(group, schema::traction), "m^2 kg^-1/2", load.traction);
  }
}

std::vector<model::SetLoad> read_loads(const ModelReader& in, std::string_view body) {
  std::vector<model::SetLoad> loads;
  const auto parent = schema::body_part(body, schema::loads);
  for (const auto& link : links(in, parent)) {
    const auto group = schema::join(parent, link);
    auto& load = loads.emplace_back();
    load.set = schema::name_of_link(link);
    load.vertices = read_index(in, group, schema::set_vertices);
    if (load.vertices < 1) fail(in, group, "shares a force among no vertices");
    load.total = read_matrix(in, schema::join(group, schema::total), any, 3);
    load.has_surface = exists(in, schema::join(group, schema::pressure));
    if (!load.has_surface) continue;
    load.area = read_double(in, group, schema::area);
    if (load.area < 0) fail(in, group, "has a negative area");
    load.pressure = read_column(in, schema::join(group, schema::pressure), load.total.rows());
    load.traction = read_matrix(in, schema::join(group, schema::traction), load.total.rows(), 3);
  }
  return loads;
}

}  // namespace ritz::format
