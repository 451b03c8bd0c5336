// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/material/PrincipalStretches.h"

#include <Eigen/SVD>

namespace palpate
{

PrincipalStretches principalStretches(const Mat3& f)
{
  const Eigen::JacobiSVD<Mat3> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
  PrincipalStretches stretches{ svd.matrixU(), svd.singularValues(), svd.matrixV() };
  if (stretches.u.determinant() < 0.0)
  {
    stretches.u.col(2) *= -1.0;
    stretches.s[2] *= -1.0;
  }
  if (stretches.v.determinant() < 0.0)
  {
    stretches.v.col(2) *= -1.0;
    stretches.s[2] *= -1.0;
  }
  return stretches;
}

} // namespace palpate
