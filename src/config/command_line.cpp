#include "ritz/config/command_line.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "ritz/base/error.hpp"
#include "ritz/base/regular_file.hpp"
#include "ritz/config/options_text.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/parallel/guard.hpp"

namespace ritz::config {
namespace {

constexpr std::uintmax_t most_bytes = 64 << 20;  ///< of an options file

std::string text_of(const std::filesystem::path& file) {
  const std::string given = "option -options_file " + file.string();
  refuse_irregular(file, given);
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(given + ": no such file, or it cannot be read");
  if (std::filesystem::file_size(file) > most_bytes) throw InputError(given + ": that is too large for options");
  std::string text(std::istreambuf_iterator<char>(in), {});
  if (text.find('\0') != text.npos) throw InputError(given + ": that is no text, for it holds a zero byte");
  return text;
}

std::vector<Option> parse(const std::string& text, const std::filesystem::path& file) {
  const bool yaml = file.extension() == ".yml" || file.extension() == ".yaml";
  return yaml ? parse_yaml_options(text, file.string()) : parse_plain_options(text, file.string());
}

/// *Collective*.
std::vector<Option> read_file(MPI_Comm comm, const std::filesystem::path& file) {
  std::string text;
  parallel::on_root(comm, [&] {
    text = text_of(file);
    parse(text, file);
  });
  parallel::broadcast(comm, text);
  return parse(text, file);
}

[[noreturn]] void refuse_word(const std::string& word, const std::string& before) {
  if (before.find(' ') == before.npos)
    throw InputError("'" + word + "' is not an option; options begin with a dash, such as -mesh " + word);
  throw InputError("'" + word + "' stands after " + before +
                   ", and an option has one value: write several with commas, " + before + "," + word +
                   ", and one with a blank in quotes");
}

}  // namespace

CommandLine read_command_line(MPI_Comm comm, int argc, char** argv) {
  CommandLine line;
  std::string last;  // option with its value
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (!is_option(word)) refuse_word(word, last);
    const bool has_value = i + 1 < argc && !is_option(argv[i + 1]);
    const std::string value = has_value ? argv[++i] : "";
    last = has_value ? word + " " + value : word;
    if (word == "-help" || word == "--help" || word == "-h") line.asked = Asked::help;
    else if (word == "-version" || word == "--version") line.asked = Asked::version;
    else if (word != "-options_file") line.given.put({word.substr(1), value});
    else if (has_value) line.files.emplace_back(value);
    else throw InputError("option -options_file needs a file after it");
  }
  for (const auto& file : line.files) {
    auto options = read_file(comm, file);
    std::ranges::reverse(options);  // the last one wins, and what is given first stays
    for (const auto& option : options) line.given.add(option);
  }
  return line;
}

}  // namespace ritz::config
