#include "ritz/app/main_guard.hpp"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <new>
#include <thread>

#include "ritz/base/error.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::app {
namespace {

using namespace std::chrono_literals;

/// Whether every rank comes here in time.
bool all_arrive(MPI_Comm comm) {
  MPI_Request request;
  MPI_Ibarrier(comm, &request);
  const auto limit = std::chrono::steady_clock::now() + 5s;
  for (int arrived = 0; std::chrono::steady_clock::now() < limit; std::this_thread::sleep_for(2ms)) {
    MPI_Test(&request, &arrived, MPI_STATUS_IGNORE);
    if (arrived) return true;
  }
  return false;
}

int answer(MPI_Comm comm, const std::string& program, const char* message, int code) {
  const bool together = all_arrive(comm);
  if (!together || parallel::rank(comm) == 0) {
    std::fflush(stdout);
    std::fprintf(stderr, "%s: %s\n", program.c_str(), message);
    std::fflush(stderr);
  }
  if (!together) MPI_Abort(comm, code);
  return code;
}

}  // namespace

int guarded(MPI_Comm comm, const std::string& program, const std::function<void()>& work) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is a write that fails, as on a full disk
  try {
    work();
    MPI_Barrier(comm);
    return exit_done;
  } catch (const InputError& e) {
    return answer(comm, program, e.what(), exit_input);
  } catch (const std::bad_alloc&) {
    return answer(comm, program, "memory ran out; use more ranks or machines, or -solver iterative", exit_numerical);
  } catch (const std::exception& e) {
    return answer(comm, program, e.what(), exit_numerical);
  }
}

}  // namespace ritz::app
