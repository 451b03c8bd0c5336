// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/solve/SingleFactor.h"
#include "haptics/compliance/solve/StiffnessPattern.h"

namespace palpate
{

/// The solution of a system with the factor of another one.
struct OldFactorAnswer
{
  Eigen::VectorXd x;
  int iterations = 0;
  bool reached = false; ///< whether the residual has the requested size
};

/// Solves K x = b by conjugate gradients, preconditioned by the factor of an earlier matrix, until the
/// residual in the factor's own norm has fallen to a share of its initial value, in at most `most` iterations; each
/// costs about one solve in single precision. Sums are in double precision.
[[nodiscard]] OldFactorAnswer solveByOldFactor(
  const SparseLower& k, const SingleFactor& old, const Eigen::VectorXd& b, double share, int most);

} // namespace palpate
