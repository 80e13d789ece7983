// ritz-scene: the loads of a deck as a scene. See --help.
#include <iostream>
#include <new>

#include "options.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/printable.hpp"
#include "ritz/files/claim.hpp"
#include "ritz/files/interruption.hpp"
#include "ritz/files/part_file.hpp"
#include "take.hpp"

namespace {

using namespace ritz;

int fail(int code, const std::string& message) {
  std::cerr << "ritz-scene: " << printable(message) << '\n';
  return code;
}

void write_file(const std::string& text, const std::filesystem::path& path, const files::Claim& claim) {
  files::PartFile file(path);
  file.write(text);
  file.finish();
  claim.verify();
  file.publish();
  claim.say_published();
}

void run(const decks::Options& options) {
  std::optional<files::Claim> claim;
  const auto& output = options.output;
  if (!output.empty()) claim.emplace(files::Plan{.outputs = {{"--output " + output.string(), output}}});
  const auto taken = decks::take(options);
  if (claim) {
    std::vector<files::Named> inputs;
    for (const auto& file : taken.files) inputs.push_back({"the deck " + file.string(), file});
    claim->refuse(inputs);
    write_file(taken.text, output, *claim);
  } else {
    std::cout << taken.text;
  }
  for (const auto& note : taken.notes) std::cerr << "ritz-scene: warning: " << printable(note) << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  files::watch_interruptions("ritz-scene");
  try {
    const auto parsed = decks::parse_options(argc, argv);
    if (const auto* help = std::get_if<decks::Help>(&parsed)) std::cout << help->text;
    else run(std::get<decks::Options>(parsed));
    if (std::cout.flush()) return exit_done;
    return fail(exit_numerical, "standard output could not be written: is it closed, or the disk full?");
  } catch (const InputError& error) {
    return fail(exit_input, error.what());
  } catch (const std::bad_alloc&) {
    return fail(exit_numerical, "there is not enough memory");
  } catch (const std::exception& error) {
    return fail(exit_numerical, error.what());
  }
}
