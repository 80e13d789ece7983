// The product of a tall row-major matrix and a vector, at the speed at which memory delivers the matrix.
#pragma once
#include <cstddef>

namespace ritz::runtime {

/// y = A x for a row-major A, rows x columns. None of the arrays needs an alignment.
void multiply_rows(const double* A, std::ptrdiff_t rows, std::ptrdiff_t columns, const double* x, double* y);

}  // namespace ritz::runtime
