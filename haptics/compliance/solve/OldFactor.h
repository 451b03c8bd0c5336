// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/solve/SingleFactor.h"
#include "haptics/compliance/solve/StiffnessPattern.h"

namespace palpate
{

/// How a system was solved with the factor of another one.
struct OldFactorAnswer
{
  Eigen::VectorXd x;
  int iterations = 0;
  bool reached = false; ///< the requested size
};

/// Solves K x = b by conjugate gradients, preconditioned by the factor of a matrix that K has moved on from, until the
/// residual in the factor's own norm has fallen to a share of its initial value, in at most so many iterations; each
/// costs about one solve in single precision. What is summed up is in double precision.
[[nodiscard]] OldFactorAnswer solveByOldFactor(
  const SparseLower& k, const SingleFactor& old, const Eigen::VectorXd& b, double share, int most);

} // namespace palpate
