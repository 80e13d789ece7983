// Products with eight vectors at once: each non-zero of the matrix is read once for all of them.
#pragma once
#include <Eigen/Core>

#include <algorithm>

#include "ritz/algebra/multivector.hpp"

namespace ritz::algebra {

inline constexpr int panel_width = 8;

/// This rank's rows of eight vectors, row-major: the eight numbers of a row are adjacent.
using Panel = Eigen::Matrix<double, Eigen::Dynamic, panel_width, Eigen::RowMajor>;

/// Calls `op(from, to)` for each group of eight columns of x, and stores the panel `to` that it computes in the same
/// columns of y. The panels have as many rows as x and y.
template <class Op>
void each_panel(const ConstTallRef& x, TallRef y, Op op) {
  Panel from = Panel::Zero(x.rows(), panel_width), to(y.rows(), panel_width);
  for (Eigen::Index j = 0; j < x.cols(); j += panel_width) {
    const auto width = std::min<Eigen::Index>(panel_width, x.cols() - j);
    from.leftCols(width) = x.middleCols(j, width);
    op(from, to);
    y.middleCols(j, width) = to.leftCols(width);
  }
}

/// The product y = A x on panels, for an AIJ matrix, which must outlive this object and keep its pattern. The
/// communication plan is made once and stays with the matrix.
class PanelProduct {
 public:
  /// *Collective*.
  explicit PanelProduct(Mat A);

  /// *Collective*. y = A x. x and y must not be the same.
  void apply(const Panel& x, Panel& y);

  /// *Collective*. y -= A x.
  void subtract(const Panel& x, Panel& y);

  PetscInt rows() const { return rows_; }

 private:
  /// The rows of a sequential matrix, without a copy.
  struct Part {
    Mat matrix = nullptr;
    const PetscInt *starts = nullptr, *columns = nullptr;
  };

  static Part part_of(Mat A);
  void add(double sign, const Panel& x, Panel& y);

  PetscInt rows_ = 0;
  Part own_, other_;            ///< columns that this rank owns; those of other ranks
  PetscSF exchange_ = nullptr;  ///< gets the rows of x that other ranks own; owned by the matrix
  Panel ghosts_;
};

}  // namespace ritz::algebra
