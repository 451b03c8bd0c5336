// SPDX-License-Identifier: GPL-3.0-or-later
// Row 75: a wire that bends far, at rest, against elliptic integrals and closed forms; linear beams fail beside it.
#include <cmath>
#include <numbers>

#include "haptics/tool/motion/Turn.h"
#include "testing/lab/Experiments.h"
#include "testing/oracles/elastica/Elastica.h"
#include "testing/oracles/elastica/SpatialRod.h"
#include "testing/support/WireScenes.h"

namespace palpate::lab
{
namespace wire_experiment
{

using test::WireRig;

/// Where the linearised wire has its tip.
Vec3 linearTip(const WireRig& rig)
{
  WireVector motion;
  (void)rig.newton->linearise(rig.wire, rig.places_W, rig.loads);
  rig.newton->step(motion);
  return rig.tip_W() + motion[rig.last()].head<3>();
}

void cantilevers(Table& table)
{
  for (const double load : { 1.0, 2.0, 5.0, 10.0 })
  {
    const test::CantileverTip truth = test::cantileverTip(load);
    double before = 1.0;
    for (const int beams : { 5, 10, 20, 40 })
    {
      WireRig rig = test::cantilever(beams, load);
      const double linear = linearTip(rig).y();
      rig.settle();
      const std::string name = caseName({ { "load", load }, { "beams", beams } });
      const double off = std::abs(rig.tip_W().y() - truth.across);
      if (beams == 20)
      {
        table.within({ name, "wire", "tip across over the length" }, rig.tip_W().y(), truth.across, 5e-4);
        table.within({ name, "wire", "tip nearer over the length" }, 1.0 - rig.tip_W().x(), truth.shorter, 5e-4);
        table.within({ name, "linear beam", "tip across over the length" }, linear, load / 3.0, 1e-6);
        table.atLeast({ name, "linear beam", "off by, over the length" }, linear - truth.across, 0.03);
      }
      // Of second order: a quarter each time.
      table.atMost({ name, "wire", "error over that of half the beams" }, off / before, 0.3);
      before = off;
    }
  }
}

void circles(Table& table)
{
  for (const int beams : { 8, 20, 64 })
  {
    const std::string name = caseName({ { "beams", beams } });
    table.atMost(
      { name, "wire", "gap of the circle over the length" }, test::rolledUp(beams, 1.0).tip_W().norm(), 5e-4);
    const Vec3 half(0.0, 1.0 / beams / std::sin(0.5 * std::numbers::pi / beams), 0.0);
    table.atMost({ name, "wire", "off half a circle of chords, over the length" },
      (test::rolledUp(beams, 0.5).tip_W() - half).norm(), 5e-4);
  }
  WireRig rig(test::straightPoints(20, 1.0), test::thinSection());
  rig.loads.held[0] = WireLoads::clamped;
  rig.loads.force[20][5] = 2.0 * std::numbers::pi;
  table.atLeast(
    { caseName({ { "beams", 20 } }), "linear beam", "gap of the circle over the length" }, linearTip(rig).norm(), 1.0);
}

void columns(Table& table)
{
  const double euler_N = test::PinnedColumn::euler_N();
  test::PinnedColumn column(20);
  const std::string name = caseName({ { "beams", 20 } });
  table.within({ name, "wire", "force at which it buckles", "N" }, column.buckles_N(), euler_N, 0.005 * euler_N);
  const double truth_N = euler_N * test::columnForce(0.04);
  table.within({ name, "wire", "force 4 % shorter", "N" }, column.bent_N(0.04), truth_N, 0.005 * truth_N);
  table.atLeast({ name, "linear beam", "force 4 % shorter over the truth" },
    0.04 * test::PinnedColumn::section().stretch_N / truth_N, 1e3);
}

void bends(Table& table)
{
  const BeamSection section = test::BathesBend::section();
  test::SpatialRod rod;
  rod.length = test::BathesBend::radius * test::BathesBend::angle_rad;
  rod.curvature = 1.0 / test::BathesBend::radius;
  rod.stretch = { section.stretch_N, section.shear_N, section.shear_N };
  rod.bend = { section.twist_Nu2, section.bend_Nu2, section.bend_Nu2 };
  const Vec3 truth = rod.tip(test::BathesBend::force * Vec3::UnitZ());
  const Vec3 published(47.23, 15.79, 53.37); // Simo & Vu-Quoc (1986), the clamped tangent first
  const char* axes[] = { "tip along its clamp", "tip across its clamp", "tip along the force" };
  for (const int beams : { 8, 16, 32 })
  {
    const Vec3 tip = test::BathesBend::tip(beams);
    const std::string name = caseName({ { "beams", beams } });
    for (int i = 0; i < 3; ++i)
    {
      table.within({ name, "wire", axes[i] }, tip[i], truth[i], 0.01 * truth[i]);
      table.within({ name, "wire against the published", axes[i] }, tip[i], published[i], 0.01 * published[i]);
    }
  }
}

void springs(Table& table)
{
  for (const int beams : { 16, 32, 64 })
  {
    const std::string name = caseName({ { "beams", beams }, { "turns", 2 } });
    const double stiff = test::springOverTextbook(beams, 2);
    const Subject subject{ name, "wire", "stiffness over the textbook's" };
    beams == 64 ? table.within(subject, stiff, 1.0, 0.02) : table.info(subject, stiff);
  }
}

/// Torque at the far end over that at the near one, which is turned by 1 radian.
double torqueThrough(double angle_rad)
{
  constexpr int beams = 20;
  WireRig rig(test::straightPoints(beams, 1.0), test::thinSection());
  if (angle_rad > 0.0)
  {
    rig.places_W = placesAlong(test::arcPoints(beams, 1.0 / angle_rad, angle_rad));
  }
  rig.loads.held.fill(WireLoads::place);
  rig.loads.held[0] = rig.loads.held[beams] = WireLoads::clamped;
  const Vec3 in = rig.places_W[0].q * Vec3::UnitX(), out = rig.places_W[beams].q * Vec3::UnitX();
  rig.places_W[0].q = turnBy(in) * rig.places_W[0].q;
  rig.settle();
  return -rig.newton->held(beams).tail<3>().dot(out) / rig.newton->held(0).tail<3>().dot(in);
}

/// Whether a wire of length 1 with its own bend stays in a bend of the tube, turned by half a turn from where it fits.
bool staysTurned(double own, double tube)
{
  constexpr int beams = 40;
  WireRig rig(test::arcPoints(beams, 1.0 / own, own), test::thinSection());
  rig.places_W = placesAlong(test::arcPoints(beams, 1.0 / tube, tube));
  for (Pose& pose : rig.places_W)
  {
    pose.q = turnBy(std::numbers::pi * (pose.q * Vec3::UnitX())) * pose.q;
  }
  rig.loads.held.fill(WireLoads::place);
  rig.loads.held[0] = WireLoads::clamped;
  rig.settle(); // in its plane
  return rig.newton->firm();
}

void turns(Table& table)
{
  table.within(
    { caseName({ { "bend_rad", 0.0 } }), "wire in a tube", "torque out over in" }, torqueThrough(0.0), 1.0, 1e-9);
  for (const double angle_rad : { 0.5, 1.0, 2.0 })
  {
    table.within({ caseName({ { "bend_rad", angle_rad } }), "wire in a tube", "torque out over in" },
      torqueThrough(angle_rad), 1.0, 0.005);
  }
  // With equal stiffness against bending and twist a tip of length 1 jumps where the root of both bends passes pi / 2.
  const double tube = 1.5;
  double low = 0.5, high = 4.0;
  for (int i = 0; i < 40; ++i)
  {
    const double own = 0.5 * (low + high);
    (staysTurned(own, tube) ? low : high) = own;
  }
  const double truth = 0.5 * std::numbers::pi;
  table.within({ caseName({ { "bend_rad", tube } }), "bent tip that is turned in a tube", "length at which it jumps" },
    std::sqrt(low * tube), truth, 0.02 * truth);
}

} // namespace wire_experiment

void runWire(const Conditions&, Table& table)
{
  using namespace wire_experiment;
  cantilevers(table);
  circles(table);
  columns(table);
  bends(table);
  springs(table);
  turns(table);
}

} // namespace palpate::lab
