// Parses the text of an options file into options, in the order of the file. Serial; time and memory are proportional
// to the length of the text.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "ritz/config/options.hpp"

namespace ritz::config {

/// Whether a word is an option and not a value, by PETSc's rule: a dash that no digit follows.
bool is_option(std::string_view word);

/// Throws InputError when an options file names another options file.
void refuse_file_in_file(const std::string& name, const std::string& place);

/// Parses one option per line, with words and quotes as in a shell. `file` is the name for errors. Throws InputError.
std::vector<Option> parse_plain_options(const std::string& text, const std::string& file);

/// Parses YAML. `name: value` is an option; a mapping is a prefix, so that `material: {young: 1e9}` is -material_young;
/// a sequence is its entries separated by commas; what stands under a key that begins with $$ is skipped, as by PETSc.
/// Aliases are refused, as a few lines of them can expand without end. Throws InputError.
std::vector<Option> parse_yaml_options(const std::string& text, const std::string& file);

}  // namespace ritz::config
