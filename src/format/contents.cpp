#include "ritz/format/contents.hpp"

#include "read.hpp"

namespace ritz::format {

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
