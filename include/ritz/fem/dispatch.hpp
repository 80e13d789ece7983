// Selects the element struct for a cell type that is known only at run time.
#pragma once
#include <utility>

#include "ritz/fem/hex8.hpp"
#include "ritz/fem/tet10.hpp"
#include "ritz/fem/tet4.hpp"

namespace ritz::fem {

/// Calls `f(Tet4{})`, `f(Tet10{})` or `f(Hex8{})` and returns its result, which must have the same type for each:
///
///     visit(type, [&]<class E>(E) { return volume<E>(coordinates<E>(cell)); });
template <class F>
constexpr decltype(auto) visit(CellType type, F&& f) {
  switch (type) {
    case CellType::tet4: return std::forward<F>(f)(Tet4{});
    case CellType::tet10: return std::forward<F>(f)(Tet10{});
    case CellType::hex8: break;
  }
  return std::forward<F>(f)(Hex8{});
}

}  // namespace ritz::fem
