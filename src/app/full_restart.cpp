#include "ritz/app/full_file.hpp"
#include "ritz/base/error.hpp"
#include "ritz/parallel/guard.hpp"

namespace ritz::app {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why) {
  throw InputError("-restart " + path.string() + ": " + why);
}

/// Reads attributes and rows of /state; every failure is one sentence about the file.
class StateReader {
 public:
  explicit StateReader(const std::filesystem::path& path)
      : path_(path), file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) {
    if (!file_) refuse(path_, "there is no such HDF5 file, or it cannot be read");
    group_ =
        format::Group(H5Lexists(file_.get(), "state", H5P_DEFAULT) > 0 ? H5Gopen2(file_.get(), "state", H5P_DEFAULT)
                                                                       : H5I_INVALID_HID);
    if (!group_) refuse(path_, "it holds no last state; name a file that ritz-full wrote");
  }

  double number(const std::string& name) const {
    double value = 0;
    const auto attribute = open(name);
    if (H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, &value) < 0) refuse(path_, "its last state is damaged");
    return value;
  }

  std::string text(const std::string& name) const {
    const auto attribute = open(name);
    const format::Type type(H5Aget_type(attribute.get()));
    std::string value(H5Tget_size(type.get()), ' ');
    if (H5Aread(attribute.get(), type.get(), value.data()) < 0) refuse(path_, "its last state is damaged");
    return value;
  }

  /// `count` vertices from `first` on.
  parallel::RowMatrix rows(const std::string& name, const parallel::Slice& slice) const {
    const format::Dataset dataset(H5Dopen2(group_.get(), name.c_str(), H5P_DEFAULT));
    const format::Space in_file(H5Dget_space(dataset.get()));
    hsize_t shape[2] = {0, 0};
    if (H5Sget_simple_extent_ndims(in_file.get()) != 2 ||
        H5Sget_simple_extent_dims(in_file.get(), shape, nullptr) < 0 || shape[0] != static_cast<hsize_t>(slice.total) ||
        shape[1] != 3)
      refuse(path_, "its last state is damaged");
    const hsize_t start[2] = {static_cast<hsize_t>(slice.first), 0}, count[2] = {static_cast<hsize_t>(slice.count), 3};
    const format::Space in_memory(H5Screate_simple(2, count, nullptr));
    parallel::RowMatrix values(slice.count, 3);
    if (slice.count == 0) return values;
    if (H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, start, nullptr, count, nullptr) < 0 ||
        H5Dread(dataset.get(), H5T_NATIVE_DOUBLE, in_memory.get(), in_file.get(), H5P_DEFAULT, values.data()) < 0)
      refuse(path_, "its last state is damaged");
    return values;
  }

 private:
  format::Attribute open(const std::string& name) const {
    format::Attribute attribute(
        H5Aexists(group_.get(), name.c_str()) > 0 ? H5Aopen(group_.get(), name.c_str(), H5P_DEFAULT) : H5I_INVALID_HID);
    if (!attribute) refuse(path_, "its last state is damaged");
    return attribute;
  }

  std::filesystem::path path_;
  format::File file_;
  format::Group group_;
};

}  // namespace

LastState read_last_state(const std::filesystem::path& path, const mesh::Mesh& mesh,
                          const std::string& problem_checksum) {
  LastState state;
  const auto slice = parallel::even_slice(mesh.comm, mesh.vertices_total);
  parallel::RowMatrix rows(slice.count, 9);
  parallel::together(mesh.comm, [&] {
    const StateReader in(path);
    if (in.text("problem_checksum") != problem_checksum)
      refuse(path, "it was written for another mesh, material or support");
    state.kind = in.text("kind") == "moving" ? StateKind::moving : StateKind::at_rest;
    state.integrator = in.text("integrator");
    for (const auto* name : {"t", "kinetic", "elastic", "work", "dissipated", "start"})
      state.numbers[name] = in.number(name);
    rows << in.rows("displacement", slice), in.rows("velocity", slice), in.rows("acceleration", slice);
  });
  const std::vector<std::int64_t> numbers(mesh.file_positions.begin(), mesh.file_positions.begin() + mesh.owned);
  const auto mine = parallel::from_slices(mesh.comm, numbers, rows, mesh.vertices_total);
  Eigen::Index part = 0;
  for (petsc::Tall* column : {&state.u, &state.v, &state.a}) {
    const parallel::RowMatrix three = mine.middleCols(3 * part++, 3);
    *column = Eigen::Map<const petsc::Tall>(three.data(), three.size(), 1);
  }
  return state;
}

}  // namespace ritz::app
