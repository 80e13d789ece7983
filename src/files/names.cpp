#include "ritz/files/names.hpp"

#include <string>

namespace ritz::files {

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

std::filesystem::path table_beside(const std::filesystem::path& output, std::string_view name) {
  const auto file = output.filename();
  const bool plain = file == "model.h5" || file == "motion.h5" || file == "full.h5";
  const auto table = std::string(name) + ".csv";
  return output.parent_path() / (plain ? table : file.stem().string() + "." + table);
}

}  // namespace ritz::files
