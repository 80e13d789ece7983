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

/// What has the checksums of a body as attributes: the first body's stand where they stood before there were others.
std::string object_of(const std::string& home) { return home.empty() ? group : home; }

}  // namespace

void write_provenance(ModelWriter& out, const model::Provenance& provenance) {
  create_group(out, group);
  write_attribute(out, group, schema::program, std::string_view(provenance.program));
  write_attribute(out, group, schema::ranks, static_cast<Index>(provenance.ranks));
  write_texts(out, schema::join(group, schema::versions), flat(provenance.versions), 2);
  write_texts(out, schema::join(group, schema::options), flat(provenance.options), 2);
}

model::Provenance read_provenance(const ModelReader& in) {
  if (!exists(in, group)) fail(in, group, "is missing");
  return {.program = read_text(in, group, schema::program),
          .versions = paired(read_texts(in, schema::join(group, schema::versions), 2)),
          .options = paired(read_texts(in, schema::join(group, schema::options), 2)),
          .ranks = static_cast<int>(read_index(in, group, schema::ranks))};
}

void write_checksums(ModelWriter& out, const model::Checksums& checksums, std::string_view body) {
  const auto object = object_of(home(out, body));
  create_group(out, object);
  write_attribute(out, object, schema::mesh_checksum, std::string_view(checksums.mesh));
  write_attribute(out, object, schema::problem_checksum, std::string_view(checksums.problem));
}

model::Checksums read_checksums(const ModelReader& in, std::string_view body) {
  const auto object = object_of(home(in, body));
  if (!exists(in, object)) fail(in, object, "is missing");
  return {read_text(in, object, schema::mesh_checksum), read_text(in, object, schema::problem_checksum)};
}

}  // namespace ritz::format
