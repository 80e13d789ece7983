#include "read.hpp"
#include "ritz/format/parts.hpp"
#include "write.hpp"

namespace ritz::format {

namespace {

std::string below(const std::string& home) { return home + std::string(schema::report); }

/// A list of names beside a list of numbers; nothing when there are none.
void write_table(const ModelWriter& out, const std::string& group, const char* names_path, const char* values_path,
                 std::string_view units, const std::vector<std::string>& names, const std::vector<double>& values) {
  if (names.empty()) return;
  write_texts(out, schema::join(group, names_path), names);
  write_vector<double>(out, schema::join(group, values_path), units, values);
}

std::vector<double> read_values(const ModelReader& in, const std::string& path, const std::vector<std::string>& names) {
  if (names.empty()) return {};
  return read_vector<double>(in, path, static_cast<Index>(names.size()));
}

}  // namespace

void write_report(ModelWriter& out, const model::Report& report, std::string_view body) {
  const auto group = below(home(out, body));
  create_group(out, group);
  std::vector<std::string> stages, names;
  std::vector<double> seconds, values;
  for (const auto& time : report.seconds) {
    stages.push_back(time.stage);
    seconds.push_back(time.seconds);
  }
  for (const auto& [name, value] : report.figures) {
    names.push_back(name);
    values.push_back(value);
  }
  write_table(out, group, schema::stages, schema::seconds, "s", stages, seconds);
  write_table(out, group, schema::figure_names, schema::figure_values, "as the figure's name says", names, values);
  write_texts(out, schema::join(group, schema::notes), report.notes);
  if (report.mesh_errors.size() > 0)
    write_vector<double>(out, schema::join(group, schema::mesh_errors), "1", view(report.mesh_errors));
}

model::Report read_report(const ModelReader& in, std::string_view body) {
  const auto group = below(home(in, body));
  model::Report report;
  const auto stages = read_texts(in, schema::join(group, schema::stages));
  const auto seconds = read_values(in, schema::join(group, schema::seconds), stages);
  for (std::size_t i = 0; i < stages.size(); ++i) report.seconds.push_back({stages[i], seconds[i]});
  const auto names = read_texts(in, schema::join(group, schema::figure_names));
  const auto values = read_values(in, schema::join(group, schema::figure_values), names);
  for (std::size_t i = 0; i < names.size(); ++i) report.figures.emplace_back(names[i], values[i]);
  report.notes = read_texts(in, schema::join(group, schema::notes));
  const auto mesh_errors = schema::join(group, schema::mesh_errors);
  if (!exists(in, mesh_errors)) return report;
  require(in.has(schema::modes, body), in, mesh_errors, "is of modes, and there are none");
  report.mesh_errors =
      read_column(in, mesh_errors,
                  stored_shape(in, schema::join(schema::body_part(body, schema::modes), schema::eigenvalues)).front());
  require((report.mesh_errors.array() > -1).all(), in, mesh_errors, "has an error that leaves no frequency");
  return report;
}

}  // namespace ritz::format
