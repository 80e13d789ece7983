#include "ritz/parallel/guard.hpp"

#include <new>
#include <string>

#include "ritz/base/error.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::parallel {
namespace {

enum Outcome : int { fine = 0, input = 1, numerical = 2 };

struct Caught {
  int outcome = fine;
  int reason = static_cast<int>(Reason::stated);
  std::string message;
};

Caught run(const std::function<void()>& work) {
  try {
    work();
    return {};
  } catch (const InputError& e) {
    return {input, static_cast<int>(e.reason), e.what()};
  } catch (const NumericalError& e) {
    return {numerical, static_cast<int>(e.reason), e.what()};
  } catch (const std::bad_alloc&) {
    return {.outcome = numerical, .message = "memory ran out; use more ranks or machines, or fewer modes"};
  } catch (const std::exception& e) {
    return {.outcome = numerical, .message = e.what()};
  }
}

}  // namespace

void together(MPI_Comm comm, const std::function<void()>& work) {
  Caught mine = run(work);
  const int ranks = size(comm);
  const int here = mine.outcome == fine ? ranks : rank(comm);
  const int first = min(comm, here);
  if (first == ranks) return;
  MPI_Bcast(&mine.outcome, 1, MPI_INT, first, comm);
  MPI_Bcast(&mine.reason, 1, MPI_INT, first, comm);
  broadcast(comm, mine.message, first);
  const auto reason = static_cast<Reason>(mine.reason);
  if (mine.outcome == input) throw InputError(mine.message, reason);
  throw NumericalError(mine.message, reason);
}

void on_root(MPI_Comm comm, const std::function<void()>& work) {
  together(comm, [&] {
    if (rank(comm) == 0) work();
  });
}

}  // namespace ritz::parallel
