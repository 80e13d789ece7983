#include "ritz/format/reader.hpp"

#include <algorithm>

#include "read.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/nearest.hpp"

namespace ritz::format {
namespace {

Wording as_model() { return {.kind = "model", .writer = "ritz-reduce"}; }

}  // namespace

ModelReader::ModelReader(const std::filesystem::path& path) : StoredFile(path, path.string(), as_model()) {
  const Quiet quiet;
  check_root();
}

ModelReader::ModelReader(std::span<const std::byte> image, std::string name)
    : StoredFile(image, std::move(name), as_model()) {
  const Quiet quiet;
  check_root();
}

void ModelReader::check_root() {
  const bool named = H5Aexists(file(), schema::format) > 0 && H5Aexists(file(), schema::version) > 0;
  if (!named || read_text(*this, "/", schema::format) != schema::format_name)
    throw InputError(name() + " is an HDF5 file but not a ritz model; give the file that ritz-reduce wrote");
  const auto version = read_indices(*this, "/", schema::version);
  if (version.size() != 2 || version[0] < 1 || version[1] < 0) fail(*this, "/", "has no sensible format version");
  version_ = {version[0], version[1]};
  if (version[0] <= schema::newest_major) {
    survey(*this, schema::roots);
    return;
  }
  std::string writer = "newer ritz";
  if (H5Aexists_by_name(file(), schema::provenance.data(), schema::program, H5P_DEFAULT) > 0)
    writer = "ritz of " + read_text(*this, std::string(schema::provenance), schema::program);
  throw InputError(name() + " has the model format " + std::to_string(version[0]) + "." + std::to_string(version[1]) +
                   ", this program reads " + std::to_string(schema::newest_major) + ".x and older ones; use the " +
                   writer + " that wrote it, or a later one");
}

std::vector<std::string> ModelReader::bodies() const {
  auto names = links(*this, std::string(schema::bodies));
  std::ranges::transform(names, names.begin(), schema::name_of_link);
  return names;
}

std::string ModelReader::first_body() const {
  const auto names = bodies();
  if (names.empty()) fail(*this, std::string(schema::bodies), "is missing or empty");
  return names.front();
}

void ModelReader::require_body(std::string_view name) const {
  const auto names = bodies();
  if (std::ranges::find(names, name) != names.end()) return;
  if (names.empty()) fail(*this, std::string(schema::bodies), "is missing or empty");
  throw InputError(this->name() + " has no body '" + std::string(name) + "'" + hint(name, names));
}

bool ModelReader::has(std::string_view part, std::string_view body) const {
  return exists(*this, schema::body_part(body, part));
}

namespace {

DatasetInfo describe(const ModelReader& in, const StoredObject& object) {
  const auto& path = object.path;
  DatasetInfo info{.path = path, .shape = object.shape, .units = read_text(in, path, schema::units)};
  info.is_virtual = object.kind == StoredObject::Kind::view;
  if (info.is_virtual) return info;
  const StoredArray array(in, path);
  info.bytes = static_cast<std::uint64_t>(array.rows()) * array.row_bytes();
  return info;
}

}  // namespace

std::vector<DatasetInfo> contents(const ModelReader& in) {
  std::vector<DatasetInfo> infos;
  for (const auto& object : survey(in, schema::roots))
    if (object.kind != StoredObject::Kind::group) infos.push_back(describe(in, object));
  return infos;
}

void verify(const ModelReader& in, const DatasetInfo& dataset) {
  if (dataset.is_virtual) return;
  const StoredArray array(in, dataset.path);
  array.expect(dataset.shape, array.type());
  std::vector<std::byte> bytes(dataset.bytes);
  array.read(0, array.rows(), bytes.data());
}

}  // namespace ritz::format
