#include "ritz/algebra/panel.hpp"

#include "ritz/algebra/check.hpp"
#include "ritz/algebra/handle.hpp"

namespace ritz::algebra {
namespace {

/// One row's eight numbers as an MPI type.
MPI_Datatype row_type() {
  static const MPI_Datatype type = [] {
    MPI_Datatype made = MPI_DATATYPE_NULL;
    MPI_Type_contiguous(panel_width, MPI_DOUBLE, &made);
    MPI_Type_commit(&made);
    return made;
  }();
  return type;
}

/// y += sign A x, rows of eight. Compiled for wide registers too, and chosen at run time.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
__attribute__((target_clones("arch=x86-64-v3", "default")))
#endif
void add_product(PetscInt rows, const PetscInt* starts, const PetscInt* columns, const PetscScalar* values, double sign,
                 const double* x, double* y) {
  for (PetscInt i = 0; i < rows; ++i) {
    double sum[panel_width] = {};
    for (PetscInt k = starts[i]; k < starts[i + 1]; ++k) {
      const double* from = x + panel_width * static_cast<std::ptrdiff_t>(columns[k]);
      for (int c = 0; c < panel_width; ++c) sum[c] += values[k] * from[c];
    }
    double* to = y + panel_width * static_cast<std::ptrdiff_t>(i);
    for (int c = 0; c < panel_width; ++c) to[c] += sign * sum[c];
  }
}

/// What the ranks exchange for products with A: made at the first, then kept in A.
PetscSF exchange(Mat A, PetscInt ghosts, const PetscInt* columns) {
  constexpr const char* key = "ritz_panel_exchange";
  const auto object = reinterpret_cast<PetscObject>(A);
  PetscObject kept = nullptr;
  check(PetscObjectQuery(object, key, &kept));
  if (kept) return reinterpret_cast<PetscSF>(kept);
  StarForest made;
  PetscLayout layout = nullptr;
  check(MatGetLayouts(A, nullptr, &layout));
  check(PetscSFCreate(PetscObjectComm(object), made.out()));
  check(PetscSFSetGraphLayout(made, layout, ghosts, nullptr, PETSC_COPY_VALUES, columns));
  check(PetscSFSetUp(made));
  check(PetscObjectCompose(object, key, reinterpret_cast<PetscObject>(made.get())));
  return made;
}

}  // namespace

PanelProduct::Part PanelProduct::part_of(Mat A) {
  Part part{A};
  PetscInt rows = 0;
  PetscBool done = PETSC_FALSE;
  check(MatGetRowIJ(A, 0, PETSC_FALSE, PETSC_FALSE, &rows, &part.starts, &part.columns, &done));
  return part;
}

PanelProduct::PanelProduct(Mat A) {
  const MPI_Comm comm = comm_of(A);
  PetscMPIInt ranks = 1;
  MPI_Comm_size(comm, &ranks);
  check(MatGetLocalSize(A, &rows_, nullptr));
  if (ranks == 1) {
    own_ = part_of(A);
    return;
  }
  Mat own = nullptr, other = nullptr;
  const PetscInt* ghost_columns = nullptr;
  PetscInt ghosts = 0;
  check(MatMPIAIJGetSeqAIJ(A, &own, &other, &ghost_columns));
  own_ = part_of(own);
  other_ = part_of(other);
  check(MatGetSize(other, nullptr, &ghosts));
  exchange_ = exchange(A, ghosts, ghost_columns);
  ghosts_.resize(ghosts, panel_width);
}

void PanelProduct::add(double sign, const Panel& x, Panel& y) {
  const auto run = [&](const Part& part, const Panel& from) {
    const PetscScalar* values = nullptr;
    check(MatSeqAIJGetArrayRead(part.matrix, &values));
    add_product(rows_, part.starts, part.columns, values, sign, from.data(), y.data());
    check(MatSeqAIJRestoreArrayRead(part.matrix, &values));
  };
  if (exchange_) check(PetscSFBcastBegin(exchange_, row_type(), x.data(), ghosts_.data(), MPI_REPLACE));
  run(own_, x);
  if (!exchange_) return;
  check(PetscSFBcastEnd(exchange_, row_type(), x.data(), ghosts_.data(), MPI_REPLACE));
  run(other_, ghosts_);
}

void PanelProduct::apply(const Panel& x, Panel& y) {
  y.setZero(rows_, panel_width);
  add(1, x, y);
}

void PanelProduct::subtract(const Panel& x, Panel& y) { add(-1, x, y); }

}  // namespace ritz::algebra
