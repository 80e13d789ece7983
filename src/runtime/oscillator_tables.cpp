#include "oscillator_tables.hpp"

#include <cmath>

#include "ritz/runtime/integrator.hpp"

namespace ritz::runtime {
namespace {

using Eigen::Index;

/// The coefficients of all oscillators as History's columns c, j of A, then b, then c.
template <class Scalar>
void tabulate(const Model<Scalar>& model, const Integrator& integrator, StepKind kind, double dt,
              Matrix<Scalar>& table) {
  const auto& stiffness = std::get<LinearForce<Scalar>>(model.force).stiffness;
  const auto& damping = std::get<Vector<Scalar>>(model.damping);
  const int width = history_size(integrator.history);
  for (Index i = 0; i < model.size(); ++i) {
    const auto step = oscillator_step(integrator, kind, double(stiffness[i]), double(damping[i]), dt);
    for (int c = 0; c < width; ++c) {
      for (int j = 0; j < width; ++j) table(i, c * width + j) = Scalar(step.A(c, j));
      table(i, width * width + c) = Scalar(step.b[c]);
      table(i, width * (width + 1) + c) = Scalar(step.c[c]);
    }
  }
}

template <class Scalar>
void prepare(const Model<Scalar>& model, const Integrator& integrator, Scalar dt, OscillatorTables<Scalar>& tables) {
  const auto& stiffness = std::get<LinearForce<Scalar>>(model.force).stiffness;
  if (model.size() > 0) refuse_unstable(integrator, std::sqrt(double(stiffness.maxCoeff())), double(dt));
  tabulate(model, integrator, StepKind::later, double(dt), tables.step);
  if (integrator.start) tabulate(model, integrator, StepKind::first, double(dt), tables.start);
  tables.dt = dt;
}

template <class Scalar>
void differentiate(const Matrix<Scalar>& table, Index width, StepDerivative<Scalar>& derivative) {
  const Index r = table.rows();
  const auto diagonal = [&](Matrix<Scalar>& matrix, Index row, Index column, Index of) {
    matrix.block(row * r, column * r, r, r).diagonal() = table.col(of);
  };
  for (auto* matrix : {&derivative.state, &derivative.begin, &derivative.end}) matrix->setZero();
  for (Index c = 0; c < width; ++c) {
    for (Index j = 0; j < width; ++j) diagonal(derivative.state, c, j, c * width + j);
    diagonal(derivative.begin, c, 0, width * width + c);
    diagonal(derivative.end, c, 0, width * (width + 1) + c);
  }
}

}  // namespace

template <class Scalar>
OscillatorTables<Scalar> make_tables(const Model<Scalar>& model, const Integrator& integrator, Scalar dt) {
  const int width = history_size(integrator.history);
  const Matrix<Scalar> none = Matrix<Scalar>::Zero(model.size(), width * (width + 2));
  OscillatorTables<Scalar> tables{
      .step = none, .start = integrator.start ? none : Matrix<Scalar>{}, .next = none.leftCols(width)};
  prepare(model, integrator, dt, tables);
  return tables;
}

template <class Scalar>
Outcome step_from_tables(const Model<Scalar>& model, State<Scalar>& state, const StepLoad<Scalar>& load, Scalar dt,
                         const Integrator& integrator, OscillatorTables<Scalar>& tables,
                         StepDerivative<Scalar>* derivative) {
  if (dt != tables.dt) prepare(model, integrator, dt, tables);
  const auto& table = integrator.start && state.last_dt != dt ? tables.start : tables.step;
  const Index width = tables.next.cols();
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  Outcome outcome{.work = unknown, .dissipated = unknown};
  for (Index c = 0; c < width; ++c) {
    auto next = tables.next.col(c).array();
    next = table.col(width * width + c).array() * load.begin.array() +
           table.col(width * (width + 1) + c).array() * load.end.array();
    for (Index j = 0; j < width; ++j) next += table.col(c * width + j).array() * state.history.col(j).array();
  }
  if (!tables.next.allFinite()) {
    outcome.status = Status::not_finite;
    return outcome;
  }
  if (derivative) differentiate(table, width, *derivative);
  state.history.swap(tables.next);
  state.last_dt = dt;
  return outcome;
}

#define RITZ_INSTANCE(S)                                                                                  \
  template OscillatorTables<S> make_tables(const Model<S>&, const Integrator&, S);                        \
  template Outcome step_from_tables(const Model<S>&, State<S>&, const StepLoad<S>&, S, const Integrator&, \
                                    OscillatorTables<S>&, StepDerivative<S>*);
RITZ_INSTANCE(double)
RITZ_INSTANCE(float)
#undef RITZ_INSTANCE

}  // namespace ritz::runtime
