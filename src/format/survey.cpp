#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "raw_header.hpp"
#include "read.hpp"

namespace ritz::format {

namespace {

using Kind = StoredObject::Kind;

/// The numbers' bytes; at most 2^64 - 1.
std::uint64_t logical_bytes(const RawHeader& header) {
  auto bytes = header.value_bytes;
  for (const auto length : header.shape)
    if (__builtin_mul_overflow(bytes, static_cast<std::uint64_t>(length), &bytes))
      return std::ranges::find(header.shape, 0) != header.shape.end() ? 0 : std::numeric_limits<std::uint64_t>::max();
  return bytes;
}

void check_own(const StoredFile& in, const std::string& path, const RawHeader& header, std::uint64_t file_size) {
  if (header.shape.empty()) fail(in, path, "is a single value where a list is expected");
  const auto known = {ValueClass::integer, ValueClass::real, ValueClass::text};
  if (std::ranges::find(known, static_cast<ValueClass>(header.value_class)) == known.end())
    fail(in, path, "has values that are neither numbers nor fixed-length texts");
  if (header.layout == Layout::view) return;
  if (!header.filters.empty() || header.layout != Layout::contiguous)
    fail(in, path, "is compressed or stored in pieces, which " + in.wording().writer + " never does");
  const auto size = file_size, bytes = logical_bytes(header);
  if (bytes == 0) return;
  if (bytes > size) fail(in, path, "claims to be larger than the file");
  if (header.bytes != bytes || header.address > size || bytes > size - header.address)
    fail(in, path, "has numbers that are not in the file");
}

void check_foreign(const StoredFile& in, const std::string& path, const RawHeader& header, std::uint64_t file_size) {
  if (static_cast<ValueClass>(header.value_class) != ValueClass::real)
    fail(in, path, "must hold floating point numbers");
  if (header.layout == Layout::view) fail(in, path, "is a view of other datasets; give the file that has the numbers");
  constexpr std::array<std::uint16_t, 3> known = {1, 2, 3};  // deflate, shuffle, Fletcher's checksum
  for (const auto filter : header.filters)
    if (std::ranges::find(known, filter) == known.end())
      fail(in, path,
           "is packed by HDF5's filter " + std::to_string(filter) +
               ", which is not one of gzip, shuffle and fletcher32");
  constexpr std::uint64_t gzip_at_best = 1032;
  const auto size = file_size;
  const auto most = header.filters.empty() ? size : size * gzip_at_best;
  if (logical_bytes(header) > most) fail(in, path, "claims to be larger than the file");
}

void check_storage(const StoredFile& in, const std::string& path, const RawHeader& header, Storage storage,
                   std::uint64_t file_size) {
  if (header.external) fail(in, path, "keeps its numbers in other files");
  if (storage == Storage::own) check_own(in, path, header, file_size);
  else check_foreign(in, path, header, file_size);
}

H5O_info_t info_of(const StoredFile& in, const std::string& path) {
  const Quiet quiet;
  H5O_info_t info{};
  if (H5Oget_info_by_name2(in.file(), path.c_str(), &info, H5O_INFO_BASIC, H5P_DEFAULT) < 0)
    fail(in, path, "cannot be looked up: the file is damaged");
  return info;
}

RawHeader checked_header(const StoredFile& in, const RawFile& raw, const std::string& path, haddr_t address,
                         Storage storage) try {
  auto header = raw_header(raw, address);
  check_storage(in, path, header, storage, raw.size());
  return header;
} catch (const BadHeader& error) {
  fail(in, path, error.what());
}

class Survey {
 public:
  Survey(const StoredFile& in, Storage storage) : in_(in), raw_(in.file()), storage_(storage) {
    seen_.insert(info_of(in, "/").addr);
  }

  void visit(const std::string& path, int depth) {
    const auto info = info_of(in_, path);
    const bool first = seen_.insert(info.addr).second;
    if (info.type == H5O_TYPE_GROUP) {
      constexpr int deepest = 16;
      if (!first || depth == deepest) fail(in_, path, "is a group within itself, or another name of one");
      objects_.push_back({path, Kind::group, {}});
      for (const auto& link : links(in_, path)) visit(schema::join(path, link), depth + 1);
    } else if (info.type != H5O_TYPE_DATASET) {
      fail(in_, path, "is neither a group nor a dataset");
    } else if (first) {
      const auto header = checked_header(in_, raw_, path, info.addr, storage_);
      if (header.layout == Layout::view && !sound_mapping(raw_, header.address, header.heap_object))
        fail(in_, path, "is a damaged view");
      objects_.push_back({path, header.layout == Layout::view ? Kind::view : Kind::dataset, header.shape});
    }
  }

  std::vector<StoredObject> objects() && { return std::move(objects_); }

 private:
  const StoredFile& in_;
  RawFile raw_;
  Storage storage_;
  std::set<haddr_t> seen_;
  std::vector<StoredObject> objects_;
};

}  // namespace

Shape stored_shape(const StoredFile& in, const std::string& path) {
  if (!exists(in, path)) fail(in, path, "is missing");
  const auto info = info_of(in, path);
  if (info.type != H5O_TYPE_DATASET) fail(in, path, "is not a readable dataset");
  auto header = checked_header(in, RawFile(in.file()), path, info.addr, Storage::own);
  if (header.layout == Layout::view) fail(in, path, "is a view of other datasets where numbers are expected");
  return std::move(header.shape);
}

std::vector<StoredObject> survey(const StoredFile& in, std::span<const std::string_view> roots, Storage storage) {
  Survey survey(in, storage);
  for (const auto root : roots) {
    const std::string path(root);
    if (!exists(in, path)) continue;
    const Quiet quiet;
    H5L_info_t link{};
    if (H5Lget_info(in.file(), path.c_str(), &link, H5P_DEFAULT) < 0 || link.type != H5L_TYPE_HARD)
      fail(in, path, "is a link to elsewhere");
    survey.visit(path, 0);
  }
  return std::move(survey).objects();
}

}  // namespace ritz::format
