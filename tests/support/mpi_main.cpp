// The main of tests that run on several ranks: one report (rank 0's), one verdict (any rank's failure fails all).
#include <gtest/gtest.h>
#include <mpi.h>
#include <slepceps.h>
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

#include "support/unwatched.hpp"
#include "support/verdict.hpp"

namespace {

/// Prints failures of ranks other than 0, which have no other voice.
struct FailurePrinter : testing::EmptyTestEventListener {
  int rank;
  explicit FailurePrinter(int r) : rank(r) {}
  void OnTestPartResult(const testing::TestPartResult& result) override {
    if (!result.failed()) return;
    std::fprintf(stderr, "rank %d: %s:%d: %s\n", rank, result.file_name() ? result.file_name() : "?",
                 result.line_number(), result.message());
  }
};

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const int started = ritz::test::unwatched([&] { return SlepcInitialize(&argc, &argv, nullptr, nullptr); });
  if (started != 0) return 1;
  PetscPopSignalHandler();
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank != 0) {
    auto& listeners = testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new FailurePrinter(rank));
  }
  int failed = RUN_ALL_TESTS();
#ifdef __SANITIZE_ADDRESS__
  // Here MPI and PETSc still hold what they own; at exit Open MPI's plugins are gone, and nobody can tell whose it was.
  if (__lsan_do_recoverable_leak_check() != 0) failed = 1;
#endif
  MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  SlepcFinalize();
  return ritz::test::verdict(failed);
}
