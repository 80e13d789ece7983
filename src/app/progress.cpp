#include "ritz/app/progress.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <iterator>
#include <sstream>

#include "ritz/base/printable.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::app {
namespace {

constexpr const char* erase_line = "\r\033[K";

std::string date() {
  const std::time_t now = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S", std::localtime(&now));
  return text;
}

bool is_terminal(const char* path) {
  const int file = open(path, O_WRONLY | O_NOCTTY);
  const bool terminal = file >= 0 && isatty(file);
  if (file >= 0) close(file);
  return terminal;
}

constexpr const char* mark_of_rank = "OMPI_COMM_WORLD_SIZE";  ///< in the environment of all that mpirun starts

/// What stands in a file of /proc; nothing if it cannot be read.
std::string process_file(pid_t process, const char* name) {
  std::ifstream in("/proc/" + std::to_string(process) + '/' + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// 0 if it is not known.
pid_t parent_of(pid_t process) {
  const auto stat = process_file(process, "stat");  // "7 (name) S 6 ...", whose name may hold anything
  std::istringstream rest(stat.substr(std::min(stat.size(), stat.rfind(')') + 1)));
  std::string state;
  pid_t parent = 0;
  rest >> state >> parent;
  return parent;
}

/// mpirun gives every rank a terminal of its own, so what counts under it is where mpirun itself writes to. Between the
/// two there may be others, such as a shell.
bool writes_to_terminal() {
  if (!isatty(STDOUT_FILENO)) return false;
  if (!std::getenv(mark_of_rank)) return true;
  pid_t process = getppid();
  while (process > 1 && process_file(process, "environ").find(mark_of_rank) != std::string::npos)
    process = parent_of(process);
  return is_terminal(("/proc/" + std::to_string(process) + "/fd/1").c_str());
}

double since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Progress::Progress(MPI_Comm comm, Voice voice)
    : comm_(comm), terminal_(writes_to_terminal()), root_(parallel::rank(comm) == 0) {
  speaks_ = root_ && voice != Voice::quiet;
}

Progress::Timer::Timer(Progress& p, const std::string& stage)
    : progress(p), name(stage), exceptions(std::uncaught_exceptions()) {
  progress.running_ = name;
  progress.started_ = start;
  progress.update("", 0);
}

Progress::Timer::~Timer() {
  const double seconds = since(start);
  if (progress.speaks_ && progress.terminal_) std::printf("%s", erase_line);
  if (std::uncaught_exceptions() > exceptions) return;
  progress.seconds_.push_back({name, seconds});
  const auto text = formatted("%-12s %8.2f s", name.c_str(), seconds);
  progress.line(progress.terminal_ ? text : date() + "  " + text);
}

void Progress::update(const std::string& what, double fraction) {
  if (!speaks_ || !terminal_) return;
  const double seconds = since(started_);
  std::printf("%s%s%s%s  %3.0f %%  %.0f s", erase_line, running_.c_str(), what.empty() ? "" : ": ", what.c_str(),
              100 * fraction, seconds);
  if (fraction > 0.05) std::printf(", about %.0f s left", seconds * (1 - fraction) / fraction);
  std::fflush(stdout);
}

void Progress::line(const std::string& text) const {
  if (!speaks_) return;
  std::printf("%s\n", text.c_str());
  std::fflush(stdout);
}

void Progress::warn(const std::string& text) {
  if (std::ranges::find(warnings_, text) != warnings_.end()) return;
  warnings_.push_back(text);
  if (!root_) return;
  if (speaks_ && terminal_) std::printf("%s", erase_line);
  std::fflush(stdout);
  std::fprintf(stderr, "warning: %s\n", printable(text).c_str());
}

}  // namespace ritz::app
