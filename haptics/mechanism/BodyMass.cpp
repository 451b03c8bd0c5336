// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/BodyMass.h"

#include <cmath>

#include <Eigen/Cholesky>

#include "haptics/geometry/measure/MassMoments.h"

namespace palpate
{

EnclosedVolume enclosedBy(const TriangleMesh& mesh)
{
  if (mesh.triangles.empty())
  {
    return {};
  }
  const Vec3 from = mesh.vertices_W[mesh.triangles.front()[0]];
  const MassMoments<Mat3> moments = momentsOf<Mat3>(mesh, from, addSolid);
  const Vec3 centre = moments.weight != 0.0 ? Vec3(moments.first / moments.weight) : Vec3(Vec3::Zero());
  return { moments.weight, from + centre, moments.second - moments.weight * centre * centre.transpose() };
}

bool isValid(const BodyMass& mass)
{
  const bool moves = mass.mass_Ns2_per_u > 0.0 && std::isfinite(mass.mass_Ns2_per_u) &&
                     mass.inertia_N_s2_u.allFinite() && mass.inertia_N_s2_u.isApprox(mass.inertia_N_s2_u.transpose()) &&
                     mass.inertia_N_s2_u.llt().info() == Eigen::Success;
  return mass == BodyMass{} || moves;
}

TriangleMesh boxOf(const Vec3& halfSize_u)
{
  TriangleMesh box;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vec3 side((corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 1.0 : -1.0, (corner & 4) != 0 ? 1.0 : -1.0);
    box.vertices_W.emplace_back(side.cwiseProduct(halfSize_u));
  }
  box.triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 }, { 2, 6, 7 },
    { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } };
  return box;
}

} // namespace palpate
