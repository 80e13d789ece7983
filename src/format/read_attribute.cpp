#include <algorithm>
#include <cmath>

#include "read.hpp"

namespace ritz::format {

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
