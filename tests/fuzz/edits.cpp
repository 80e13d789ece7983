#include "fuzz/edits.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <iterator>
#include <limits>

#include "fuzz/target.hpp"
#include "ritz/format/checksum.hpp"
#include "ritz/format/schema.hpp"
#include "support/unwatched.hpp"
#ifdef RITZ_ADDRESS_SANITIZER
#include <sanitizer/common_interface_defs.h>
#endif

namespace ritz::fuzz {
namespace {

using namespace format;
using Paths = std::vector<std::string>;

const std::string& one_of(const Paths& paths, Choices& choices) { return paths[choices.below(paths.size())]; }

/// A number as an attacker likes it.
std::uint64_t liked(Choices& choices) {
  constexpr std::array<std::uint64_t, 8> values = {0,
                                                   1,
                                                   3,
                                                   ~std::uint64_t{0},
                                                   std::uint64_t{1} << 32,
                                                   std::uint64_t{1} << 40,
                                                   0x7fffffffffffffff,
                                                   0x1555555555555556};
  const auto which = choices.below(2 * values.size());
  return which < values.size() ? values[which] : choices.number(1);
}

Type type_of(Choices& choices) {
  const hid_t numbers[] = {H5T_IEEE_F64LE, H5T_STD_I64LE, H5T_STD_U8LE, H5T_STD_U64LE, H5T_IEEE_F32LE, H5T_IEEE_F64BE};
  const auto which = choices.below(std::size(numbers) + 5);
  if (which < std::size(numbers)) return Type(H5Tcopy(numbers[which]));
  switch (which - std::size(numbers)) {
    case 0: {
      Type text(H5Tcopy(H5T_C_S1));
      H5Tset_size(text.get(), std::max<std::size_t>(1, choices.below(64)));
      return text;
    }
    case 1: {
      Type text(H5Tcopy(H5T_C_S1));
      H5Tset_size(text.get(), H5T_VARIABLE);
      return text;
    }
    case 2: {
      Type pair(H5Tcreate(H5T_COMPOUND, 16));
      H5Tinsert(pair.get(), "re", 0, H5T_IEEE_F64LE);
      H5Tinsert(pair.get(), "im", 8, H5T_IEEE_F64LE);
      return pair;
    }
    case 3: {
      const hsize_t length = 1 + choices.below(8);
      return Type(H5Tarray_create2(H5T_IEEE_F64LE, 1, &length));
    }
    default: return Type(H5Tvlen_create(H5T_IEEE_F64LE));
  }
}

Space space_of(Choices& choices) {
  const auto rank = choices.below(5);
  if (rank == 0) return Space(H5Screate(choices.below(2) == 0 ? H5S_SCALAR : H5S_NULL));
  std::array<hsize_t, 4> extent{};
  for (std::size_t i = 0; i < rank; ++i) extent[i] = choices.below(4) == 0 ? liked(choices) : choices.below(14);
  return Space(H5Screate_simple(static_cast<int>(rank), extent.data(), nullptr));
}

/// The bytes of a small array of fixed size; none of others, which are not written.
std::vector<std::byte> small_values(const Type& type, const Space& space, Choices& choices) {
  const auto points = H5Sget_simple_extent_npoints(space.get());
  const auto size = H5Tget_size(type.get());
  const bool fixed = H5Tis_variable_str(type.get()) <= 0 && H5Tdetect_class(type.get(), H5T_VLEN) <= 0;
  if (points <= 0 || points > 4096 || size > 4096 || !fixed) return {};
  std::vector<std::byte> bytes(static_cast<std::size_t>(points) * size);
  const auto value = liked(choices);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::byte>(value >> (8 * (i % 8)) & 255);
  return bytes;
}

void write_attribute(hid_t object, const char* name, hid_t type, hid_t space, const void* value) {
  if (H5Aexists(object, name) > 0) H5Adelete(object, name);
  const Attribute attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT));
  if (attribute && value) H5Awrite(attribute.get(), type, value);
}

void write_checksum(const Dataset& dataset, const Space& space, std::span<const std::byte> bytes) {
  std::array<hsize_t, H5S_MAX_RANK> extent{};
  const int rank = H5Sget_simple_extent_dims(space.get(), extent.data(), nullptr);
  const auto rows = rank > 0 ? static_cast<std::size_t>(extent[0]) : 1;
  const auto sum = format::checksum(bytes, rows > 0 ? bytes.size() / rows : 0);
  const Space one(H5Screate(H5S_SCALAR));
  write_attribute(dataset.get(), schema::checksum, H5T_STD_U64LE, one.get(), &sum);
  const Type text(H5Tcopy(H5T_C_S1));
  write_attribute(dataset.get(), schema::units, text.get(), one.get(), "1");
}

/// Plain, in chunks (of data that is not there), packed, or in another file.
Properties layout_of(const Space& space, Choices& choices) {
  Properties layout(H5Pcreate(H5P_DATASET_CREATE));
  const auto kind = choices.below(8);
  std::array<hsize_t, H5S_MAX_RANK> extent{};
  const int rank = H5Sget_simple_extent_dims(space.get(), extent.data(), nullptr);
  if (rank > 0 && (kind == 1 || kind == 2)) {
    for (auto& length : extent) length = std::clamp<hsize_t>(length, 1, 1024);
    H5Pset_chunk(layout.get(), rank, extent.data());
    if (kind == 2) H5Pset_deflate(layout.get(), 6);
  }
  if (kind == 3) H5Pset_external(layout.get(), "/etc/hostname", 0, H5F_UNLIMITED);
  if (kind == 4) H5Pset_layout(layout.get(), H5D_COMPACT);
  return layout;
}

void replace_dataset(hid_t file, const Paths& paths, Choices& choices) {
  const auto& path = one_of(paths, choices);
  const Type type = type_of(choices);
  const Space space = space_of(choices);
  const Properties layout = layout_of(space, choices);
  H5Ldelete(file, path.c_str(), H5P_DEFAULT);
  const Dataset made(H5Dcreate2(file, path.c_str(), type.get(), space.get(), H5P_DEFAULT, layout.get(), H5P_DEFAULT));
  if (!made) return;
  const auto bytes = small_values(type, space, choices);
  if (!bytes.empty()) H5Dwrite(made.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data());
  write_checksum(made, space, bytes);
}

/// Another number in a dataset, with the checksum that belongs to it.
void change_value(hid_t file, const Paths& paths, Choices& choices) {
  const Dataset dataset(H5Dopen2(file, one_of(paths, choices).c_str(), H5P_DEFAULT));
  if (!dataset) return;
  const Type type(H5Dget_type(dataset.get()));
  const Space space(H5Dget_space(dataset.get()));
  auto bytes = small_values(type, space, choices);
  if (bytes.empty() || H5Dread(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) < 0) return;
  const bool real = H5Tget_class(type.get()) == H5T_FLOAT && choices.below(2) == 0;
  using Limits = std::numeric_limits<double>;
  constexpr std::array<double, 6> reals = {-1, 0, 1e300, 1e-300, Limits::infinity(), Limits::quiet_NaN()};
  const auto value = real ? std::bit_cast<std::uint64_t>(reals[choices.below(reals.size())]) : liked(choices);
  const auto size = std::min<std::size_t>(8, H5Tget_size(type.get()));
  const auto at = choices.below(bytes.size() / size) * size;
  for (std::size_t i = 0; i < size; ++i) bytes[at + i] = static_cast<std::byte>(value >> (8 * i) & 255);
  H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data());
  write_checksum(dataset, space, bytes);
}

void change_link(hid_t file, const Paths& paths, Choices& choices) {
  const auto &path = one_of(paths, choices), &other = one_of(paths, choices);
  const auto kind = choices.below(6);
  if (kind == 5) {
    const auto name = other + "/\x1b[31m" + std::string(choices.below(40), 'x');
    H5Lcreate_hard(file, path.c_str(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    return;
  }
  const Object kept(H5Oopen(file, other.c_str(), H5P_DEFAULT));
  H5Ldelete(file, path.c_str(), H5P_DEFAULT);
  if (kind == 1) H5Lcreate_soft(other.c_str(), file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  if (kind == 2 && kept) H5Olink(kept.get(), file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  if (kind == 3) H5Lcreate_external("/etc/hostname", "/", file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  if (kind == 4) {
    const Group made(H5Gcreate2(file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    if (kept && made) H5Olink(made.get(), made.get(), "itself", H5P_DEFAULT, H5P_DEFAULT);
  }
}

/// A view of a dataset, perhaps of itself, in place of another.
void make_view(hid_t file, const Paths& paths, Choices& choices) {
  const auto &path = one_of(paths, choices), &source = one_of(paths, choices);
  const Space space = space_of(choices), from = space_of(choices);
  const Properties layout(H5Pcreate(H5P_DATASET_CREATE));
  H5Pset_virtual(layout.get(), space.get(), choices.below(4) == 0 ? "/etc/hostname" : ".", source.c_str(), from.get());
  H5Ldelete(file, path.c_str(), H5P_DEFAULT);
  const Dataset made(
      H5Dcreate2(file, path.c_str(), H5T_IEEE_F64LE, space.get(), H5P_DEFAULT, layout.get(), H5P_DEFAULT));
  if (made) write_checksum(made, space, {});
}

void change_attribute(hid_t file, const Paths& paths, Choices& choices) {
  const Object object(H5Oopen(file, one_of(paths, choices).c_str(), H5P_DEFAULT));
  const int count = object ? H5Aget_num_attrs(object.get()) : 0;
  if (count <= 0) return;
  std::array<char, 64> name{};
  const auto index = choices.below(static_cast<std::size_t>(count));
  H5Aget_name_by_idx(object.get(), ".", H5_INDEX_NAME, H5_ITER_INC, index, name.data(), name.size(), H5P_DEFAULT);
  if (choices.below(4) == 0) {
    H5Adelete(object.get(), name.data());
    return;
  }
  const Attribute old(H5Aopen(object.get(), name.data(), H5P_DEFAULT));
  const bool same_kind = choices.below(2) == 0;
  const Type type = same_kind ? Type(H5Aget_type(old.get())) : type_of(choices);
  const Space space = same_kind ? Space(H5Aget_space(old.get())) : space_of(choices);
  const auto bytes = small_values(type, space, choices);
  write_attribute(object.get(), name.data(), type.get(), space.get(), bytes.empty() ? nullptr : bytes.data());
}

void edit(hid_t file, const Paths& paths, Choices& choices) {
  constexpr std::array changes = {change_value, change_value,     replace_dataset,
                                  change_link,  change_attribute, make_view};
  changes[choices.below(changes.size())](file, paths, choices);
}

/// In a process of its own, since HDF5 itself crashes on some edits of what was edited before.
[[noreturn]] void edit_and_exit(const std::filesystem::path& path, const Paths& paths, Choices choices) {
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM}) signal(number, SIG_DFL);
#ifdef RITZ_ADDRESS_SANITIZER
  __sanitizer_set_death_callback([] { _exit(1); });  // what HDF5 does here is no finding that libFuzzer should keep
#endif
  constexpr unsigned patience = 5;  // s
  alarm(patience);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  {
    const Properties access(H5Pcreate(H5P_FILE_ACCESS));
    H5Pset_libver_bounds(access.get(), H5F_LIBVER_V110, H5F_LIBVER_V110);
    const File file(H5Fopen(path.c_str(), H5F_ACC_RDWR, access.get()));
    for (int edits = 0; edits < 4 && !choices.ended(); ++edits) edit(file.get(), paths, choices);
  }
  _exit(0);
}

}  // namespace

std::uint64_t Choices::number(std::size_t bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes && !bytes_.empty(); ++i, bytes_ = bytes_.subspan(1)) value = value << 8 | bytes_[0];
  return value;
}

void damage(std::vector<std::byte>& image, Choices& choices) {
  for (int runs = 0; runs < 4 && !choices.ended(); ++runs) {
    const auto at = static_cast<std::size_t>(choices.number(3)) % image.size();
    const auto length = std::min(image.size() - at, std::size_t{1} << choices.below(10));
    const auto value = static_cast<std::byte>(choices.number(1));
    std::fill_n(image.begin() + static_cast<std::ptrdiff_t>(at), length, value);
  }
}

std::vector<std::byte> edited(const std::vector<std::byte>& image, const std::vector<std::string>& paths,
                              Choices choices) {
  const auto path = as_file({reinterpret_cast<const std::uint8_t*>(image.data()), image.size()}, "edited.h5");
  const pid_t child = fork();
  if (child == 0) edit_and_exit(path, paths, choices);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  constexpr std::uintmax_t most =
      1 << 24;  // a dataset may have taken more of the file's addresses than there is memory
  if (status != 0 || std::filesystem::file_size(path) > most) return {};
  std::ifstream in(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const auto all = std::as_bytes(std::span(bytes));
  return {all.begin(), all.end()};
}

std::vector<std::string> paths_in(const std::filesystem::path& path) {
  const File file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
  Paths paths;
  const auto take = [](hid_t, const char* name, const H5O_info_t*, void* to) -> herr_t {
    static_cast<Paths*>(to)->push_back(std::string("/") + (name[0] == '.' ? "" : name));
    return 0;
  };
  H5Ovisit2(file.get(), H5_INDEX_NAME, H5_ITER_INC, take, &paths, H5O_INFO_BASIC);
  return paths;
}

}  // namespace ritz::fuzz
