// Sums at vertices that several ranks contribute to.
#pragma once
#include <cstdint>
#include <span>

#include "ritz/petsc/multivector.hpp"

namespace ritz::petsc {

/// values.row(i) is added to row numbers[i] (global) of a tall matrix of which this rank owns `owned` rows; returns the
/// owned rows. *Collective*.
Tall accumulate(MPI_Comm comm, std::span<const std::int64_t> numbers, const ConstTallRef& values, int owned);

}  // namespace ritz::petsc
