#include "raw_header.hpp"

#include <cstring>

// After the HDF5 file format specification, version 3.0, part IV.A.

namespace ritz::format {

namespace {

enum Message : std::uint8_t {
  dataspace = 1,
  datatype = 3,
  link = 6,
  external_files = 7,
  data_layout = 8,
  filters = 11,
  continuation = 16
};

/// A run of messages.
struct MessageBlock {
  std::uint64_t at, bytes;
};

/// The two kinds of header that there are, and what stands before each message's contents.
struct Form {
  bool checked = false;  ///< of version 2, with signatures and checksums
  std::size_t head = 8;  ///< bytes
};

struct Start {
  Form form;
  MessageBlock first;
};

Start read_start(const RawFile& file, std::uint64_t address) {
  constexpr std::size_t bytes = 16;
  const auto start = file.bytes(address, bytes);
  if (start[0] == 1) return {{}, {address + bytes, Cursor(std::span(start).subspan(8)).number(4)}};
  if (std::memcmp(start.data(), "OHDR\2", 5) != 0) bad_header();
  const unsigned flags = start[5];
  const std::uint64_t width = 1ULL << (flags & 0x03);
  const std::uint64_t before = 6 + ((flags & 0x20) != 0 ? 16 : 0) + ((flags & 0x10) != 0 ? 4 : 0);
  const auto size = file.bytes(address + before, width);
  const bool numbered = (flags & 0x04) != 0;
  return {{true, numbered ? std::size_t{6} : std::size_t{4}}, {address + before + width, Cursor(size).number(width)}};
}

MessageBlock read_continuation(Cursor contents, const Form& form) {
  const auto at = contents.number(8), bytes = contents.number(8);
  constexpr std::uint64_t signature = 4, checksum = 4;
  if (!form.checked) return {at, bytes};
  if (bytes < signature + checksum) bad_header();
  return {at + signature, bytes - signature - checksum};
}

/// Hands each message to `use(type, flags, contents)`, block after block.
template <class Use>
void each_message(const RawFile& file, std::uint64_t address, Use use) {
  const auto [form, first] = read_start(file, address);
  std::vector<MessageBlock> blocks = {first};
  constexpr std::size_t most = 256;  // a cycle of blocks ends here
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (b == most) bad_header();
    const auto bytes = file.bytes(blocks[b].at, blocks[b].bytes);
    for (Cursor in(bytes); in.size() >= form.head;) {
      const auto type = static_cast<unsigned>(in.number(form.checked ? 1 : 2));
      const auto size = static_cast<std::size_t>(in.number(2));
      const auto flags = static_cast<unsigned>(in.number(1));
      in.take(form.head - (form.checked ? 4 : 5));
      const auto contents = in.take(size);
      if (type == continuation) blocks.push_back(read_continuation(Cursor(contents), form));
      else use(type, flags, contents);
    }
  }
}

Shape read_shape(Cursor in) {
  const auto version = in.number(1), rank = in.number(1);
  if ((version != 1 && version != 2) || rank > 32) bad_header();
  in.take(version == 1 ? 6 : 2);
  Shape shape;
  for (std::uint64_t d = 0; d < rank; ++d) {
    const auto length = in.number(8);
    if (length >> 62 != 0) throw BadHeader("claims to be larger than any file");
    shape.push_back(static_cast<std::int64_t>(length));
  }
  return shape;
}

void read_type(Cursor in, RawHeader& header) {
  header.value_class = static_cast<std::uint8_t>(in.number(1) & 0x0f);
  in.take(3);
  header.value_bytes = in.number(4);
}

void read_layout(Cursor in, RawHeader& header) {
  const auto version = in.number(1), layout = in.number(1);
  if (version < 3 || version > 4 || layout > 3) throw BadHeader("is stored in a way of long ago");
  header.layout = static_cast<Layout>(layout);
  if (header.layout == Layout::compact || header.layout == Layout::chunked) return;
  header.address = in.number(8);
  if (header.layout == Layout::contiguous) header.bytes = in.number(8);
  else header.heap_object = static_cast<std::uint32_t>(in.number(4));
}

void read_filters(Cursor in, RawHeader& header) {
  const auto version = in.number(1), count = in.number(1);
  if (version != 1 && version != 2) bad_header();
  if (version == 1) in.take(6);
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto id = static_cast<std::uint16_t>(in.number(2));
    constexpr std::uint16_t first_foreign = 256;  // those below have no name in version 2
    const auto name = version == 1 || id >= first_foreign ? in.number(2) : 0;
    in.take(2);
    const auto values = in.number(2);
    in.take(version == 1 ? (name + 7) / 8 * 8 : name);
    in.take(4 * (values + (version == 1 ? values % 2 : 0)));
    header.filters.push_back(id);
  }
}

void check_link(Cursor in) {
  const auto version = in.number(1), flags = in.number(1);
  constexpr unsigned known = 0x1f, width = 0x03, numbered = 0x04, typed = 0x08, has_encoding = 0x10;
  constexpr std::uint64_t hard = 0, soft = 1, first_foreign = 64;
  if (version != 1 || (flags & ~known) != 0) bad_header();
  const auto type = (flags & typed) != 0 ? in.number(1) : hard;
  if (type > soft && type < first_foreign) bad_header();
  if ((flags & numbered) != 0) in.take(8);
  if ((flags & has_encoding) != 0 && in.number(1) > 1) bad_header();
  const auto name = in.number(1ULL << (flags & width));
  if (name == 0) bad_header();
  in.take(name);
  if (type == hard) in.take(8);
  else if (const auto bytes = in.number(2); bytes > 0) in.take(bytes);
  else if (type == soft) bad_header();
}

}  // namespace

RawHeader raw_header(const RawFile& file, std::uint64_t address) {
  RawHeader header;
  int shapes = 0, types = 0, layouts = 0;
  each_message(file, address, [&](unsigned type, unsigned flags, std::span<const unsigned char> contents) {
    constexpr unsigned shared = 0x02;  // the message stands elsewhere
    const bool used = type == dataspace || type == datatype || type == data_layout || type == filters;
    if (used && (flags & shared) != 0) throw BadHeader("has a type that is kept elsewhere in the file");
    if (type == dataspace) header.shape = read_shape(Cursor(contents)), ++shapes;
    if (type == datatype) read_type(Cursor(contents), header), ++types;
    if (type == data_layout) read_layout(Cursor(contents), header), ++layouts;
    if (type == filters) read_filters(Cursor(contents), header);
    if (type == external_files) header.external = true;
  });
  if (shapes != 1 || types != 1 || layouts != 1) bad_header();
  return header;
}

void check_links(const RawFile& file, std::uint64_t address) {
  each_message(file, address, [](unsigned type, unsigned flags, std::span<const unsigned char> contents) {
    constexpr unsigned shared = 0x02;
    if (type != link) return;
    if ((flags & shared) != 0) bad_header();
    check_link(Cursor(contents));
  });
}

}  // namespace ritz::format
