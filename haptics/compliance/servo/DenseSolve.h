// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "haptics/compliance/servo/ContactProblem.h"

namespace palpate
{

/// Gaussian elimination with partial pivoting, for each column of b; a is overwritten. False if it is singular to
/// rounding. Real-time safe: at the sizes of a tick a library's blocks would only need memory of their own.
template<class Right>
[[nodiscard]] bool solveInPlace(ContactProblem::Square& a, Right& b) noexcept
{
  const Eigen::Index n = b.rows();
  const double least = n > 0 ? 1e-14 * a.cwiseAbs().maxCoeff() : 0.0;
  for (Eigen::Index k = 0; k < n; ++k)
  {
    Eigen::Index best = k;
    a.col(k).tail(n - k).cwiseAbs().maxCoeff(&best);
    best += k;
    if (std::abs(a(best, k)) <= least)
    {
      return false;
    }
    if (best != k)
    {
      a.row(best).swap(a.row(k));
      b.row(best).swap(b.row(k));
    }
    for (Eigen::Index i = k + 1; i < n; ++i)
    {
      a(i, k) /= a(k, k);
    }
    for (Eigen::Index j = k + 1; j < n; ++j)
    {
      a.col(j).tail(n - k - 1) -= a(k, j) * a.col(k).tail(n - k - 1);
    }
    for (Eigen::Index c = 0; c < b.cols(); ++c)
    {
      b.col(c).tail(n - k - 1) -= b(k, c) * a.col(k).tail(n - k - 1);
    }
  }
  for (Eigen::Index c = 0; c < b.cols(); ++c)
  {
    for (Eigen::Index k = n - 1; k >= 0; --k)
    {
      b(k, c) /= a(k, k);
      b.col(c).head(k) -= b(k, c) * a.col(k).head(k);
    }
  }
  return true;
}

} // namespace palpate
