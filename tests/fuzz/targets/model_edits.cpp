// A model of two bodies, with every part, that was changed in as many ways as the input has bytes for.
#include <fstream>
#include <iterator>

#include "fuzz/edits.hpp"
#include "fuzz/models.hpp"
#include "fuzz/target.hpp"
#include "ritz/format/parts.hpp"
#include "support/nonlinear_sample_model.hpp"

namespace ritz::fuzz {
namespace {

struct Sample {
  std::vector<std::byte> image;
  std::vector<std::string> paths;
};

Sample make_sample() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const auto path = as_file({}, "model.h5");
  format::write(path, test::two_body_model());
  std::ifstream in(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const auto all = std::as_bytes(std::span(bytes));
  return {{all.begin(), all.end()}, paths_in(path)};
}

}  // namespace

void read_input(Bytes input) {
  static const Sample sample = make_sample();
  Choices choices(input);
  auto image = sample.image;
  if (choices.below(2) == 0) image = edited(sample.image, sample.paths, choices);
  else damage(image, choices);
  read_as_all_programs(format::ModelReader(image));
}

}  // namespace ritz::fuzz
