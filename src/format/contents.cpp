#include "ritz/format/contents.hpp"

#include <set>

#include "read.hpp"

namespace ritz::format {

namespace {

struct Visit {
  std::string root;
  std::set<haddr_t>* seen;
  std::vector<std::string>* paths;
};

herr_t visit(hid_t, const char* name, const H5O_info_t* info, void* data) {
  const auto& v = *static_cast<Visit*>(data);
  if (info->type == H5O_TYPE_DATASET && v.seen->insert(info->addr).second)
    v.paths->push_back(schema::join(v.root, name));
  return 0;
}

DatasetInfo describe(const ModelReader& in, const std::string& path) {
  const StoredArray array(in, path);
  DatasetInfo info{.path = path, .shape = array.shape(), .units = read_text(in, path, schema::units)};
  const Properties creation(H5Dget_create_plist(array.dataset()));
  info.is_virtual = H5Pget_layout(creation.get()) == H5D_VIRTUAL;
  if (!info.is_virtual) info.bytes = static_cast<std::uint64_t>(array.rows()) * array.row_bytes();
  return info;
}

}  // namespace

std::vector<DatasetInfo> contents(const ModelReader& in) {
  const Quiet quiet;
  std::set<haddr_t> seen;
  std::vector<std::string> paths;
  for (const auto root : {schema::bodies, schema::provenance, schema::report, schema::vtkhdf}) {
    Visit into{std::string(root), &seen, &paths};
    if (exists(in, into.root) && H5Ovisit_by_name2(in.file(), root.data(), H5_INDEX_CRT_ORDER, H5_ITER_INC, visit,
                                                   &into, H5O_INFO_BASIC, H5P_DEFAULT) < 0)
      fail(in, into.root, "is not a readable group");
  }
  std::vector<DatasetInfo> infos;
  for (const auto& path : paths) infos.push_back(describe(in, path));
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
