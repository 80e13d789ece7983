#include "ritz/format/reader.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "read.hpp"
#include "ritz/base/error.hpp"

namespace ritz::format {

namespace {

constexpr std::array<char, 8> signature = {'\x89', 'H', 'D', 'F', '\r', '\n', '\x1a', '\n'};

void check_signature(const std::string& name, std::string_view start) {
  if (start != std::string_view(signature.data(), signature.size()))
    throw InputError(name + " is not an HDF5 file, so not a model; give the file that ritz-reduce wrote");
}

void check_path(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    throw InputError(path.string() + " is a folder; give the model file in it");
  if (path.extension() == ".part")
    throw InputError(path.string() + " is half-written: the run that made it did not finish; run ritz-reduce again");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError("cannot read the model " + path.string() + ": " + std::strerror(errno));
  std::array<char, signature.size()> start{};
  file.read(start.data(), start.size());
  check_signature(path.string(), {start.data(), static_cast<std::size_t>(file.gcount())});
}

/// HDF5 takes two images of one name for one file, so each gets its own.
std::string image_name() {
  static std::atomic<unsigned> count = 0;
  return "ritz-model-in-memory-" + std::to_string(count++);
}

File open_checked(const std::string& path, const std::string& name, const Properties& access) {
  File file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()));
  if (!file) throw InputError(name + " is truncated, damaged or half-written; write the model again with ritz-reduce");
  return file;
}

}  // namespace

ModelReader::ModelReader(const std::filesystem::path& path) : name_(path.string()) {
  check_path(path);
  const Quiet quiet;
  const Properties access(H5Pcreate(H5P_FILE_ACCESS));
  file_ = open_checked(name_, name_, access);
  check_root();
}

ModelReader::ModelReader(std::span<const std::byte> image, std::string name) : name_(std::move(name)) {
  const auto length = std::min(image.size(), signature.size());
  check_signature(name_, {reinterpret_cast<const char*>(image.data()), length});
  const Quiet quiet;
  const Properties access(H5Pcreate(H5P_FILE_ACCESS));
  constexpr std::size_t growth = 65536;
  H5Pset_fapl_core(access.get(), growth, false);
  H5Pset_file_image(access.get(), const_cast<std::byte*>(image.data()), image.size());  // copied, never changed
  file_ = open_checked(image_name(), name_, access);
  check_root();
}

void ModelReader::check_root() {
  const bool named = H5Aexists(file(), schema::format) > 0 && H5Aexists(file(), schema::version) > 0;
  if (!named || read_text(*this, "/", schema::format) != schema::format_name)
    throw InputError(name_ + " is an HDF5 file but not a ritz model; give the file that ritz-reduce wrote");
  const auto version = read_indices(*this, "/", schema::version);
  if (version.size() != 2 || version[0] < 1 || version[1] < 0) fail(*this, "/", "has no sensible format version");
  minor_ = static_cast<int>(version[1]);
  if (version[0] == schema::major) return;
  std::string writer = "newer ritz";
  if (H5Aexists_by_name(file(), schema::provenance.data(), schema::program, H5P_DEFAULT) > 0)
    writer = "ritz of " + read_text(*this, std::string(schema::provenance), schema::program);
  throw InputError(name_ + " has the model format " + std::to_string(version[0]) + "." + std::to_string(version[1]) +
                   ", this program reads " + std::to_string(schema::major) + ".x; use the " + writer +
                   " that wrote it, or a later one");
}

std::vector<std::string> ModelReader::bodies() const {
  auto names = links(*this, std::string(schema::bodies));
  std::ranges::transform(names, names.begin(), schema::name_of_link);
  return names;
}

bool ModelReader::has(std::string_view part, std::string_view body) const {
  return exists(*this, schema::body_part(body, part));
}

}  // namespace ritz::format
