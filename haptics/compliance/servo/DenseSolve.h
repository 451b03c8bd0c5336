// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <utility>

#include "haptics/compliance/servo/ContactProblem.h"

namespace palpate
{

/// Gauss with the largest pivot of each column; a is used up. False if it is singular to rounding. Real-time safe: for
/// the sizes of a tick a library's blocks would only need memory of their own.
[[nodiscard]] inline bool solveInPlace(ContactProblem::Square& a, ContactProblem::Numbers& b) noexcept
{
  const Eigen::Index n = b.size();
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
      std::swap(b[best], b[k]);
    }
    for (Eigen::Index i = k + 1; i < n; ++i)
    {
      a(i, k) /= a(k, k);
    }
    for (Eigen::Index j = k + 1; j < n; ++j)
    {
      a.col(j).tail(n - k - 1) -= a(k, j) * a.col(k).tail(n - k - 1);
    }
    b.tail(n - k - 1) -= b[k] * a.col(k).tail(n - k - 1);
  }
  for (Eigen::Index k = n - 1; k >= 0; --k)
  {
    b[k] /= a(k, k);
    b.head(k) -= b[k] * a.col(k).head(k);
  }
  return true;
}

} // namespace palpate
