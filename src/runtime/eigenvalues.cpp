#include "eigenvalues.hpp"

#include <Eigen/Eigenvalues>

namespace ritz::runtime {

Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric, const Eigen::MatrixXd& mass) {
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, mass, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

}  // namespace ritz::runtime
