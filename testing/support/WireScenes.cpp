// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/WireScenes.h"

#include <cmath>
#include <numbers>

#include "haptics/compliance/wire/WireShape.h"

namespace palpate::test
{

WireRig::WireRig(std::span<const Vec3> points_W, const BeamSection& section)
  : wire(makeWire(points_W, { &section, 1 }).value), places_W(placesAlong(points_W))
{
}

bool WireRig::settle(int mostSteps)
{
  const WireBeam& beam = this->wire.beams[0];
  const double tolerance_N = 1e-10 * beam.section.bend_Nu2 / (beam.length_u * beam.length_u);
  WireRest rest = this->newton->toRest(this->wire, this->loads, mostSteps, tolerance_N, this->places_W);
  // Where stretching is stiff, rounding of places alone leaves more than that.
  const double rounding_N = 1e-13 * beam.section.stretch_N;
  return rest.met || rest.residual_N <= rounding_N;
}

std::vector<Vec3> straightPoints(int beams, double length)
{
  return pointsOf({ length, beams }).value;
}

std::vector<Vec3> arcPoints(int beams, double radius, double angle_rad)
{
  std::vector<Vec3> points;
  for (int i = 0; i <= beams; ++i)
  {
    const double a = angle_rad * i / beams;
    points.push_back(radius * Vec3(std::sin(a), 1.0 - std::cos(a), 0.0));
  }
  return points;
}

BeamSection thinSection()
{
  BeamSection section;
  section.stretch_N = 1e7;
  section.bend_Nu2 = 1.0;
  section.twist_Nu2 = 1.0;
  return section;
}

WireRig cantilever(int beams, double load)
{
  WireRig rig(straightPoints(beams, 1.0), thinSection());
  rig.loads.held[0] = WireLoads::clamped;
  rig.loads.force[beams][1] = load;
  return rig;
}

WireRig rolledUp(int beams, double share)
{
  WireRig rig(straightPoints(beams, 1.0), thinSection());
  rig.loads.held.fill(0b011100); // to its plane: a moment about a fixed axis is not conservative out of it
  rig.loads.held[0] = WireLoads::clamped;
  constexpr int parts = 8;
  for (int part = 1; part <= parts; ++part)
  {
    rig.loads.force[beams][5] = 2.0 * std::numbers::pi * share * part / parts;
    rig.settle();
  }
  return rig;
}

BeamSection PinnedColumn::section()
{
  BeamSection section = roundSection(0.25, 60e3, 0.3);
  section.shear_N = std::numeric_limits<double>::infinity();
  return section;
}

double PinnedColumn::euler_N()
{
  return std::numbers::pi * std::numbers::pi * section().bend_Nu2 / (length_mm * length_mm);
}

PinnedColumn::PinnedColumn(int beams) : rig_(straightPoints(beams, length_mm), section())
{
  rig_.loads.held[0] = 0b001111; // the place, and the turn along it
  rig_.loads.held[beams] = WireLoads::place;
}

double PinnedColumn::buckles_N()
{
  double low_mm = 0.0, high_mm = 1e-4 * length_mm;
  const WirePlaces straight_W = this->rig_.places_W;
  WirePlaces shorter_W = straight_W;
  for (int i = 0; i < 60; ++i)
  {
    const double middle_mm = 0.5 * (low_mm + high_mm);
    for (int node = 0; node <= this->rig_.last(); ++node)
    {
      shorter_W[node].p = (1.0 - middle_mm / length_mm) * straight_W[node].p;
    }
    (void)this->rig_.newton->linearise(this->rig_.wire, shorter_W, this->rig_.loads);
    (this->rig_.newton->firm() ? low_mm : high_mm) = middle_mm;
  }
  return section().stretch_N * low_mm / length_mm;
}

double PinnedColumn::bent_N(double shortening)
{
  WireRig& rig = this->rig_;
  const int middle = rig.last() / 2;
  constexpr int parts = 20;
  rig.loads.force[middle][1] = 0.1 * euler_N();
  for (int part = 1; part <= parts; ++part)
  {
    rig.places_W[rig.last()].p.x() = length_mm * (1.0 - shortening * part / parts);
    rig.settle();
    rig.loads.force[middle][1] = 0.0;
  }
  rig.settle();
  return std::abs(rig.newton->held(rig.last())[0]);
}

BeamSection BathesBend::section()
{
  constexpr double young = 1e7, shear = 0.5 * young;
  return { young, 5.0 / 6.0 * shear, young / 12.0, shear / 6.0 };
}

Vec3 BathesBend::tip(int beams)
{
  WireRig rig(arcPoints(beams, BathesBend::radius, BathesBend::angle_rad), BathesBend::section());
  rig.loads.held[0] = WireLoads::clamped;
  constexpr int parts = 6;
  for (int part = 1; part <= parts; ++part)
  {
    rig.loads.force[beams][2] = BathesBend::force * part / parts;
    rig.settle();
  }
  return rig.tip_W();
}

double springOverTextbook(int beams, int turns)
{
  constexpr double wire_mm = 1.0, coil_mm = 20.0, pitch_mm = 2.0, young = 200e3, poisson = 0.3;
  const double turn_mm = std::hypot(std::numbers::pi * coil_mm, pitch_mm);
  const auto points = pointsOf({ turns * turn_mm, beams, WireTip::Helix, turns * turn_mm, 0.5 * coil_mm, pitch_mm });
  WireRig rig(points.value, roundSection(0.5 * wire_mm, young, poisson));
  // In the frame of its start the helix' axis is at the radius along y, and tilted by the angle of its pitch.
  const double rise_mm = pitch_mm / (2.0 * std::numbers::pi);
  const Vec3 axis = Vec3(rise_mm, 0.0, 0.5 * coil_mm).normalized();
  const Vec3 middle(0.0, 0.5 * coil_mm, 0.0);
  const Vec3 onAxis = middle + axis * axis.dot(rig.tip_W() - middle);
  const double shear = 0.5 * young / (1.0 + poisson);
  const double textbook = shear * std::pow(wire_mm, 4) / (8.0 * std::pow(coil_mm, 3) * turns);
  const double force_N = 1e-4 * textbook * pitch_mm;
  const Vec3 arm = onAxis - rig.tip_W();
  rig.loads.held[0] = WireLoads::clamped;
  rig.loads.force[beams] << force_N * axis, force_N * arm.cross(axis);
  const Pose before = rig.places_W[beams];
  rig.settle();
  const Pose& after = rig.places_W[beams];
  const Vec3 carried = after.p + after.q * (before.q.conjugate() * arm);
  return force_N / (carried - onAxis).dot(axis) / textbook;
}

} // namespace palpate::test
