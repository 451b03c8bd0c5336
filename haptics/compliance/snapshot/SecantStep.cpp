// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/snapshot/SecantStep.h"

#include <cmath>

namespace palpate
{

Eigen::VectorXd loadOnPlaces(const ComplianceSnapshot& snapshot)
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
  return load;
}

void takeSecant(const Eigen::VectorXd& moved_u, ComplianceSnapshot& snapshot)
{
  const Eigen::VectorXd load = loadOnPlaces(snapshot);
  Eigen::VectorXd tangent = snapshot.compliance * load;
  const double byTangent = load.dot(tangent);
  const double bySecant = load.dot(moved_u);
  if (byTangent > 0.0 && bySecant > 0.0)
  {
    // Scaled before they are multiplied: the products are symmetric to the last bit.
    tangent /= std::sqrt(byTangent);
    const Eigen::VectorXd secant = moved_u / std::sqrt(bySecant);
    snapshot.compliance += secant * secant.transpose() - tangent * tangent.transpose();
  }
}

} // namespace palpate
