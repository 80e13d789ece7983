#include "ritz/readers/vtu_file.hpp"

#include <lz4.h>
#include <lzma.h>
#include <zlib.h>
#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

namespace ritz::readers {

namespace {

// Bytes out of one compressed byte, at most: what a block may claim.
constexpr std::uint64_t most_packed(VtuCompression compression) {
  switch (compression) {
    case VtuCompression::zlib: return 1040;
    case VtuCompression::lz4: return 260;
    case VtuCompression::lzma: return 8000;
    case VtuCompression::none: break;
  }
  return 1;
}

constexpr auto base64_values = [] {
  constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<std::int8_t, 256> values{};
  values.fill(-1);
  for (std::size_t i = 0; i < alphabet.size(); ++i) {
    values[static_cast<unsigned char>(alphabet[i])] = static_cast<std::int8_t>(i);
  }
  return values;
}();

bool is_white(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

/// Hands out bytes in order. Base64 is decoded four characters at a time, so that a padded header may come first.
class ByteStream {
 public:
  ByteStream(const Sources& sources, const VtuText& data) : sources_(sources), data_(data) {
    while (data_.encoding == VtuEncoding::base64 && !data_.text.empty() && is_white(data_.text.front())) {
      data_.text.remove_prefix(1);
    }
  }

  std::string take(std::uint64_t count) {
    if (count > most()) fail("the binary data is cut off");
    if (data_.encoding == VtuEncoding::raw) {
      std::string bytes(data_.text.substr(0, count));
      data_.text.remove_prefix(count);
      return bytes;
    }
    std::string bytes = std::move(left_);
    bytes.reserve(count + 3);
    while (bytes.size() < count) decode_quad(bytes);
    left_ = bytes.substr(count);
    bytes.resize(count);
    return bytes;
  }

  std::uint64_t number(const VtuBlocks& blocks) {
    const auto bytes = take(blocks.header_size);
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      const std::size_t at = blocks.order == VtuOrder::big ? i : bytes.size() - 1 - i;
      value = value << 8 | static_cast<unsigned char>(bytes[at]);
    }
    return value;
  }

  std::uint64_t most() const {
    const auto text = data_.text.size();
    return left_.size() + (data_.encoding == VtuEncoding::raw ? text : text / 4 * 3);
  }

  [[noreturn]] void fail(const std::string& message) const { readers::fail(sources_, data_.place, message); }

 private:
  void decode_quad(std::string& bytes) {
    while (!data_.text.empty() && is_white(data_.text.front())) data_.text.remove_prefix(1);
    if (data_.text.size() < 4) fail("the binary data is cut off");
    std::uint32_t bits = 0;
    int characters = 0;
    for (int i = 0; i < 4; ++i) {
      const char c = data_.text[static_cast<std::size_t>(i)];
      const int value = c == '=' && i >= 2 ? 0 : base64_values[static_cast<unsigned char>(c)];
      if (value < 0) fail("the binary data is not base64");
      bits = bits << 6 | static_cast<std::uint32_t>(value);
      if (c != '=') characters = i + 1;
    }
    data_.text.remove_prefix(4);
    for (int i = 0; i + 1 < characters; ++i) bytes.push_back(static_cast<char>(bits >> (16 - 8 * i) & 0xff));
  }

  const Sources& sources_;
  VtuText data_;
  std::string left_;
};

// Unpacks one block into `plain`, which has the size that it must come to.
bool unpack(VtuCompression compression, const std::string& block, std::string& plain) {
  const auto* const from = reinterpret_cast<const std::uint8_t*>(block.data());
  auto* const to = reinterpret_cast<std::uint8_t*>(plain.data());
  if (compression == VtuCompression::zlib) {
    uLongf length = plain.size();
    return uncompress(to, &length, from, block.size()) == Z_OK && length == plain.size();
  }
  if (compression == VtuCompression::lz4) {
    constexpr auto most = static_cast<std::size_t>(std::numeric_limits<int>::max());
    if (block.size() > most || plain.size() > most) return false;
    const int length =
        LZ4_decompress_safe(block.data(), plain.data(), static_cast<int>(block.size()), static_cast<int>(plain.size()));
    return length >= 0 && static_cast<std::size_t>(length) == plain.size();
  }
  std::uint64_t memory = std::uint64_t{256} << 20;
  std::size_t read = 0, written = 0;
  return lzma_stream_buffer_decode(&memory, 0, nullptr, from, &read, block.size(), to, &written, plain.size()) ==
             LZMA_OK &&
         written == plain.size();
}

// Header: number of blocks, size of a block, size of the last one if it is shorter (else 0), compressed sizes.
std::string decompress(ByteStream& stream, const VtuBlocks& blocks) {
  const auto count = stream.number(blocks);
  const auto size = stream.number(blocks);
  const auto last_size = stream.number(blocks);
  if (count > stream.most() / blocks.header_size)
    stream.fail("the compressed data states more blocks than there can be");
  if (last_size > size) stream.fail("the compressed data states a wrong block size");
  std::vector<std::uint64_t> packed(count);
  for (auto& bytes : packed) bytes = stream.number(blocks);
  std::string result;
  for (std::size_t i = 0; i < count; ++i) {
    const auto block = stream.take(packed[i]);
    const auto wanted = i + 1 == count && last_size > 0 ? last_size : size;
    if (wanted > block.size() * most_packed(blocks.compression))
      stream.fail("the compressed data states a wrong block size");
    std::string plain(wanted, '\0');
    if (!unpack(blocks.compression, block, plain)) stream.fail("the compressed data is corrupt");
    result += plain;
  }
  return result;
}

}  // namespace

std::string decode(const Sources& sources, const VtuText& data, const VtuBlocks& blocks) {
  ByteStream stream(sources, data);
  if (blocks.compression != VtuCompression::none) return decompress(stream, blocks);
  return stream.take(stream.number(blocks));
}

}  // namespace ritz::readers
