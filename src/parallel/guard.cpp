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
  std::string message;
};

Caught run(const std::function<void()>& work) {
  try {
    work();
    return {};
  } catch (const InputError& e) {
    return {input, e.what()};
  } catch (const std::bad_alloc&) {
    return {numerical, "memory ran out; use more ranks or machines, or fewer modes"};
  } catch (const std::exception& e) {
    return {numerical, e.what()};
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
  broadcast(comm, mine.message, first);
  if (mine.outcome == input) throw InputError(mine.message);
  throw NumericalError(mine.message);
}

void on_root(MPI_Comm comm, const std::function<void()>& work) {
  together(comm, [&] {
    if (rank(comm) == 0) work();
  });
}

}  // namespace ritz::parallel
