#include "ritz/app/npy.hpp"

#include <array>
#include <fstream>
#include <regex>
#include <string>

#include "ritz/base/error.hpp"

namespace ritz::app {
namespace {

/// The text between the magic string and the numbers; empty where the file is none of NumPy's.
std::string header_text(std::istream& in) {
  std::array<unsigned char, 8> start{};
  in.read(reinterpret_cast<char*>(start.data()), start.size());
  const std::string magic(start.begin(), start.begin() + 6);
  if (!in || magic != "\x93NUMPY" || start[6] < 1 || start[6] > 3) return "";
  std::array<unsigned char, 4> length{};
  in.read(reinterpret_cast<char*>(length.data()), start[6] == 1 ? 2 : 4);
  const std::size_t bytes =
      length[0] + (std::size_t{length[1]} << 8) + (std::size_t{length[2]} << 16) + (std::size_t{length[3]} << 24);
  constexpr std::size_t most = 1 << 16;
  if (!in || bytes > most) return "";
  std::string text(bytes, ' ');
  in.read(text.data(), static_cast<std::streamsize>(bytes));
  return in ? text : "";
}

std::string without_padding(std::string text) {
  text.erase(text.find_last_not_of(" \n") + 1);
  constexpr std::size_t most = 1000;  // std::regex recurses
  return text.size() > most ? "" : text;
}

}  // namespace

NpyArray read_npy_header(const std::filesystem::path& file, const std::string& option) {
  const auto refuse = [&](const std::string& why) { throw InputError(option + " " + file.string() + ": " + why); };
  std::ifstream in(file, std::ios::binary);
  const auto text = header_text(in);
  if (text.empty()) refuse("that is not a .npy file of version 1, 2 or 3; write it with numpy.save");
  const std::regex form(
      R"(\{ *'descr': *'<f8', *'fortran_order': *False, *'shape': *\((\d{1,15}), *(\d{1,15}),?\),? *\})");
  std::smatch found;
  const auto header = without_padding(text);
  if (!std::regex_match(header, found, form))
    refuse("snapshots must be a float64 array of two dimensions in C order, a snapshot a row");
  const NpyArray array{static_cast<std::int64_t>(in.tellg()), std::stoll(found[1]), std::stoll(found[2])};
  const auto bytes = static_cast<std::int64_t>(std::filesystem::file_size(file)) - array.first_byte;
  const std::int64_t row = 8 * array.columns;
  if (row > 0 && bytes / row < array.rows)
    refuse("the file ends before its snapshot " + std::to_string(bytes / row + 1));
  if (bytes != row * array.rows) refuse("the file is longer than its header says; write it again with numpy.save");
  return array;
}

}  // namespace ritz::app
