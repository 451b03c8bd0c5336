// SPDX-License-Identifier: GPL-3.0-or-later
// Row 57: a hand that presses a tool smoothly and evenly feels nothing that is faster than itself, and no torque.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "Tools.h"
#include "haptics/tool/servo/ToolForce.h"

namespace palpate::test
{
namespace
{

constexpr double smoothTick_s = 1e-3, smoothStiffness_N_per_m = 1000.0, halfOfSmooth_m = 0.01;
constexpr int smoothTicks = 1000;

/// A pyramid with so many sides and its tip downwards, about its axis the same from all of them.
TriangleMesh pyramid(int sides)
{
  TriangleMesh mesh;
  mesh.vertices_W = { Vec3(0, 0, -halfOfSmooth_m), Vec3(0, 0, halfOfSmooth_m) };
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2.0 * std::numbers::pi * i / sides;
    mesh.vertices_W.emplace_back(halfOfSmooth_m * std::cos(angle), halfOfSmooth_m * std::sin(angle), halfOfSmooth_m);
    const auto a = static_cast<std::uint32_t>(2 + i), b = static_cast<std::uint32_t>(2 + (i + 1) % sides);
    mesh.triangles.push_back({ 0, a, b });
    mesh.triangles.push_back({ 1, b, a });
  }
  return mesh;
}

/// A square hole between four blocks, into which the pyramid sinks until its flanks lie against the rims.
TriangleMesh squareHole(double half)
{
  TriangleMesh mesh = makeBox(Vec3(-0.05, -0.05, -0.05), Vec3(-half, 0.05, 0.0));
  append(mesh, makeBox(Vec3(half, -0.05, -0.05), Vec3(0.05, 0.05, 0.0)));
  append(mesh, makeBox(Vec3(-half, -0.05, -0.05), Vec3(half, -half, 0.0)));
  append(mesh, makeBox(Vec3(-half, half, -0.05), Vec3(half, 0.05, 0.0)));
  return mesh;
}

/// How much of the energy of a signal, its mean aside, lies in waves that are faster: by sums of sines and cosines.
double shareAbove(const std::vector<double>& signal, double rate_Hz)
{
  double fast = 0.0, all = 0.0;
  const auto n = static_cast<double>(signal.size());
  for (std::size_t k = 1; k < signal.size() / 2; ++k)
  {
    double sine = 0.0, cosine = 0.0;
    for (std::size_t i = 0; i < signal.size(); ++i)
    {
      const double phase = 2.0 * std::numbers::pi * static_cast<double>(k * i) / n;
      sine += signal[i] * std::sin(phase);
      cosine += signal[i] * std::cos(phase);
    }
    const double energy = sine * sine + cosine * cosine;
    all += energy;
    fast += static_cast<double>(k) / (n * smoothTick_s) > rate_Hz ? energy : 0.0;
  }
  return fast / all;
}

void expectSmooth(const TriangleMesh& toolMesh, const TriangleMesh& sceneMesh, double touches_m)
{
  const ToolMesh tool = makeTool(toolMesh, Vec3(Vec3::Zero())).value;
  ToolMove move(tool, makeToolScene(cleanMesh(sceneMesh).mesh, tool), tool.gyration_u);
  ASSERT_EQ(move.place({ Vec3(0, 0, touches_m + 0.005), Quat::Identity() }), "");
  std::vector<double> force_N;
  double torque_Nm = 0.0;
  for (int i = 0; i < smoothTicks; ++i)
  {
    // In and out again twice a second, always in contact: 1 to 3 mm deep.
    const double deep_m = 0.002 - 0.001 * std::cos(4.0 * std::numbers::pi * i * smoothTick_s);
    const Pose hand_W{ Vec3(0, 0, touches_m - deep_m), Quat::Identity() };
    move.update(hand_W, plenty);
    const ToolPush push = toolPush(move.contacts(), hand_W, smoothStiffness_N_per_m, ToolCoupling::Constraints);
    EXPECT_LE(push.wrench_W.force.head<2>().norm(), 1e-6);
    force_N.push_back(push.wrench_W.force.z());
    torque_Nm = std::max(torque_Nm, push.wrench_W.torque.norm());
  }
  EXPECT_LE(torque_Nm, 1e-6);
  EXPECT_LE(shareAbove(force_N, 30.0), 0.01);
  const auto [least, most] = std::minmax_element(force_N.begin(), force_N.end());
  EXPECT_NEAR(*least, smoothStiffness_N_per_m * 0.001, 1e-3);
  EXPECT_NEAR(*most, smoothStiffness_N_per_m * 0.003, 1e-3);
}

} // namespace

TEST(SmoothTool, ACubeAndAPyramidOnItsTipOnAWallFeelNoTorqueAndNothingFastRow57)
{
  Random random(testSeed(5701));
  const TriangleMesh wall = makeSheet({ 0.1, 0.1, 8, 8, 0.3 }, random);
  expectSmooth(makeBox(Vec3::Constant(-halfOfSmooth_m), Vec3::Constant(halfOfSmooth_m)), wall, halfOfSmooth_m);
  expectSmooth(pyramid(8), wall, halfOfSmooth_m);
}

TEST(SmoothTool, APyramidInASquareHoleFeelsNoTorqueAndNothingFastRow57)
{
  // Four sides at 45 degrees to the axes have edges over the rims' middles: they rest where the tip is halfOfSmooth_m
  // beneath the place at which the pyramid is as wide as the hole.
  constexpr double hole_m = 0.004;
  expectSmooth(pyramid(4), squareHole(hole_m), halfOfSmooth_m - 2.0 * hole_m);
}

} // namespace palpate::test
