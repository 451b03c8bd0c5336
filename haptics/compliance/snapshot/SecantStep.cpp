// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/snapshot/SecantStep.h"

#include <cmath>

namespace palpate
{

void takeSecant(const std::vector<Vec3>& beyond_u, ComplianceSnapshot& snapshot)
{
  Eigen::VectorXd load = Eigen::VectorXd::Zero(snapshot.compliance.rows());
  for (std::size_t i = 0; i < snapshot.forceAt.size(); ++i)
  {
    const SurfacePoint& at = snapshot.forceAt[i];
    for (int c = 0; c < 3; ++c)
    {
      load.segment<3>(3 * snapshot.placeOf[at.vertices[c]]) += at.weights[c] * snapshot.force_N[i];
    }
  }
  Eigen::VectorXd tangent = snapshot.compliance * load;
  Eigen::VectorXd secant = tangent;
  for (std::size_t i = 0; i < snapshot.near.size(); ++i)
  {
    secant.segment<3>(3 * static_cast<Eigen::Index>(i)) += beyond_u[snapshot.near[i]];
  }
  const double byTangent = load.dot(tangent);
  const double bySecant = load.dot(secant);
  if (byTangent > 0.0 && bySecant > 0.0)
  {
    // Scaled before they are multiplied: the products are symmetric to the last bit.
    tangent /= std::sqrt(byTangent);
    secant /= std::sqrt(bySecant);
    snapshot.compliance += secant * secant.transpose() - tangent * tangent.transpose();
  }
}

} // namespace palpate
