// The main of a fuzz target with any compiler. See usage.
//
// An input that is refused with a sentence that no other got joins the pool, numbers and names in it left out: without
// instruments, that is how the search comes deeper into a reader.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <stdexcept>
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

#include "fuzz/mutate.hpp"
#include "fuzz/target.hpp"
#include "fuzz/watch.hpp"

namespace ritz::fuzz {
namespace {

constexpr const char* usage =
    "usage: fuzz_TARGET [--inputs N] [--seconds S] [--each S] [--stream K] [--dictionary FILE] [--left FILE] PATH...\n"
    "Runs the files PATH, or those in the folders PATH, and prints what is said of each; or, with --inputs or "
    "--seconds,\n"
    "runs them and mutations of them.\n"
    "--each S: the processor time of one input (2). --stream K: other mutations. --left FILE: where an input with a\n"
    "finding stays (finding-TARGET).\n";

struct Orders {
  std::size_t inputs = 0;
  std::optional<double> seconds;
  int each = 2;
  std::uint64_t stream = 1;
  std::string left;
  Material material;
};

std::string content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

void add_seeds(const std::filesystem::path& path, std::vector<std::string>& pool) {
  if (!std::filesystem::is_directory(path)) return pool.push_back(content(path));
  std::set<std::filesystem::path> files;  // in the same order everywhere
  for (const auto& entry : std::filesystem::directory_iterator(path))
    if (entry.is_regular_file()) files.insert(entry.path());
  for (const auto& file : files) pool.push_back(content(file));
}

Orders read_orders(int argc, char** argv) {
  Orders orders;
  orders.left = "finding-" + std::filesystem::path(argv[0]).filename().string();
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (!word.starts_with("--")) {
      add_seeds(word, orders.material.pool);
      continue;
    }
    if (++i == argc) throw std::runtime_error(word + " wants a value");
    if (word == "--inputs") orders.inputs = std::stoul(argv[i]);
    else if (word == "--seconds") orders.seconds = std::stod(argv[i]);
    else if (word == "--each") orders.each = std::stoi(argv[i]);
    else if (word == "--stream") orders.stream = std::stoul(argv[i]);
    else if (word == "--dictionary") orders.material.words = read_dictionary(argv[i]);
    else if (word == "--left") orders.left = argv[i];
    else throw std::runtime_error("there is no " + word);
  }
  if (orders.material.pool.empty()) throw std::runtime_error("there is no input to begin with");
  return orders;
}

/// What was said, without what stands in quotes and numbers.
std::string kind_of(const std::string& message) {
  std::string kind;
  bool quoted = false;
  for (const char c : message) {
    if (c == '\'') quoted = !quoted;
    else if (!quoted && (c < '0' || c > '9')) kind += c;
  }
  return kind;
}

class Search {
 public:
  explicit Search(Orders orders) : orders_(std::move(orders)), watch_(orders_.left, orders_.each) {}

  void run() {
    const auto seeds = orders_.material.pool;
    for (const auto& seed : seeds) run(seed);
    Random random(orders_.stream);
    while (goes_on()) {
      const auto input = mutated(orders_.material, random);
      if (run(input) && orders_.material.pool.size() < most_in_pool) orders_.material.pool.push_back(input);
    }
    std::fprintf(stderr, "%zu inputs, %zu refused, %zu kinds of messages, no finding\n", count_, refused_,
                 kinds_.size());
  }

 private:
  static constexpr std::size_t most_in_pool = 4096;

  bool goes_on() const {
    if (orders_.seconds) return std::chrono::duration<double>(Clock::now() - begin_).count() < *orders_.seconds;
    return count_ < orders_.inputs;
  }

  /// Whether nothing like it was said before.
  bool run(const std::string& input) {
    watch_.begin(input);
    const auto said = outcome({reinterpret_cast<const std::uint8_t*>(input.data()), input.size()});
    watch_.end(input);
    ++count_;
    if (!said.empty()) ++refused_;
    if (!orders_.seconds && orders_.inputs == 0) std::fprintf(stderr, "%s\n", said.empty() ? "accepted" : said.c_str());
    return kinds_.insert(kind_of(said)).second;
  }

  using Clock = std::chrono::steady_clock;
  Orders orders_;
  Watch watch_;
  Clock::time_point begin_ = Clock::now();
  std::size_t count_ = 0, refused_ = 0;
  std::set<std::string> kinds_;
};

/// While libraries still hold what is theirs: at exit Open MPI's plugins are gone, and nobody can tell whose it was.
bool leaks() {
#ifdef __SANITIZE_ADDRESS__
  return __lsan_do_recoverable_leak_check() != 0;
#else
  return false;
#endif
}

}  // namespace
}  // namespace ritz::fuzz

int main(int argc, char** argv) {
  using namespace ritz::fuzz;
  try {
    Search(read_orders(argc, argv)).run();
    return leaks() ? 1 : 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n%s", argv[0], error.what(), usage);
    return 2;
  }
}
