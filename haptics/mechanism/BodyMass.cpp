// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/BodyMass.h"

namespace palpate
{

EnclosedVolume enclosedBy(const TriangleMesh& mesh)
{
  EnclosedVolume sum;
  if (mesh.triangles.empty())
  {
    return sum;
  }
  const Vec3 from = mesh.vertices_W[mesh.triangles.front()[0]];
  Vec3 first_u4 = Vec3::Zero();
  for (const auto& [i, j, k] : mesh.triangles)
  {
    const Vec3 a = mesh.vertices_W[i] - from, b = mesh.vertices_W[j] - from, c = mesh.vertices_W[k] - from;
    const double volume = a.dot(b.cross(c)) / 6.0;
    const Vec3 all = a + b + c;
    sum.volume_u3 += volume;
    first_u4 += volume / 4.0 * all;
    sum.second_u5 +=
      volume / 20.0 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + all * all.transpose());
  }
  const Vec3 centre = sum.volume_u3 != 0.0 ? Vec3(first_u4 / sum.volume_u3) : Vec3(Vec3::Zero());
  sum.second_u5 -= sum.volume_u3 * centre * centre.transpose();
  sum.centre_u = from + centre;
  return sum;
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
