// SPDX-License-Identifier: GPL-3.0-or-later
// Row 9: shots at a sheet without thickness.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "testing/lab/Experiments.h"
#include "testing/lab/methods/FaceTree.h"
#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"
#include "testing/support/Shots.h"

namespace palpate::lab
{
namespace tunnelling_experiment
{

constexpr double period_s = 1e-3;

std::string text(const char* format, double a, double b)
{
  char line[64];
  std::snprintf(line, sizeof line, format, a, b);
  return line;
}

/// Random shots up to 10 m/s through faces, edges and vertices, from both sides; each goes on for a second tick.
/// `done` of the experiment's progress lies behind.
void runShots(const Conditions& conditions, bool bumpy, double r, double done, Table& table)
{
  test::Random random(conditions.seed + 61);
  const TriangleMesh mesh = test::makeTarget(bumpy, random);
  const auto scene = test::sceneOf(mesh);
  test::PathChecker checker(mesh, r, 1e-12); // exact arithmetic; touching with the centre is crossing
  const int count = conditions.pick(1000, 250000, 1000000);
  int held = 0, crossings = 0;
  for (int i = 0; i < count; ++i)
  {
    const test::Shot way = test::makeShot(mesh, r + 1.1e-3, random);
    test::Probe probe(scene, r, way.from_W, &checker);
    held += probe.to(way.to_W).contacts > 0;
    probe.to(way.to_W + random.inCube(5e-3));
    crossings += !probe.finding().empty();
    if (i % 1000 == 0)
    {
      conditions.progress(done + 0.25 * i / count);
    }
  }
  const std::string caseName = std::string("sheet=") + (bumpy ? "bumpy" : "flat");
  const std::string name = r > 0 ? "god-object r=1mm" : "god-object r=0";
  table.within(
    { caseName, name, "ways that cross, or come nearer than the radius - 1e-12 m", "" }, crossings, 0.0, 0.0);
  table.atLeast({ caseName, name, "share of shots that meet the sheet", "" }, static_cast<double>(held) / count, 0.5);
}

/// A ball that is looked at once a tick.
struct DiscreteTest
{
  double radius_m, thickness_m;

  [[nodiscard]] bool overlaps(const FaceTree& faces, const Vec3& p_W) const
  {
    const Face face = faces.nearest(p_W);
    const bool inside = this->thickness_m > 0 && face.normal_W.dot(p_W - face.point_W) < 0;
    return inside || (p_W - face.point_W).norm() <= this->radius_m;
  }

  /// Of `phases` segments straight down at this speed, the share that is never seen.
  [[nodiscard]] double missed(const FaceTree& faces, double speed_m_per_s, int phases) const
  {
    const double step_m = speed_m_per_s * period_s, top_m = 2 * this->radius_m + this->thickness_m + step_m;
    int missed = 0;
    for (int phase = 0; phase < phases; ++phase)
    {
      bool seen = false;
      for (double z = top_m + step_m * (phase + 0.5) / phases; z > -top_m && !seen; z -= step_m)
      {
        seen = this->overlaps(faces, { 0.011, 0.007, z });
      }
      missed += !seen;
    }
    return static_cast<double>(missed) / phases;
  }
};

/// A plate that is looked at once a tick is seen for certain up to (t + 2 r) / T and with that share of the speed
/// beyond.
void runDiscrete(const DiscreteTest& ball, Table& table)
{
  constexpr int phases = 400;
  test::Random random(1);
  const FaceTree faces(ball.thickness_m > 0 ? test::makeBox({ -0.05, -0.05, -ball.thickness_m }, { 0.05, 0.05, 0 })
                                            : test::makeSheet({ 0.1, 0.1, 1, 1, 0.0 }, random));
  const double certain_m_per_s = (ball.thickness_m + 2 * ball.radius_m) / period_s;
  for (const double share : { 0.5, 0.99, 1.01, 1.1, 2.0, 5.0 })
  {
    const double speed = certain_m_per_s > 0 ? share * certain_m_per_s : share;
    const std::string caseName = text("thickness=%gmm radius=%gmm", 1e3 * ball.thickness_m, 1e3 * ball.radius_m) +
                                 text(" speed=%gm/s", speed, 0.0);
    table.within({ caseName, "discrete-test", "share of ways that cross", "" }, ball.missed(faces, speed, phases),
      std::max(0.0, 1 - certain_m_per_s / speed), 1.5 / phases);
  }
}

} // namespace tunnelling_experiment

void runTunnelling(const Conditions& conditions, Table& table)
{
  using namespace tunnelling_experiment;
  double done = 0.0;
  for (const bool bumpy : { false, true })
  {
    for (const double r : { 0.0, 1e-3 })
    {
      runShots(conditions, bumpy, r, done, table);
      done += 0.25;
    }
  }
  for (const DiscreteTest& ball :
    { DiscreteTest{ 0.0, 0.0 }, DiscreteTest{ 1e-3, 0.0 }, DiscreteTest{ 0.0, 0.5e-3 }, DiscreteTest{ 1e-3, 0.5e-3 } })
  {
    runDiscrete(ball, table);
  }
}

} // namespace palpate::lab
