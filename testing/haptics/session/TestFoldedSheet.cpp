// SPDX-License-Identifier: GPL-3.0-or-later
// A thin sheet that is bent back on itself, pressed by a ball or a point on its upper leaf.
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "SoftBlock.h"
#include "haptics/session/path/PathTouch.h"

namespace palpate::test
{
namespace
{

constexpr double leafOfSheet_m = 0.06, widthOfSheet_m = 0.03, thickOfSheet_m = 0.004, gapOfSheet_m = 0.012;
constexpr double sheetSpring_N_per_m = 1000.0;
constexpr double sheetTick_s = 1e-3;

/// Of a hairpin: its lower leaf lies on z = 0, its upper one above it, both end at x = leafOfSheet_m; the bend is at x
/// < 0.
SoftBodyInput hairpin(ElasticModel model, double young_Pa)
{
  constexpr int alongLeaf = 20, alongBend = 10;
  constexpr double inner_m = 0.5 * gapOfSheet_m;
  SoftBodyInput input;
  input.mesh =
    blockOf({ 2 * alongLeaf + alongBend, 8, 2 }, { 2.0 * alongLeaf + alongBend, widthOfSheet_m, thickOfSheet_m });
  input.fixed.clear();
  for (Vec3& p : input.mesh.vertices_W)
  {
    const double along = p.x(), below = p.z(); // from the outer side of the sheet
    input.fixed.push_back(along <= alongLeaf && below == 0.0);
    if (along <= alongLeaf)
    {
      p = Vec3(leafOfSheet_m * (1.0 - along / alongLeaf), p.y(), below);
    }
    else if (along >= alongLeaf + alongBend)
    {
      p = Vec3(leafOfSheet_m * (along - alongLeaf - alongBend) / alongLeaf, p.y(),
        gapOfSheet_m + 2.0 * thickOfSheet_m - below);
    }
    else
    {
      const double turned = M_PI * (along - alongLeaf) / alongBend;
      const double r = inner_m + thickOfSheet_m - below;
      p = Vec3(-r * std::sin(turned), p.y(), inner_m + thickOfSheet_m - r * std::cos(turned));
    }
  }
  input.model = model;
  input.young_Pa = { young_Pa };
  return input;
}

constexpr double topOfSheet_m = gapOfSheet_m + 2.0 * thickOfSheet_m;
constexpr int ticksOnSheet = 425;

/// Down onto the upper leaf in the first quarter of the ticks, until the ball is `deep_m` deep, and along it.
Vec3 handOnSheet(int tick, double radius_u, double deep_m)
{
  const double share = static_cast<double>(tick) / ticksOnSheet;
  const double down = std::min(1.0, 4.0 * share);
  return { 0.005 + 0.045 * share, 0.5 * widthOfSheet_m + 0.001,
    topOfSheet_m + radius_u + 0.002 - down * (0.002 + deep_m) };
}

/// Fails at each tick, until the body goes through itself, in which the hand is deeper than .1 mm without a force
/// outward. How many ticks were as deep.
int ticksPushedOutward(ElasticModel model, double young_Pa, double radius_u, double deep_m)
{
  constexpr double below_m = 1e-4;
  HapticParameters parameters;
  parameters.stiffness_N_per_m = sheetSpring_N_per_m;
  parameters.contact.radius_u = radius_u;
  PathTouch touch(nullptr, parameters, sheetTick_s);
  std::string refusal;
  auto maker = BodyMaker::make(hairpin(model, young_Pa), "sheet", 0, refusal);
  EXPECT_EQ(refusal, "");
  touch.press(std::move(maker), 30.0);
  int below = 0;
  for (int i = 0; i < ticksOnSheet; ++i)
  {
    const Vec3 hand = handOnSheet(i, radius_u, deep_m);
    const HapticState state = touch.next(sheetTick_s * i, { hand, Quat::Identity() });
    if (touch.body()->shape().throughItself_u > 0.0)
    {
      return below;
    }
    if (hand.z() < topOfSheet_m + radius_u - below_m)
    {
      ++below;
      EXPECT_GT(state.force_W.z(), 0.0) << young_Pa << " Pa, " << radius_u << " m, " << deep_m << " m, tick " << i;
    }
  }
  return below;
}

TEST(FoldedSheet, InEveryTickBelowItsSurfaceTheBallIsPushedOutward)
{
  for (const ElasticModel model : { ElasticModel::NeoHookean, ElasticModel::Linear })
  {
    for (const double young_Pa : { 50e3, 500e3 })
    {
      for (const double radius_u : { 0.005, 0.0 })
      {
        // 4 mm do not press the leaves together: none of the ticks after the first millimetres is left out.
        EXPECT_GT(ticksPushedOutward(model, young_Pa, radius_u, 0.004), 370);
        EXPECT_GT(ticksPushedOutward(model, young_Pa, radius_u, 0.016), 30);
      }
    }
  }
}

} // namespace
} // namespace palpate::test
