// The BLAS that is loaded: which one, its threads, its kernels and its memory.
#pragma once
#include <string>

namespace ritz::algebra {

/// The BLAS that is loaded: "OpenBLAS 0.3.21 ..." or "unknown (the reference BLAS is several times slower)".
std::string loaded_blas();
bool blas_is_openblas();

/// Limits the BLAS to one thread on each rank, unless OPENBLAS_NUM_THREADS or OMP_NUM_THREADS says otherwise.
void limit_blas_threads();

/// The first call of main. What OpenBLAS reads from environment variables it reads as it is loaded; where one is
/// missing, the program sets it and starts itself again. One asks for kernels: for a processor younger than itself
/// OpenBLAS takes those of the oldest, several times slower than what AVX2 or AVX-512 allow (OPENBLAS_CORETYPE, which a
/// user may set himself). Others ask for one thread where the address space is limited (ulimit -v): each thread of
/// OpenBLAS maps 128 MB, and if that fails, retries for ever and cannot be ended with the program.
void restart_with_fitting_blas(char** argv);

/// Makes the BLAS allocate its work space now, which it keeps: 128 MB of address space, none of which becomes resident.
/// If memory ran out in its first call, OpenBLAS would retry for ever; so it is checked first that there is enough.
/// Throws std::bad_alloc.
void take_blas_memory();

}  // namespace ritz::algebra
