// Names of the files beside an output.
#pragma once
#include <filesystem>
#include <string_view>

namespace ritz::files {

/// The folder of a file, "." if its path names none.
std::filesystem::path folder_of(const std::filesystem::path& file);

/// The path of the table `name` of the run that writes `output`: part.h5 -> part.NAME.csv in the same folder, so that
/// runs with different outputs share no files. Beside the default outputs model.h5, motion.h5 and full.h5 it is
/// NAME.csv.
std::filesystem::path table_beside(const std::filesystem::path& output, std::string_view name);

}  // namespace ritz::files
