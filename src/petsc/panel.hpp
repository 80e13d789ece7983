// Eight vectors side by side: a matrix product reads each of its non-zeros once for all of them.
#pragma once
#include <Eigen/Core>

#include <algorithm>

#include "ritz/petsc/multivector.hpp"

namespace ritz::petsc {

inline constexpr int panel_width = 8;

/// This rank's rows of eight vectors, one row's eight numbers after the other.
using Panel = Eigen::Matrix<double, Eigen::Dynamic, panel_width, Eigen::RowMajor>;

/// Calls `op(from, to)`, panels that fit x and y, for each eight columns of x and stores what it leaves in `to`.
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

/// y = A x on panels, for an AIJ matrix, which must outlive this and keep its pattern. The plan of what ranks exchange
/// is made once and stays with the matrix.
class PanelProduct {
 public:
  /// *Collective*.
  explicit PanelProduct(Mat A);

  /// y = A x. x and y must not be the same. *Collective*.
  void apply(const Panel& x, Panel& y);

  /// y -= A x. *Collective*.
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
  PetscSF exchange_ = nullptr;  ///< brings the rows of x that other ranks own; the matrix holds it
  Panel ghosts_;
};

}  // namespace ritz::petsc
