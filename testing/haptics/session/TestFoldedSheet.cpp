// SPDX-License-Identifier: GPL-3.0-or-later
// A thin sheet that is bent back on itself, pressed by a ball on its upper leaf.
#include <cmath>
#include <memory>
#include <sstream>

#include <gtest/gtest.h>

#include "SoftBlock.h"
#include "haptics/session/PathTouch.h"

namespace palpate::test
{
namespace
{

constexpr double leafOfSheet_m = 0.06, widthOfSheet_m = 0.03, thickOfSheet_m = 0.004, gapOfSheet_m = 0.012;
constexpr double sheetSpring_N_per_m = 1000.0;
constexpr double sheetTick_s = 1e-3;

/// Of a hairpin: its lower leaf lies on z = 0, its upper one above it, both end at x = leafOfSheet_m; the bend is at x < 0.
SoftBodyInput hairpin(ElasticModel model, double young_Pa)
{
  constexpr int alongLeaf = 20, alongBend = 10;
  constexpr double inner_m = 0.5 * gapOfSheet_m;
  SoftBodyInput input;
  input.mesh = blockOf({ 2 * alongLeaf + alongBend, 8, 2 }, { 2.0 * alongLeaf + alongBend, widthOfSheet_m, thickOfSheet_m });
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
      p = Vec3(leafOfSheet_m * (along - alongLeaf - alongBend) / alongLeaf, p.y(), gapOfSheet_m + 2.0 * thickOfSheet_m - below);
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

TEST(FoldedSheet, DISABLED_Experiment)
{
  for (const ElasticModel model : { ElasticModel::NeoHookean, ElasticModel::Linear })
  {
    for (const double young_Pa : { 50e3, 500e3 })
    for (const double radius_u : { 0.005, 0.0 })
    for (const double deep_m : { 0.004, 0.008, 0.016 })
    for (const double rate_Hz : { 30.0 })
    {
      HapticParameters parameters;
      parameters.stiffness_N_per_m = sheetSpring_N_per_m;
      parameters.contact.radius_u = radius_u;
      PathTouch touch(nullptr, parameters, sheetTick_s);
      std::string refusal;
      auto maker = BodyMaker::make(hairpin(model, young_Pa), "sheet", 0, refusal);
      ASSERT_EQ(refusal, "");
      touch.press(std::move(maker), rate_Hz);
      const double top = gapOfSheet_m + 2.0 * thickOfSheet_m + radius_u;
      const int ticks = rate_Hz > 0.0 ? 425 : 40;
      int none = 0, inward = 0, through = 0, shown = 0;
      std::string trace;
      for (int i = 0; i < ticks; ++i)
      {
        const double s = static_cast<double>(i) / ticks;
        const double down = std::min(1.0, 4.0 * s);
        const Vec3 hand(0.005 + 0.045 * s, 0.5 * widthOfSheet_m + 0.001, top + 0.002 - down * (0.002 + deep_m));
        const HapticState state = touch.next(sheetTick_s * i, { hand, Quat::Identity() });
        const bool into = hand.z() < top - 1e-4;
        through += touch.body()->shape().throughItself_u > 0.0;
        const bool bad = into && (state.force_W.norm() < 1e-9 || state.force_W.z() < -1e-9);
        if (bad && ++shown < 4)
        {
          std::ostringstream o;
          o << "   BAD tick " << i << " x " << hand.x() << " z " << hand.z() - top << " f " << state.force_W.transpose() << " proxy "
            << (state.proxy_W.p - Vec3(0, 0, top)).transpose() << " contacts " << state.contacts << " yielded " << state.soft.yielded_W.transpose() << " through " << touch.body()->shape().throughItself_u
            << " strain " << touch.body()->shape().mostGradient << "\n";
          trace += o.str();
        }
        none += into && state.force_W.norm() < 1e-9;
        inward += into && state.force_W.z() < -1e-9;
        if (i % (ticks / 12) == 0)
        {
          std::ostringstream o;
          o << "    x " << hand.x() << " z " << hand.z() - top << " f " << state.force_W.transpose() << " proxy "
            << (state.proxy_W.p - Vec3(0, 0, top)).transpose() << " contacts " << state.contacts << "\n";
          trace += o.str();
        }
      }
      std::cout << (model == ElasticModel::Linear ? "linear " : "neo ") << young_Pa << " r " << radius_u << " deep " << deep_m << " rate " << rate_Hz
                << ": none " << none << " inward " << inward << " through " << through << " of " << ticks << std::endl;
      if (none + inward > 0) std::cout << trace << std::flush;
    }
  }
}

} // namespace
} // namespace palpate::test
