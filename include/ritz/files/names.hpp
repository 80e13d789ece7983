// Names of the files that stand beside an output.
#pragma once
#include <filesystem>
#include <string_view>

namespace ritz::files {

/// The folder that a file stands in, "." where its path names none.
std::filesystem::path folder_of(const std::filesystem::path& file);

/// The table `name` of the run that writes `output`, in its folder and named after it: part.h5 -> part.NAME.csv, so
/// that runs with unlike outputs share nothing. Beside the default outputs model.h5, motion.h5 and full.h5: NAME.csv.
std::filesystem::path table_beside(const std::filesystem::path& output, std::string_view name);

}  // namespace ritz::files
