// A folder with the sample model, scenes and what a run leaves behind.
#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "ritz/format/parts.hpp"
#include "ritz/tools/run.hpp"
#include "support/sample_model.hpp"

namespace ritz::test {

class RunFolder {
 public:
  RunFolder() {
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("ritz_run_" + std::to_string(getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ~RunFolder() { std::filesystem::remove_all(path_); }
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  /// Options for a run of `scene` on `model`; the output is motion.h5 in this folder.
  tools::RunOptions prepare(const std::string& scene, const model::Model& model = sample_model()) const {
    format::write(path_ / "model.h5", model);
    std::ofstream(path_ / "scene.toml") << scene;
    tools::RunOptions options;
    options.model = path_ / "model.h5";
    options.scene = path_ / "scene.toml";
    options.output = path_ / "motion.h5";
    return options;
  }

  /// The names of files that are not inputs, ascending.
  std::vector<std::string> outputs() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) {
      const std::string name = entry.path().filename().string();
      if (!name.starts_with("model.") && name != "scene.toml") names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  std::filesystem::path path_;
};

/// Gives the first column of a model's basis other numbers, so that whoever reads it meets a wrong checksum.
inline void spoil_basis(const std::filesystem::path& model) {
  const format::File file(H5Fopen(model.c_str(), H5F_ACC_RDWR, H5P_DEFAULT));
  const format::Dataset column(H5Dopen2(file.get(), "/bodies/body/basis/columns/0001", H5P_DEFAULT));
  const std::vector<double> other(12, 7.);
  ASSERT_GE(H5Dwrite(column.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, other.data()), 0);
}

/// What a run says, its warnings after the rest.
inline std::string run(const tools::RunOptions& options) {
  std::ostringstream out, err;
  tools::run(options, out, err);
  return out.str() + err.str();
}

struct Csv {
  std::string header;
  std::vector<std::vector<double>> rows;
};

inline Csv read_csv(const std::filesystem::path& path) {
  Csv csv;
  std::ifstream in(path);
  std::getline(in, csv.header);
  for (std::string line; std::getline(in, line);) {
    std::vector<double> row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    csv.rows.push_back(row);
  }
  return csv;
}

/// All numbers of a dataset, with its shape.
struct Numbers {
  std::vector<hsize_t> shape;
  std::vector<double> values;
};

inline Numbers read_numbers(const std::filesystem::path& path, const char* name) {
  const format::File file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
  const format::Dataset dataset(H5Dopen2(file.get(), name, H5P_DEFAULT));
  if (!dataset) return {};
  const format::Space space(H5Dget_space(dataset.get()));
  Numbers numbers;
  numbers.shape.resize(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space.get())));
  H5Sget_simple_extent_dims(space.get(), numbers.shape.data(), nullptr);
  numbers.values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get())));
  H5Dread(dataset.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.values.data());
  return numbers;
}

/// The numbers among the attributes of an object, by name.
inline std::map<std::string, double> read_attributes(const std::filesystem::path& path, const char* name) {
  const format::File file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
  std::map<std::string, double> numbers;
  const auto add = [](hid_t object, const char* attribute, const H5A_info_t*, void* all) -> herr_t {
    const format::Attribute found(H5Aopen(object, attribute, H5P_DEFAULT));
    const format::Type type(H5Aget_type(found.get()));
    double value = 0;
    if (H5Tget_class(type.get()) == H5T_STRING) return 0;
    H5Aread(found.get(), H5T_NATIVE_DOUBLE, &value);
    (*static_cast<std::map<std::string, double>*>(all))[attribute] = value;
    return 0;
  };
  EXPECT_GE(H5Aiterate_by_name(file.get(), name, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, add, &numbers, H5P_DEFAULT),
            0);
  return numbers;
}

}  // namespace ritz::test
