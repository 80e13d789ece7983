#include "read.hpp"
#include "ritz/format/parts.hpp"
#include "write.hpp"

namespace ritz::format {

namespace {

using Pairs = std::vector<std::pair<std::string, std::string>>;

std::vector<std::string> flat(const Pairs& pairs) {
  std::vector<std::string> texts;
  for (const auto& [name, value] : pairs) texts.insert(texts.end(), {name, value});
  return texts;
}

Pairs paired(const std::vector<std::string>& texts) {
  Pairs pairs;
  for (std::size_t i = 0; i + 1 < texts.size(); i += 2) pairs.emplace_back(texts[i], texts[i + 1]);
  return pairs;
}

const std::string group(schema::provenance);

}  // namespace

void write_provenance(ModelWriter& out, const model::Provenance& provenance) {
  create_group(out, group);
  write_attribute(out, group, schema::program, std::string_view(provenance.program));
  write_attribute(out, group, schema::mesh_checksum, std::string_view(provenance.mesh_checksum));
  write_attribute(out, group, schema::problem_checksum, std::string_view(provenance.problem_checksum));
  write_attribute(out, group, schema::ranks, static_cast<Index>(provenance.ranks));
  write_texts(out, schema::join(group, schema::versions), flat(provenance.versions), 2);
  write_texts(out, schema::join(group, schema::options), flat(provenance.options), 2);
}

model::Provenance read_provenance(const ModelReader& in) {
  if (!exists(in, group)) fail(in, group, "is missing");
  return {.program = read_text(in, group, schema::program),
          .versions = paired(read_texts(in, schema::join(group, schema::versions), 2)),
          .options = paired(read_texts(in, schema::join(group, schema::options), 2)),
          .mesh_checksum = read_text(in, group, schema::mesh_checksum),
          .problem_checksum = read_text(in, group, schema::problem_checksum),
          .ranks = static_cast<int>(read_index(in, group, schema::ranks))};
}

}  // namespace ritz::format
