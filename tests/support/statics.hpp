// Static answers of the full model: K u = f.
#pragma once
#include "support/problem.hpp"

namespace ritz::test {

/// The consistent forces of a uniform traction on a set's faces with the given total (N), rows of free degrees of
/// freedom. *Collective*.
algebra::Tall end_traction(const Problem& p, const std::string& set, const Eigen::Vector3d& total);

/// u = K⁻¹ f. *Collective*.
algebra::Tall solve(const Problem& p, const algebra::Tall& force);

/// fᵀu: for a unit total traction the mean displacement of the loaded faces along it. *Collective*.
double work(const Problem& p, const algebra::Tall& force, const algebra::Tall& u);

}  // namespace ritz::test
