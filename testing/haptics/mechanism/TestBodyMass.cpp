// SPDX-License-Identifier: GPL-3.0-or-later
// The mass of a body is that of its volume.
#include <cmath>

#include <gtest/gtest.h>

#include "LooseScenes.h"

namespace palpate::test
{
namespace
{

TEST(BodyMass, OfAMeshIsThatOfTheBoxThatItIsWhereverItsFrameIs)
{
  const Vec3 half(0.3, 0.2, 0.1), aside(5.0, -3.0, 2.0);
  const double mass = 700.0 * 8.0 * half.prod();
  MechanismBody body;
  body.kind = MechanismBodyKind::Rigid;
  TriangleMesh mesh = boxOf(half);
  const Quat turn = turnedBy(0.7, Vec3(1, 2, 3));
  std::ranges::for_each(mesh.vertices_W, [&](Vec3& p) { p = aside + turn * p; });
  body.mesh = heldMesh(mesh);
  body.pose_W = { Vec3(1, 0, 0), turnedBy(0.4, Vec3(0, 1, 1)) };
  const Vec3 centre_W = body.pose_W * aside;
  const MassGiven given = giveMass(body, 700.0, 1.0);
  EXPECT_EQ(given.refusal, "");
  EXPECT_LE((given.centre_u - aside).norm(), 1e-12);
  EXPECT_LE((body.pose_W.p - centre_W).norm(), 1e-12);
  EXPECT_NEAR(body.mass.mass_Ns2_per_u, mass, 1e-10 * mass);
  const Vec3 square = half.cwiseAbs2();
  const Vec3 own = mass / 3.0 * Vec3(square.y() + square.z(), square.z() + square.x(), square.x() + square.y());
  const Mat3 r = turn.toRotationMatrix();
  EXPECT_LE((body.mass.inertia_N_s2_u - r * own.asDiagonal() * r.transpose()).norm(), 1e-10 * own.norm());
}

TEST(BodyMass, IsCountedInUnitsOfTheScene)
{
  MechanismBody metres, millimetres;
  metres.kind = millimetres.kind = MechanismBodyKind::Rigid;
  metres.halfSize_u = stoneHalf_m;
  millimetres.halfSize_u = 1e3 * stoneHalf_m;
  EXPECT_EQ(giveMass(metres, stone_kg_per_m3, 1.0).refusal + giveMass(millimetres, stone_kg_per_m3, 1e-3).refusal, "");
  // A newton gives a kilogram 1 m/s^2 = 1,000 mm/s^2, and 1 N m = 1,000 N mm the same spin.
  EXPECT_NEAR(millimetres.mass.mass_Ns2_per_u, 1e-3 * metres.mass.mass_Ns2_per_u, 1e-12);
  EXPECT_LE((millimetres.mass.inertia_N_s2_u - 1e3 * metres.mass.inertia_N_s2_u).norm(), 1e-12);
}

TEST(BodyMass, IsRefusedWithoutDensityOrVolume)
{
  for (const double density : { 0.0, -1.0, std::nan(""), 1e9 })
  {
    MechanismBody body;
    body.kind = MechanismBodyKind::Rigid;
    body.halfSize_u = stoneHalf_m;
    EXPECT_NE(giveMass(body, density, 1.0).refusal.find("above 0"), std::string::npos) << density;
    EXPECT_FALSE(isLoose(body)) << density;
  }
  MechanismBody flat;
  flat.kind = MechanismBodyKind::Rigid;
  flat.halfSize_u = Vec3(1.0, 1.0, 0.0);
  EXPECT_NE(giveMass(flat, 1.0, 1.0).refusal.find("no volume"), std::string::npos);
}

} // namespace
} // namespace palpate::test
