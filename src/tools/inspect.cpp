#include "inspect.hpp"

#include <algorithm>
#include <array>
#include <ostream>
#include <string_view>

#include "inspect_text.hpp"
#include "ritz/base/printable.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/format/parts.hpp"

namespace ritz::tools {

namespace {

using Pairs = std::vector<std::pair<std::string, std::string>>;

void describe_pairs(const char* title, const Pairs& pairs, std::ostream& out) {
  if (pairs.empty()) return;
  out << "  " << title << '\n';
  for (const auto& [name, value] : pairs)
    out << "    " << padded(printable(name), 36) << ' ' << printable(value) << '\n';
}

/// " of 'NAME'" where there are several bodies.
std::string of_body(const format::ModelReader& in, const std::string& name) {
  return in.bodies().size() == 1 ? "" : " of '" + printable(name) + "'";
}

void describe_provenance(const format::ModelReader& in, Voice voice, std::ostream& out) {
  const auto p = format::read_provenance(in);
  out << "\nprovenance\n";
  out << "  program   " << printable(p.program) << " on " << p.ranks << (p.ranks == 1 ? " rank\n" : " ranks\n");
  describe_pairs("options", p.options, out);
  if (voice != Voice::verbose) return;
  for (const auto& name : in.bodies()) {
    const auto sums = format::read_checksums(in, name);
    out << "  mesh      " << printable(sums.mesh) << of_body(in, name) << '\n';
    out << "  problem   " << printable(sums.problem) << of_body(in, name) << '\n';
  }
  describe_pairs("versions", p.versions, out);
}

struct Words {
  std::string_view figure, words;
};

/// What figures of a report are in words.
constexpr auto figures_in_words = std::to_array<Words>({
    {"accuracy_error", "error on the static path of -accuracy"},
    {"accuracy_target", "  asked for"},
    {"witness_force", "forces off from the full model's by"},
    {"witness_energy", "energy off from the full model's by"},
    {"witness_stiffness", "stiffness at rest off by"},
});
constexpr std::string_view static_error = "static_error_";

/// "static answer along x on 'lug': missing"; empty for a figure that only a verbose voice tells.
std::string in_words(const std::string& figure) {
  const auto known = std::ranges::find(figures_in_words, figure, &Words::figure);
  if (known != figures_in_words.end()) return std::string(known->words);
  if (!figure.starts_with(static_error) || figure.size() == static_error.size()) return "";
  const auto set = figure.find(' ');
  return std::string("static answer along ") + figure[static_error.size()] +
         (set == figure.npos ? ", gravity" : " on '" + figure.substr(set + 1) + "'") + ": missing";
}

void describe_report(const format::ModelReader& in, const std::string& body, Voice voice, std::ostream& out) {
  const auto report = format::read_report(in, body);
  if (report.seconds.empty() && report.figures.empty() && report.notes.empty()) return;
  out << "\nreport" << of_body(in, body) << '\n';
  for (const auto& [stage, seconds] : report.seconds)
    out << "  " << padded(printable(stage), 38) << ' ' << duration(seconds) << '\n';
  for (const auto& [name, value] : report.figures) {
    if (voice == Voice::verbose) out << "  " << padded(printable(name), 38) << ' ' << formatted("%.10g\n", value);
    else if (const auto words = in_words(name); !words.empty())
      out << "  " << padded(printable(words), 38) << ' ' << formatted("%.2g %%\n", 100 * value);
  }
  for (Eigen::Index i = 0; i < report.mesh_errors.size(); ++i)
    out << "  " << padded("mesh error of mode " + std::to_string(i + 1), 38) << ' '
        << formatted("%+.2g %%\n", 100 * report.mesh_errors[i]);
  for (const auto& note : report.notes) out << "  note: " << printable(note) << '\n';
}

void describe_body(const format::ModelReader& in, const std::string& name, Voice voice, std::ostream& out) {
  out << "\nbody '" << printable(name) << "'\n";
  if (in.has(format::schema::geometry, name)) describe_geometry(format::read_geometry(in, name), out);
  if (in.has(format::schema::basis, name)) describe_basis(format::basis_size(in, name), out);
  if (const auto modes = format::read_modes(in, name)) describe_modes(*modes, voice, out);
  if (const auto reduction = format::read_reduction(in, name)) describe_reduction(*reduction, voice, out);
  if (const auto polynomial = format::read_polynomial(in, name)) describe_polynomial(*polynomial, out);
  if (const auto cubature = format::read_cubature(in, name)) describe_cubature(*cubature, out);
  if (const auto inertia = format::read_inertia(in, name)) describe_inertia(*inertia, voice, out);
  describe_loads(format::read_loads(in, name), out);
}

/// One line for what is printed together: a dataset, or all columns of a basis.
struct Line {
  std::string path, shape, size, units;
};

std::vector<Line> dataset_lines(const std::vector<format::DatasetInfo>& datasets) {
  std::vector<Line> lines;
  const auto is_column = [](const std::string& path) { return path.ends_with("/columns"); };
  for (std::size_t first = 0, last = 0; first < datasets.size(); first = last) {
    const auto& d = datasets[first];
    const auto parent = d.path.substr(0, d.path.rfind('/'));
    std::uint64_t bytes = 0;
    do bytes += datasets[last++].bytes;
    while (is_column(parent) && last < datasets.size() && datasets[last].path.starts_with(parent + "/"));
    const auto range = last - first == 1 ? d.path : d.path + " … " + datasets[last - 1].path.substr(parent.size() + 1);
    lines.push_back(
        {printable(range), shape_text(d.shape), d.is_virtual ? "a view" : byte_size(bytes), printable(d.units)});
  }
  return lines;
}

void describe_datasets(const std::vector<format::DatasetInfo>& datasets, std::ostream& out) {
  out << "\ndatasets\n";
  const auto lines = dataset_lines(datasets);
  std::size_t width = 0;
  for (const auto& line : lines) width = std::max(width, line.path.size());
  for (const auto& line : lines)
    out << "  " << padded(line.path, width) << formatted("  %14s  %10s  ", line.shape.c_str(), line.size.c_str())
        << line.units << '\n';
}

}  // namespace

void describe(const format::ModelReader& in, Voice voice, std::ostream& out) {
  const auto datasets = format::contents(in);
  std::uint64_t bytes = 0;
  for (const auto& d : datasets) bytes += d.bytes;
  out << printable(in.name()) << ": a ritz model, format " << in.version().major << '.' << in.version().minor << ", "
      << datasets.size() << " datasets, " << byte_size(bytes) << " of data\n";
  for (const auto& name : in.bodies()) describe_body(in, name, voice, out);
  describe_provenance(in, voice, out);
  for (const auto& name : in.bodies()) describe_report(in, name, voice, out);
  if (voice == Voice::verbose) describe_datasets(datasets, out);
}

}  // namespace ritz::tools
