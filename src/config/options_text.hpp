// The text of an options file → its options, in the file's order. Serial; time and memory in proportion to the text.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "ritz/config/given.hpp"

namespace ritz::config {

/// PETSc's own rule for what begins an option and is no value: a dash and then no digit.
bool is_option(std::string_view word);

/// Throws InputError where an options file names another one.
void refuse_file_in_file(const std::string& name, const std::string& place);

/// An option a line, in words and quotes as a shell reads them. `file` is what errors call it. Throws InputError.
std::vector<Option> parse_plain_options(const std::string& text, const std::string& file);

/// YAML: `name: value`; a mapping is a prefix, `material: {young: 1e9}` being -material_young; a sequence stands for
/// its entries with commas between; what stands under a key that begins with $$ is left out, as by PETSc. There are no
/// aliases, which a few lines can make endless. Throws InputError.
std::vector<Option> parse_yaml_options(const std::string& text, const std::string& file);

}  // namespace ritz::config
