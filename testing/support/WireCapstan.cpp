// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/WireCapstan.h"

#include <cmath>
#include <numbers>

#include "haptics/compliance/wire/WireCompliance.h"
#include "testing/support/WireScenes.h"

namespace palpate::test
{
namespace
{

constexpr double slack_N = 1.0; // at the end that follows

/// Beams of length 1 round a drum of as many corners, with one more beam before the first; the drum is inside.
std::vector<Vec3> drumPoints(int bends)
{
  const double bend = std::numbers::pi / bends;
  std::vector<Vec3> points{ Vec3::Zero() };
  for (int i = 0; i <= bends; ++i)
  {
    points.push_back(points.back() + Vec3(std::cos(bend * i), -std::sin(bend * i), 0.0));
  }
  return points;
}

/// Each corner of the drum touches the node that is on it.
std::vector<WireTouch> cornersOf(int bends)
{
  std::vector<WireTouch> touches;
  for (int i = 0; i < bends; ++i)
  {
    const double middle = std::numbers::pi / bends * (i + 0.5);
    const Vec3 along(std::cos(middle), -std::sin(middle), 0.0), outward(std::sin(middle), std::cos(middle), 0.0);
    touches.push_back({ i, 1.0, Vec3::Zero(), (Mat3() << outward, along, Vec3::UnitZ()).finished() });
  }
  return touches;
}

} // namespace

double capstanRatio(double friction, int bends)
{
  // Stretching is so stiff that sliding does not move the corners; bending is so soft that it does nothing.
  BeamSection section;
  section.stretch_N = 1e8 * slack_N;
  section.bend_Nu2 = 1e-9 * slack_N;
  section.twist_Nu2 = 1e-9 * slack_N;
  const std::vector<Vec3> points = drumPoints(bends);
  WireRig rig(points, section);
  const int last = rig.last();
  for (int i = 0; i < last; ++i)
  {
    rig.wire.beams[i].length_u /= 1.0 + slack_N / section.stretch_N; // taut all along
  }
  rig.loads.force[0].head<3>() = -slack_N * Vec3::UnitX();
  rig.loads.held[last] = WireLoads::clamped;
  // The largest tension would stretch all beams by less than this way, so that all corners slide.
  const double most_N = slack_N * std::exp(std::numbers::pi * friction);
  rig.places_W[last].p += 1.1 * last * most_N / section.stretch_N * (points[last] - points[last - 1]);
  const std::vector<WireTouch> touches = cornersOf(bends);
  const auto problem = std::make_unique<ContactProblem>();
  const auto room = std::make_unique<FrictionScratch>();
  const auto forces = std::make_unique<ContactForces>();
  problem->resize(bends);
  problem->friction = friction;
  forces->force_N = ContactProblem::Numbers::Zero(3 * bends);
  WireVector motion, pressed;
  constexpr int steps = 12; // of Newton, within one tick
  for (int step = 0; step < steps; ++step)
  {
    (void)rig.newton->linearise(rig.wire, rig.places_W, rig.loads);
    rig.newton->step(motion);
    problem->compliance.setZero();
    rig.newton->factor().invert();
    addWireCompliance(rig.newton->factor(), touches, problem->compliance);
    for (int i = 0; i < bends; ++i)
    {
      const Vec3 gone = touches[i].axes_W.transpose() * (rig.places_W[i + 1].p - points[i + 1]);
      problem->free.segment<3>(3 * i) = gone + motionAt(touches[i], motion);
    }
    solveFriction(*problem, *room, *forces);
    pressed.fill(NodeVector::Zero());
    for (int i = 0; i < bends; ++i)
    {
      pressAt(touches[i], forces->force_N.segment<3>(3 * i), pressed);
    }
    rig.newton->step(pressed, motion);
    moveWire(rig.wire, motion, rig.places_W);
  }
  (void)rig.newton->linearise(rig.wire, rig.places_W, rig.loads);
  return rig.newton->held(last).head<3>().norm() / slack_N;
}

} // namespace palpate::test
