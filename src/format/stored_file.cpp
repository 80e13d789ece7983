#include "ritz/format/stored_file.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

#include "read.hpp"
#include "ritz/base/error.hpp"

namespace ritz::format {
namespace {

constexpr std::array<char, 8> signature = {'\x89', 'H', 'D', 'F', '\r', '\n', '\x1a', '\n'};

void check_signature(const std::string& name, const Wording& wording, std::string_view start) {
  if (start != std::string_view(signature.data(), signature.size()))
    throw InputError(name + " is not an HDF5 file, so not a " + wording.kind + "; give the file that " +
                     wording.writer + " wrote");
}

void check_path(const std::filesystem::path& path, const std::string& name, const Wording& wording) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (std::filesystem::is_directory(status))
    throw InputError(name + " is a folder; give the " + wording.kind + " file in it");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw InputError(name + " is not a regular file; give the file that " + wording.writer + " wrote");
  if (path.extension() == ".part")
    throw InputError(name + " is half-written: the run that made it did not finish; run " + wording.writer + " again");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(name + " cannot be read: " + std::strerror(errno));
  std::array<char, signature.size()> start{};
  file.read(start.data(), start.size());
  check_signature(name, wording, {start.data(), static_cast<std::size_t>(file.gcount())});
}

/// HDF5 takes two images of one name for one file, so each gets its own.
std::string image_name() {
  static std::atomic<unsigned> count = 0;
  return "ritz-model-in-memory-" + std::to_string(count++);
}

File open_checked(const std::string& path, const std::string& name, const Wording& wording, const Properties& access) {
  File file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()));
  if (!file)
    throw InputError(name + " is truncated, damaged or half-written; write the " + wording.kind + " again with " +
                     wording.writer);
  return file;
}

}  // namespace

StoredFile::StoredFile(const std::filesystem::path& path, std::string name, Wording wording)
    : name_(std::move(name)), wording_(std::move(wording)) {
  check_path(path, name_, wording_);
  const Quiet quiet;
  file_ = open_checked(path.string(), name_, wording_, Properties(H5Pcreate(H5P_FILE_ACCESS)));
}

StoredFile::StoredFile(std::span<const std::byte> image, std::string name, Wording wording)
    : name_(std::move(name)), wording_(std::move(wording)) {
  const auto length = std::min(image.size(), signature.size());
  check_signature(name_, wording_, {reinterpret_cast<const char*>(image.data()), length});
  const Quiet quiet;
  const Properties access(H5Pcreate(H5P_FILE_ACCESS));
  constexpr std::size_t growth = 65536;
  H5Pset_fapl_core(access.get(), growth, false);
  H5Pset_file_image(access.get(), const_cast<std::byte*>(image.data()), image.size());  // copied, never changed
  file_ = open_checked(image_name(), name_, wording_, access);
}

void read_rows(const StoredFile& in, const std::string& path, const Shape& expected, std::int64_t first,
               std::int64_t count, double* values) {
  const StoredArray array(in, path);
  array.expect(expected, hdf5_type<double>());
  array.load(first, count, values);
  require_finite(in, path, {values, static_cast<std::size_t>(count) * array.row_bytes() / sizeof(double)});
}

void verify_rows(const StoredFile& in, const std::string& path) {
  const StoredArray array(in, path);
  std::vector<std::byte> bytes(static_cast<std::size_t>(array.rows()) * array.row_bytes());
  array.read(0, array.rows(), bytes.data());
}

namespace {

struct Found {
  Attribute attribute;
  Type type;
  Space space;
};

Found find(const StoredFile& in, const std::string& object, const char* name) {
  Attribute attribute(H5Aopen_by_name(in.file(), object.c_str(), name, H5P_DEFAULT, H5P_DEFAULT));
  if (!attribute) fail(in, object, std::string("has no readable attribute '") + name + "'");
  Type type(H5Aget_type(attribute.get()));
  Space space(H5Aget_space(attribute.get()));
  return {std::move(attribute), std::move(type), std::move(space)};
}

template <class T>
std::vector<T> numbers(const StoredFile& in, const std::string& object, const char* name) {
  const Quiet quiet;
  const auto found = find(in, object, name);
  const auto count = H5Sget_simple_extent_npoints(found.space.get());
  if (count < 0 || H5Tequal(found.type.get(), hdf5_type<T>()) <= 0)
    fail(in, object, std::string("has an attribute '") + name + "' of the wrong type");
  constexpr hssize_t most = 1000;
  if (count > most) fail(in, object, std::string("has an attribute '") + name + "' of too many numbers");
  std::vector<T> values(static_cast<std::size_t>(count));
  if (H5Aread(found.attribute.get(), hdf5_type<T>(), values.data()) < 0)
    fail(in, object, std::string("has an attribute '") + name + "' that cannot be read");
  return values;
}

template <class T>
T number(const StoredFile& in, const std::string& object, const char* name) {
  const auto values = numbers<T>(in, object, name);
  if (values.size() != 1) fail(in, object, std::string("has an attribute '") + name + "' that is not one number");
  return values.front();
}

}  // namespace

double read_double(const StoredFile& in, const std::string& object, const char* name) {
  const double value = number<double>(in, object, name);
  if (!std::isfinite(value))
    fail(in, object, std::string("has an attribute '") + name + "' that is not a finite number");
  return value;
}

Index read_index(const StoredFile& in, const std::string& object, const char* name) {
  return number<Index>(in, object, name);
}

std::uint64_t read_bits(const StoredFile& in, const std::string& object, const char* name) {
  return number<std::uint64_t>(in, object, name);
}

std::vector<Index> read_indices(const StoredFile& in, const std::string& object, const char* name) {
  return numbers<Index>(in, object, name);
}

bool has_attribute(const StoredFile& in, const std::string& object, const char* name) {
  const Quiet quiet;
  return H5Aexists_by_name(in.file(), object.c_str(), name, H5P_DEFAULT) > 0;
}

std::string read_text(const StoredFile& in, const std::string& object, const char* name) {
  const Quiet quiet;
  const auto found = find(in, object, name);
  const bool fixed = H5Tget_class(found.type.get()) == H5T_STRING && H5Tis_variable_str(found.type.get()) == 0;
  if (!fixed || H5Sget_simple_extent_npoints(found.space.get()) != 1)
    fail(in, object, std::string("has an attribute '") + name + "' that is not a fixed-length text");
  constexpr std::size_t longest = 1 << 16;
  if (H5Tget_size(found.type.get()) > longest)
    fail(in, object, std::string("has an attribute '") + name + "' that is too long a text");
  std::string text(H5Tget_size(found.type.get()), '\0');
  if (H5Aread(found.attribute.get(), found.type.get(), text.data()) < 0)
    fail(in, object, std::string("has an attribute '") + name + "' that cannot be read");
  text.resize(std::min(text.find('\0'), text.size()));
  return text;
}

}  // namespace ritz::format
