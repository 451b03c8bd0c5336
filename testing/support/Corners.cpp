// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/Corners.h"

#include <cmath>
#include <numbers>

#include "testing/support/Meshes.h"

namespace palpate::test
{
namespace
{

/// p and x in millimetres. The listed x is where all l in p + sum l_i n_i = x are >= 0; |F| = 1000 N/m |x - p|.
Corner corner(const char* name, std::vector<Vec3> directions, const Vec3& p_mm, const Vec3& x_mm)
{
  for (Vec3& n : directions)
  {
    n.normalize();
  }
  return { name, std::move(directions), 1e-3 * p_mm, 1e-3 * x_mm, (x_mm - p_mm).norm() };
}

} // namespace

Vec3 Corner::start_W() const
{
  Vec3 sum = Vec3::Zero();
  for (const Vec3& n : this->normals)
  {
    sum += n;
  }
  return 5e-3 * sum.normalized();
}

std::vector<Corner> corners()
{
  const double root3 = std::sqrt(3.0);
  std::vector<Vec3> pit;
  for (int k = 0; k < 6; ++k)
  {
    const double a = k * std::numbers::pi / 3;
    pit.emplace_back(std::cos(a), std::sin(a), 1.0);
  }
  const Vec3 floor(0, 0, 1), wall(1, 0, 0);
  return {
    corner("S1 floor", { floor }, { 3, 4, -5 }, { 3, 4, 0 }),
    corner("S2 right-angled corner", { floor, wall }, { -2, 7, -3 }, { 0, 7, 0 }),
    corner("S3 cube corner", { floor, wall, { 0, 1, 0 } }, { -2, -1, -3 }, { 0, 0, 0 }),
    corner("S4 wedge of 30 degrees", { floor, { 1, 0, -root3 } }, { -4, 1, 1 }, { 0, 1, 0 }),
    corner("S5 trough of 150 degrees", { floor, { 1, 0, root3 } }, { -1, 0, -3 }, { 0, 0, 0 }),
    corner("S6 trough, one plane", { floor, { 1, 0, root3 } }, { 3, 0, -3 }, { 3, 0, 0 }),
    corner("S7 floor five times, wall", { floor, floor, floor, floor, floor, wall }, { -2, 7, -3 }, { 0, 7, 0 }),
    corner("S8 skew trihedral", { { 1, 0, 1 }, { -1, root3, 2 }, { -1, -root3, 2 } }, { 0.5, 0.2, -4 }, { 0, 0, 0 }),
    corner("S9 pit of six planes", pit, { 0.3, 0.1, -2 }, { 0, 0, 0 }),
  };
}

TriangleMesh meshOf(const Corner& corner, Random& random)
{
  TriangleMesh mesh;
  for (const Vec3& n : corner.normals)
  {
    append(mesh, makePlane(n, 0.02, 1 + static_cast<int>(random.below(5)), random));
  }
  return mesh;
}

} // namespace palpate::test
